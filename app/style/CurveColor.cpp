#include "app/style/CurveColor.h"

#include "app/style/Theme.h"

#include "core/picture/ColorMap.h"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {

/// OKLab lightness of the colors of the palette (core/picture/ColorMap.cpp), and where they go.
struct LightnessRange {
  float low, high;
};
constexpr LightnessRange kOfPalette{0.41f, 0.94f}, kOnDark{0.57f, 0.94f}, kOnLight{0.43f, 0.63f};

// OKLab (B. Ottosson, 2020): cone responses of linear Rec. 709, and lightness and colors of their cube roots.
// By columns.
constexpr glm::mat3 kConesOfRgb(0.4122214708f, 0.2119034982f, 0.0883024619f, 0.5363325363f, 0.6806995451f,
                                0.2817188376f, 0.0514459929f, 0.1073969566f, 0.6299787005f);
constexpr glm::mat3 kLabOfRoots(0.2104542553f, 1.9779984951f, 0.0259040371f, 0.7936177850f, -2.4285922050f,
                                0.7827717662f, -0.0040720468f, 0.4505937099f, -0.8086757660f);

glm::vec3 linearOf(const QColor& color) {
  return {srgbDecoded(static_cast<float>(color.redF())), srgbDecoded(static_cast<float>(color.greenF())),
          srgbDecoded(static_cast<float>(color.blueF()))};
}

glm::vec3 labOf(const glm::vec3& linear) {
  const glm::vec3 cones = kConesOfRgb * linear;
  return kLabOfRoots * glm::vec3(std::cbrt(cones.x), std::cbrt(cones.y), std::cbrt(cones.z));
}

glm::vec3 linearOfLab(const glm::vec3& lab) {
  const glm::vec3 roots = glm::inverse(kLabOfRoots) * lab;
  return glm::clamp(glm::inverse(kConesOfRgb) * (roots * roots * roots), 0.0f, 1.0f);
}

double luminanceOf(const QColor& color) {
  const glm::vec3 linear = linearOf(color);
  return 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z;
}

} // namespace

QColor onPanel(const QColor& color, const ThemeColors& colors) {
  const LightnessRange& to = colors.panel.lightness() < 128 ? kOnDark : kOnLight;
  glm::vec3 lab = labOf(linearOf(color));
  const float place = std::clamp((lab.x - kOfPalette.low) / (kOfPalette.high - kOfPalette.low), 0.0f, 1.0f);
  lab.x = to.low + place * (to.high - to.low);
  const glm::vec3 linear = linearOfLab(lab);
  return QColor::fromRgbF(srgbEncoded(linear.x), srgbEncoded(linear.y), srgbEncoded(linear.z),
                          static_cast<float>(color.alphaF()));
}

double contrastOf(const QColor& a, const QColor& b) {
  const double first = luminanceOf(a), second = luminanceOf(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

} // namespace taa::app
