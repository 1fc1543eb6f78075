#include "app/style/FlatStyle.h"

#include "app/style/Theme.h"

#include <QPainter>
#include <QPen>
#include <QPointF>
#include <QStyleFactory>
#include <QStyleOption>

namespace taa::app {

namespace {

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

} // namespace

FlatStyle::FlatStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void FlatStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                   QPainter* painter, const QWidget* widget) const {
  if (control != CC_ComboBox && control != CC_SpinBox)
    return QProxyStyle::drawComplexControl(control, option, painter, widget);
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
  if (control == CC_ComboBox) return draw(SC_ComboBoxArrow, true);
  draw(SC_SpinBoxUp, false);
  draw(SC_SpinBoxDown, true);
}

} // namespace taa::app
