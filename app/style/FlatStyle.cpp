#include "app/style/FlatStyle.h"

#include "app/style/Theme.h"

#include <QListView>
#include <QPainter>
#include <QPen>
#include <QPointF>
#include <QStyleFactory>
#include <QStyleOption>

#include <algorithm>

namespace taa::app {

namespace {

constexpr int kCheckBox = 14;                             ///< px
constexpr double kChevronWide = 3.5, kChevronHigh = 1.75; ///< px from its middle

/// Points down, or up.
void drawChevron(QPainter* painter, const QRect& box, bool isDown, const QColor& color) {
  const double wide = scaled(kChevronWide), high = scaled(isDown ? kChevronHigh : -kChevronHigh);
  const QPointF middle = QRectF(box).center();
  const QPointF points[] = {middle + QPointF(-wide, -high), middle + QPointF(0, high),
                            middle + QPointF(wide, -high)};
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(color, 1.25));
  painter->drawPolyline(points, 3);
  painter->setRenderHint(QPainter::Antialiasing, false);
}

/// A line, in the accent's color up to the handle.
void drawSlider(QPainter* painter, const QStyleOptionComplex& option, QRect groove, QRect handle) {
  const ThemeColors& colors = themeColors(option.palette);
  const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
  const bool isFocused = option.state.testFlag(QStyle::State_HasFocus);
  const bool isFlat = option.state.testFlag(QStyle::State_Horizontal);
  const QPoint middle = handle.center();
  const QRect line = isFlat ? QRect(groove.left(), middle.y() - 1, groove.width(), 3)
                            : QRect(middle.x() - 1, groove.top(), 3, groove.height());
  painter->fillRect(line, colors.line);
  if (isFlat && isEnabled)
    painter->fillRect(QRect(line.topLeft(), QPoint(middle.x(), line.bottom())), colors.accent);
  const double radius = std::min(handle.width(), handle.height()) / 2.0 - 1.0;
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(isFocused ? colors.accent : colors.secondary);
  painter->setBrush(isEnabled ? (isFocused ? colors.accent : colors.text) : colors.panel);
  painter->drawEllipse(QRectF(handle).center(), radius, radius);
  painter->setRenderHint(QPainter::Antialiasing, false);
}

/// Its border is seen on every ground: unchecked ones have nothing else.
void drawCheckBox(QPainter* painter, const QStyleOption& option) {
  const ThemeColors& colors = themeColors(option.palette);
  const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
  const QRect box = option.rect.adjusted(0, 0, -1, -1);
  painter->setPen(option.state.testFlag(QStyle::State_HasFocus) ? colors.accent : colors.secondary);
  painter->setBrush(isEnabled ? colors.field : colors.panel);
  painter->drawRect(box);
  const double side = std::min(box.width(), box.height()) / 12.0;
  const QPointF middle = QRectF(option.rect).center();
  painter->setPen(QPen(isEnabled ? colors.text : colors.secondary, 1.75 * side, Qt::SolidLine, Qt::RoundCap));
  painter->setRenderHint(QPainter::Antialiasing);
  if (option.state.testFlag(QStyle::State_On)) {
    const QPointF mark[] = {middle + side * QPointF(-3, 0.25), middle + side * QPointF(-0.75, 2.5),
                            middle + side * QPointF(3.25, -2.75)};
    painter->drawPolyline(mark, 3);
  } else if (option.state.testFlag(QStyle::State_NoChange)) {
    painter->drawLine(middle - QPointF(3 * side, 0), middle + QPointF(3 * side, 0));
  }
  painter->setRenderHint(QPainter::Antialiasing, false);
}

} // namespace

FlatStyle::FlatStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

// A list that was filled before it had its style has places of rows that are lower: it finds them anew.
void FlatStyle::polish(QWidget* widget) {
  QProxyStyle::polish(widget);
  if (auto* list = qobject_cast<QListView*>(widget)) list->setResizeMode(QListView::Adjust);
}

// Boxes grow with the words beside them.
int FlatStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  if (metric == PM_IndicatorWidth || metric == PM_IndicatorHeight) return scaled(kCheckBox);
  return QProxyStyle::pixelMetric(metric, option, widget);
}

// The style sheet adds its padding to this: lines are broken in what that leaves of their list.
QSize FlatStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                  const QWidget* widget) const {
  const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(option);
  if (type != CT_ItemViewItem || !item || !qobject_cast<const QListView*>(widget))
    return QProxyStyle::sizeFromContents(type, option, size, widget);
  QStyleOptionViewItem padded(*item);
  padded.rect.setWidth(std::max(item->rect.width() - 2 * kListPadding, 0));
  return QProxyStyle::sizeFromContents(type, &padded, size, widget);
}

void FlatStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  if (element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck) {
    drawCheckBox(painter, *option);
    return;
  }
  if (element == PE_IndicatorArrowDown || element == PE_IndicatorArrowUp) {
    drawChevron(painter, option->rect, element == PE_IndicatorArrowDown,
                themeColors(option->palette).secondary);
    return;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void FlatStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                   QPainter* painter, const QWidget* widget) const {
  if (control == CC_Slider) {
    drawSlider(painter, *option, subControlRect(control, option, SC_SliderGroove, widget),
               subControlRect(control, option, SC_SliderHandle, widget));
    return;
  }
  if (control != CC_ComboBox && control != CC_SpinBox) {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    return;
  }
  const ThemeColors& colors = themeColors(option->palette);
  const bool isEnabled = option->state.testFlag(State_Enabled);
  const bool isHovered = isEnabled && control == CC_ComboBox && option->state.testFlag(State_MouseOver);
  const bool isFocused = option->state.testFlag(State_HasFocus);
  painter->fillRect(option->rect, !isEnabled ? colors.panel : isHovered ? colors.hover : colors.field);
  painter->setPen(isFocused ? colors.accent : colors.line);
  painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
  const auto draw = [&](SubControl part, bool isDown) {
    if (!option->subControls.testFlag(part)) return;
    const QRect box = subControlRect(control, option, part, widget);
    if (control == CC_SpinBox && isEnabled && option->activeSubControls == part)
      painter->fillRect(box, colors.hover);
    drawChevron(painter, box, isDown, colors.secondary);
  };
  if (control == CC_ComboBox) {
    draw(SC_ComboBoxArrow, true);
    return;
  }
  draw(SC_SpinBoxUp, false);
  draw(SC_SpinBoxDown, true);
}

} // namespace taa::app
