#include "app/figures/Figure.h"

#include "app/style/PaintedAsFigure.h"
#include "app/style/Theme.h"

#include <QBuffer>
#include <QFontMetrics>
#include <QPainter>
#include <QRegion>
#include <QSvgGenerator>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <vector>

namespace taa::app {

namespace {

constexpr int kFigureMargin = 3 * kUnit; ///< px around all, and between parts
constexpr int kLeastCaption = 320;       ///< px that a caption's line may take beside a narrow figure

/// Where things are on the whole figure.
struct FigurePlan {
  QSize size;
  QRect content, caption;
};

FigurePlan planOf(const FigureContent& content, const QString& caption) {
  const int width = std::max(content.size.width(), scaled(kLeastCaption));
  const QRect words =
      QFontMetrics(secondaryFont()).boundingRect(QRect(0, 0, width, 1 << 15), Qt::TextWordWrap, caption);
  FigurePlan plan;
  plan.content = QRect(QPoint(kFigureMargin, kFigureMargin), content.size);
  plan.caption = QRect(kFigureMargin, plan.content.bottom() + 1 + kFigureMargin, width, words.height());
  plan.size = QSize(width + 2 * kFigureMargin, plan.caption.bottom() + 1 + kFigureMargin);
  return plan;
}

void paintFigure(QPainter& painter, const FigureContent& content, const QString& caption,
                 const FigurePlan& plan, const ThemeColors& colors) {
  painter.fillRect(QRect(QPoint(), plan.size), colors.panel);
  painter.save();
  painter.translate(plan.content.topLeft());
  content.paint(painter);
  painter.restore();
  painter.setFont(secondaryFont());
  painter.setPen(colors.text);
  painter.drawText(plan.caption, Qt::TextWordWrap, caption);
}

} // namespace

QRect shownPart(QWidget& widget) {
  const PaintedAsFigure mode(widget);
  QImage picture(widget.size(), QImage::Format_RGB32);
  picture.fill(themeColors(&widget).panel);
  widget.render(&picture, QPoint(), QRegion(), QWidget::DrawChildren);
  const QRgb ground = picture.isNull() ? 0 : picture.pixel(0, 0);
  QRect shown;
  for (int y = 0; y < picture.height(); ++y) {
    const auto* line = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
    const auto isShown = [ground](QRgb pixel) { return pixel != ground; };
    const auto* first = std::find_if(line, line + picture.width(), isShown);
    if (first == line + picture.width()) continue;
    const auto* last = line + picture.width() - 1;
    while (!isShown(*last)) --last;
    shown |= QRect(QPoint(static_cast<int>(first - line), y), QPoint(static_cast<int>(last - line), y));
  }
  return shown.isNull() ? widget.rect() : shown.adjusted(-kUnit, -kUnit, kUnit, kUnit) & widget.rect();
}

FigureContent widgetsContent(const QList<QWidget*>& widgets, Qt::Orientation orientation,
                             const QString& details) {
  struct Part {
    QWidget* widget;
    QRect shown;
    QPoint place;
  };
  std::vector<Part> parts;
  QRect all;
  for (QWidget* widget : widgets) {
    const QRect shown = shownPart(*widget);
    const QPoint place = parts.empty()                   ? QPoint()
                         : orientation == Qt::Horizontal ? QPoint(all.right() + 1 + kFigureMargin, 0)
                                                         : QPoint(0, all.bottom() + 1 + kFigureMargin);
    parts.push_back({widget, shown, place});
    all |= QRect(place, shown.size());
  }
  const auto paint = [parts](QPainter& painter) {
    for (const Part& part : parts) {
      const PaintedAsFigure mode(*part.widget);
      part.widget->render(&painter, part.place, QRegion(part.shown), QWidget::DrawChildren);
    }
  };
  return {all.size(), paint, details};
}

QImage figurePicture(const FigureContent& content, const QString& caption, const QWidget& styled) {
  const FigurePlan plan = planOf(content, caption);
  const QSize size(static_cast<int>(std::ceil(plan.size.width() * content.pixelRatio)),
                   static_cast<int>(std::ceil(plan.size.height() * content.pixelRatio)));
  QImage picture(size, QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(content.pixelRatio);
  picture.fill(themeColors(&styled).panel);
  QPainter painter(&picture);
  paintFigure(painter, content, caption, plan, themeColors(&styled));
  painter.end();
  return picture.convertToFormat(QImage::Format_RGBA8888);
}

QByteArray figureSvg(const FigureContent& content, const QString& title, const QString& caption,
                     const QWidget& styled) {
  const FigurePlan plan = planOf(content, caption);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setSize(plan.size);
  svg.setViewBox(QRect(QPoint(), plan.size));
  svg.setResolution(styled.logicalDpiX()); // else points are of another size than on the screen
  svg.setTitle(title);
  svg.setDescription(caption);
  QPainter painter(&svg);
  paintFigure(painter, content, caption, plan, themeColors(&styled));
  painter.end();
  return bytes;
}

} // namespace taa::app
