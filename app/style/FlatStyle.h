// Fusion with flat lists to choose from, numbers to count up, sliders, check boxes and arrows: as the fields
// and buttons of the style sheet, which has no way to color an arrow.
#pragma once

#include <QProxyStyle>

namespace taa::app {

class FlatStyle : public QProxyStyle {
 public:
  FlatStyle();

  using QProxyStyle::polish;
  void polish(QWidget* widget) override;
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
};

} // namespace taa::app
