#include "tests/app/PaintedTexts.h"

#include "app/widgets/bars/ElidedLabel.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QScrollBar>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace taa::app::test {

namespace {

constexpr QChar kDots(0x2026);

class TextEngine : public QPaintEngine {
 public:
  explicit TextEngine(std::vector<PaintedText>& texts) : QPaintEngine(AllFeatures), texts_(texts) {}

  bool begin(QPaintDevice*) override { return true; }
  bool end() override { return true; }
  void updateState(const QPaintEngineState&) override {}
  void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
  void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {}
  void drawPath(const QPainterPath&) override {}
  void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
  Type type() const override { return User; }
  void drawTextItem(const QPointF& at, const QTextItem& item) override {
    const QTransform& toDevice = state->transform();
    const QRectF place(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent());
    QRectF visible(systemClip().isEmpty() ? QRectF(0, 0, 1e6, 1e6) : QRectF(systemClip().boundingRect()));
    if (painter()->hasClipping()) visible &= toDevice.mapRect(painter()->clipBoundingRect());
    texts_.push_back({item.text(), toDevice.mapRect(place), visible});
  }

 private:
  std::vector<PaintedText>& texts_;
};

/// As large as a widget, and with its letters.
class TextDevice : public QPaintDevice {
 public:
  explicit TextDevice(const QWidget& widget) : widget_(widget), engine_(texts) {}

  std::vector<PaintedText> texts;

  QPaintEngine* paintEngine() const override { return &engine_; }

 protected:
  int metric(PaintDeviceMetric metric) const override {
    switch (metric) {
    case PdmWidth:
      return widget_.width();
    case PdmHeight:
      return widget_.height();
    case PdmDpiX:
    case PdmPhysicalDpiX:
      return widget_.logicalDpiX();
    case PdmDpiY:
    case PdmPhysicalDpiY:
      return widget_.logicalDpiY();
    case PdmDevicePixelRatio:
      return 1;
    case PdmDevicePixelRatioScaled:
      return static_cast<int>(devicePixelRatioFScale());
    case PdmDepth:
      return 32;
    default:
      return QPaintDevice::metric(metric);
    }
  }

 private:
  const QWidget& widget_;
  mutable TextEngine engine_;
};

/// Texts that end in dots because something is asked then.
std::vector<QString> textsThatAsk(const QWidget& window) {
  std::vector<QString> texts;
  const auto add = [&](QString text) {
    if (text.endsWith(kDots)) texts.push_back(text.remove(QLatin1Char('&')));
  };
  for (const auto* label : window.findChildren<QLabel*>()) // which are not cut with dots
    if (!dynamic_cast<const ElidedLabel*>(label)) add(label->text());
  for (const auto* button : window.findChildren<QAbstractButton*>()) add(button->text());
  for (const auto* action : window.findChildren<QAction*>()) add(action->text());
  for (const auto* field : window.findChildren<QLineEdit*>()) add(field->placeholderText());
  return texts;
}

/// Where what is cut at a side can be scrolled to, px of the window.
std::vector<QRectF> scrolledSideways(const QWidget& window) {
  std::vector<QRectF> places;
  for (const auto* area : window.findChildren<QAbstractScrollArea*>())
    if (area->isVisible() && area->horizontalScrollBar()->maximum() > 0)
      places.emplace_back(QRect(area->mapTo(&window, QPoint()), area->size()));
  for (const auto* field : window.findChildren<QLineEdit*>())
    if (field->isVisible() && !field->isReadOnly())
      places.emplace_back(QRect(field->mapTo(&window, QPoint()), field->size()));
  return places;
}

} // namespace

bool isScrolled(const QWidget* widget) {
  for (const QWidget* at = widget->parentWidget(); at; at = at->parentWidget())
    if (qobject_cast<const QAbstractScrollArea*>(at)) return true;
  return false;
}

std::vector<PaintedText> paintedTexts(QWidget& window) {
  TextDevice device(window);
  QPainter painter(&device);
  window.render(&painter);
  painter.end();
  return device.texts;
}

void expectWholeTexts(QWidget& window) {
  constexpr double kSlack = 2.0; // px; letters have some air
  const std::vector<QString> asking = textsThatAsk(window);
  const std::vector<QRectF> scrolled = scrolledSideways(window);
  for (const PaintedText& painted : paintedTexts(window)) {
    const QString text = painted.text.trimmed();
    const std::string shown = text.toStdString();
    if (text.isEmpty() || !painted.visible.intersects(painted.place)) continue;
    // A line below a letter makes two of a text.
    const bool asks = std::ranges::any_of(asking, [&](const QString& whole) { return whole.endsWith(text); });
    EXPECT_FALSE(text.endsWith(kDots) && text.size() > 1 && !asks) << shown << " is cut";
    const bool canScroll = std::ranges::any_of(
        scrolled, [&](const QRectF& area) { return area.intersects(painted.place & painted.visible); });
    if (canScroll) continue;
    EXPECT_LE(painted.place.right(), painted.visible.right() + 1.0 + kSlack) << shown;
    EXPECT_GE(painted.place.left(), painted.visible.left() - kSlack) << shown;
  }
  for (const auto* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->window() != &window || isScrolled(widget)) continue;
    const QRect place(widget->mapTo(&window, QPoint()), widget->size());
    EXPECT_TRUE(window.rect().contains(place) || place.isEmpty())
        << widget->metaObject()->className() << " " << widget->objectName().toStdString() << " at "
        << place.x() << ", " << place.y() << ", " << place.width() << "×" << place.height();
  }
}

} // namespace taa::app::test
