// Fusion with flat lists to choose from and numbers to count up: as the fields and buttons of the style
// sheet, which has no way to color an arrow.
#pragma once

#include <QProxyStyle>

namespace taa::app {

class FlatStyle : public QProxyStyle {
 public:
  FlatStyle();

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
};

} // namespace taa::app
