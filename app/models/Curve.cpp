#include "app/models/Curve.h"

#include "core/base/Light.h"
#include "core/picture/ColorMap.h"

#include <array>

namespace taa::app {

QColor curveColor(int place) {
  const std::array<float, 3> linear = categoryColor(place + 1); // number 0 stands for nothing elsewhere
  return QColor::fromRgbF(srgbEncoded(linear[0]), srgbEncoded(linear[1]), srgbEncoded(linear[2]));
}

} // namespace taa::app
