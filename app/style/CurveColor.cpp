#include "app/style/CurveColor.h"

#include "app/style/Theme.h"

#include "core/base/Light.h"
#include "core/picture/ColorMap.h"
#include "core/picture/OkLab.h"

#include <glm/vec3.hpp>

#include <algorithm>

namespace taa::app {

namespace {

/// Of OKLab.
struct LightnessRange {
  float low, high;
};
/// Where the colors of the palette go.
constexpr LightnessRange kOnDark{0.57f, 0.94f}, kOnLight{0.43f, 0.63f};

/// Of the palette, but for the number that stands for nothing.
LightnessRange paletteRange() {
  LightnessRange out{1.0f, 0.0f};
  for (int number = 1; number < kCategoryCount; ++number) {
    const auto [r, g, b] = categoryColor(number);
    const float lightness = okLabOf({r, g, b}).x;
    out = {std::min(out.low, lightness), std::max(out.high, lightness)};
  }
  return out;
}

glm::vec3 linearOf(const QColor& color) {
  return {srgbDecoded(static_cast<float>(color.redF())), srgbDecoded(static_cast<float>(color.greenF())),
          srgbDecoded(static_cast<float>(color.blueF()))};
}

double luminanceOf(const QColor& color) {
  return luminance(glm::dvec3(linearOf(color)));
}

} // namespace

QColor onPanel(const QColor& color, const ThemeColors& colors) {
  static const LightnessRange kOfPalette = paletteRange();
  const LightnessRange& to = colors.panel.lightness() < 128 ? kOnDark : kOnLight;
  glm::vec3 lab = okLabOf(linearOf(color));
  const float place = std::clamp((lab.x - kOfPalette.low) / (kOfPalette.high - kOfPalette.low), 0.0f, 1.0f);
  lab.x = to.low + place * (to.high - to.low);
  const glm::vec3 linear = linearOfOkLab(lab);
  return QColor::fromRgbF(srgbEncoded(linear.x), srgbEncoded(linear.y), srgbEncoded(linear.z),
                          static_cast<float>(color.alphaF()));
}

double contrastOf(const QColor& a, const QColor& b) {
  const double first = luminanceOf(a), second = luminanceOf(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

} // namespace taa::app
