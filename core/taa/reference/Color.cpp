// Color arithmetic of the CPU twin; order of operations as in the definition of the resolve.
#include "core/taa/reference/Color.h"

namespace taa::reference {
namespace {

constexpr float kLargestHalf = 65504.0f;

/// Least denominator of the inverse tone curve: caps the result at 10⁵ times the box color.
constexpr float kLeastToneDenominator = 1e-5f;

} // namespace

bool isBad(float value) {
  return !(value >= 0.0f && value <= kLargestHalf);
}

glm::vec3 sanitized(const glm::vec3& color) {
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = isBad(color[i]) ? 0.0f : color[i];
  return result;
}

float luma(const glm::vec3& color) {
  return (0.2126f * color.x + 0.7152f * color.y) + 0.0722f * color.z;
}

glm::vec3 toBox(const glm::vec3& color, const SpaceSettings& space) {
  const glm::vec3 c = space.tone == ToneSpace::ReinhardLuma ? color / (1.0f + luma(color)) : color;
  if (space.color == ColorSpace::Rgb) return c;
  const float y = (0.25f * c.x + 0.5f * c.y) + 0.25f * c.z;
  const float co = 0.5f * c.x - 0.5f * c.z;
  const float cg = (-0.25f * c.x + 0.5f * c.y) - 0.25f * c.z;
  return {y, co, cg};
}

glm::vec3 fromBox(const glm::vec3& box, const SpaceSettings& space) {
  glm::vec3 c = box;
  if (space.color == ColorSpace::YCoCg) {
    const float y = box[0];
    const float co = box[1];
    const float cg = box[2];
    c = {(y + co) - cg, y + cg, (y - co) - cg};
  }
  if (space.tone == ToneSpace::Linear) return c;
  float denominator = 1.0f - luma(c);
  if (!(denominator > kLeastToneDenominator)) denominator = kLeastToneDenominator;
  return c / denominator;
}

glm::vec3 smaller(const glm::vec3& a, const glm::vec3& b) {
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = a[i] < b[i] ? a[i] : b[i];
  return result;
}

glm::vec3 larger(const glm::vec3& a, const glm::vec3& b) {
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = a[i] > b[i] ? a[i] : b[i];
  return result;
}

glm::vec3 clamped(const glm::vec3& value, const glm::vec3& low, const glm::vec3& high) {
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) {
    result[i] = value[i] < low[i] ? low[i] : value[i] > high[i] ? high[i] : value[i];
  }
  return result;
}

glm::ivec2 clampedToPicture(const glm::ivec2& pixel, const Inputs& inputs) {
  const auto within = [](int value, int count) {
    return value < 0 ? 0 : value > count - 1 ? count - 1 : value;
  };
  return {within(pixel.x, inputs.width()), within(pixel.y, inputs.height())};
}

glm::vec3 currentColor(const Inputs& inputs, const glm::ivec2& pixel) {
  const glm::ivec2 p = clampedToPicture(pixel, inputs);
  return sanitized(glm::vec3(inputs.color.texel(p.x, p.y)));
}

} // namespace taa::reference
