#include "app/Icons.h"

#include "core/base/EmbeddedFiles.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

namespace taa::app {

namespace {

QByteArray iconText(const QString& name) {
  return QByteArray::fromStdString(embeddedText("resources/icons/" + name.toStdString() + ".svg"));
}

QByteArray colored(QByteArray svg, const QColor& color) {
  return svg.replace("currentColor", color.name().toLatin1());
}

/// Draws an SVG in the palette's color for each mode.
class SvgIconEngine : public QIconEngine {
 public:
  explicit SvgIconEngine(QByteArray svg) : svg_(std::move(svg)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::WindowText;
    QSvgRenderer(colored(svg_, QGuiApplication::palette().color(group, role))).render(painter, rect);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new SvgIconEngine(svg_); }

 private:
  QByteArray svg_;
};

} // namespace

QIcon themedIcon(const QString& name) {
  return QIcon(new SvgIconEngine(iconText(name)));
}

QPixmap iconPixmap(const QString& name, const QColor& color, int size, double pixelRatio) {
  QPixmap pixmap(QSize(size, size) * pixelRatio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  QSvgRenderer(colored(iconText(name), color)).render(&painter);
  painter.end();
  pixmap.setDevicePixelRatio(pixelRatio);
  return pixmap;
}

QIcon programIcon() {
  return themedIcon(QStringLiteral("taa-inspector"));
}

} // namespace taa::app
