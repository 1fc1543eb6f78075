#include "app/style/Icons.h"

#include "core/base/EmbeddedFiles.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace taa::app {

namespace {

QByteArray iconText(const QString& name) {
  return QByteArray::fromStdString(embeddedText("resources/icons/" + name.toStdString() + ".svg"));
}

QByteArray colored(QByteArray svg, const QColor& color) {
  return svg.replace("currentColor", color.name().toLatin1());
}

/// Draws an SVG in the palette's color for each mode. What it has drawn once is kept: reading an SVG takes
/// longer than everything else in the painting of a button.
class SvgIconEngine : public QIconEngine {
 public:
  explicit SvgIconEngine(const QString& name) : name_(name), svg_(iconText(name)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    QSvgRenderer(colored(svg_, colorOf(mode))).render(painter, rect);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    const QString key =
        QStringLiteral("%1 %2 %3x%4").arg(name_, colorOf(mode).name()).arg(size.width()).arg(size.height());
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) return pixmap;
    pixmap = QPixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    QPixmapCache::insert(key, pixmap);
    return pixmap;
  }

  QIconEngine* clone() const override { return new SvgIconEngine(name_); }

 private:
  static QColor colorOf(QIcon::Mode mode) {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    return QGuiApplication::palette().color(group, mode == QIcon::Selected ? QPalette::HighlightedText
                                                                           : QPalette::WindowText);
  }

  QString name_;
  QByteArray svg_;
};

} // namespace

QIcon themedIcon(const QString& name) {
  return QIcon(new SvgIconEngine(name));
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
