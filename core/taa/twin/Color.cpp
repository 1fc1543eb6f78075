// Color arithmetic of the CPU twin; order of operations as in the definition of the resolve.
#include "core/taa/twin/Color.h"

#include "core/base/Light.h"
#include "core/taa/twin/ToneCurves.h"

#include <array>
#include <cmath>

namespace taa::twin {
namespace {

constexpr float kLargestHalf = 65504.0f;

/// Least denominator of the inverse tone curve: caps the result at 10⁵ times the box color.
constexpr float kMinToneDenominator = 1e-5f;

float largestChannel(const glm::vec3& c) {
  const float redGreen = c.x > c.y ? c.x : c.y;
  return redGreen > c.z ? redGreen : c.z;
}

template <typename Curve>
glm::vec3 eachChannel(const glm::vec3& c, Curve curve) {
  return {curve(c.x), curve(c.y), curve(c.z)};
}

/// Of the inverse of c/(1 + x).
float inverseDivisor(float brightness) {
  const float rest = 1.0f - brightness;
  return rest > kMinToneDenominator ? rest : kMinToneDenominator;
}

int within(int value, int count) {
  return value < 0 ? 0 : value > count - 1 ? count - 1 : value;
}

} // namespace

bool isBad(float value) {
  return !(value >= 0.0f && value <= kLargestHalf);
}

glm::vec3 saneOr(const glm::vec3& other, const glm::vec3& color) {
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = isBad(color[i]) ? other[i] : color[i];
  return result;
}

glm::vec3 sanitized(const glm::vec3& color) {
  return saneOr(glm::vec3(0.0f), color);
}

glm::vec3 storable(const glm::vec3& color) {
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) {
    const float positive = color[i] > 0.0f ? color[i] : 0.0f;
    result[i] = positive < kLargestHalf ? positive : kLargestHalf;
  }
  return result;
}

float luma(const glm::vec3& color) {
  return luminance(color);
}

float weightLuma(const glm::vec3& color, WeightLuma chosen) {
  switch (chosen) {
  case WeightLuma::Rec709:
    return luma(color);
  case WeightLuma::YCoCg:
    return (0.25f * color.x + 0.5f * color.y) + 0.25f * color.z;
  }
  return luma(color);
}

float saturated(float x) {
  return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
}

glm::vec3 compress(const glm::vec3& c, ToneSpace tone) {
  switch (tone) {
  case ToneSpace::Linear:
    return c;
  case ToneSpace::ReinhardLuma:
    return c / (1.0f + luma(c));
  case ToneSpace::ReinhardChannel:
    return c / (1.0f + c);
  case ToneSpace::MaxChannel:
    return c / (1.0f + largestChannel(c));
  case ToneSpace::Pq:
    return eachChannel(c, pq);
  case ToneSpace::Logarithm:
    return eachChannel(c, logarithm);
  case ToneSpace::Gamma:
    return eachChannel(c, gammaEncoded);
  }
  return c;
}

glm::vec3 decompress(const glm::vec3& y, ToneSpace tone) {
  switch (tone) {
  case ToneSpace::Linear:
    return y;
  case ToneSpace::ReinhardLuma:
    return y / inverseDivisor(luma(y));
  case ToneSpace::ReinhardChannel:
    return {y.x / inverseDivisor(y.x), y.y / inverseDivisor(y.y), y.z / inverseDivisor(y.z)};
  case ToneSpace::MaxChannel:
    return y / inverseDivisor(largestChannel(y));
  case ToneSpace::Pq:
    return eachChannel(y, inversePq);
  case ToneSpace::Logarithm:
    return eachChannel(y, inverseLogarithm);
  case ToneSpace::Gamma:
    return eachChannel(y, gammaDecoded);
  }
  return y;
}

bool mixesCompressed(ToneWeight tone) {
  switch (tone) {
  case ToneWeight::None:
  case ToneWeight::Luma:
  case ToneWeight::LumaAsPrinted:
    return false;
  case ToneWeight::ReinhardChannel:
  case ToneWeight::MaxChannel:
  case ToneWeight::Pq:
  case ToneWeight::Logarithm:
  case ToneWeight::WhitePoint:
    break;
  }
  return true;
}

namespace {

/// The box's curve that a mix has too.
ToneSpace sameCurve(ToneWeight tone) {
  switch (tone) {
  case ToneWeight::ReinhardChannel:
    return ToneSpace::ReinhardChannel;
  case ToneWeight::MaxChannel:
    return ToneSpace::MaxChannel;
  case ToneWeight::Pq:
    return ToneSpace::Pq;
  case ToneWeight::Logarithm:
    return ToneSpace::Logarithm;
  case ToneWeight::None:
  case ToneWeight::Luma:
  case ToneWeight::LumaAsPrinted:
  case ToneWeight::WhitePoint: // has a curve that no box has
    break;
  }
  return ToneSpace::Linear;
}

} // namespace

glm::vec3 compress(const glm::vec3& color, const BlendSettings& blend) {
  if (blend.tone == ToneWeight::WhitePoint)
    return eachChannel(color, [&](float c) { return whitePoint(c, blend.white); });
  return compress(color, sameCurve(blend.tone));
}

glm::vec3 decompress(const glm::vec3& color, const BlendSettings& blend) {
  if (blend.tone == ToneWeight::WhitePoint)
    return eachChannel(color, [&](float y) { return inverseWhitePoint(y, blend.white); });
  return decompress(color, sameCurve(blend.tone));
}

namespace {

/// The chosen axes (manual §9), and back.
glm::vec3 toAxes(const glm::vec3& c, ColorSpace space) {
  switch (space) {
  case ColorSpace::Rgb:
    return c;
  case ColorSpace::YCoCg:
  case ColorSpace::YCoCgAsPrinted: {
    const float y = (0.25f * c.x + 0.5f * c.y) + 0.25f * c.z;
    const float co = 0.5f * c.x - 0.5f * c.z;
    const float cg = (-0.25f * c.x + 0.5f * c.y) - 0.25f * c.z;
    return {y, co, cg};
  }
  case ColorSpace::YCoCgLifting: {
    const float co = c.x - c.z;
    const float t = c.z + 0.5f * co;
    const float cg = c.y - t;
    return {t + 0.5f * cg, co, cg};
  }
  case ColorSpace::YCbCr: {
    const float y = luma(c);
    return {y, (c.z - y) / 1.8556f, (c.x - y) / 1.5748f};
  }
  }
  return c;
}

glm::vec3 fromAxes(const glm::vec3& axes, ColorSpace space) {
  const auto& [y, first, second] = std::array{axes.x, axes.y, axes.z};
  switch (space) {
  case ColorSpace::Rgb:
    break;
  case ColorSpace::YCoCg:
    return {(y + first) - second, y + second, (y - first) - second};
  case ColorSpace::YCoCgAsPrinted: // D7: clamped, compressed or not
    return {saturated((y + first) - second), saturated(y + second), saturated((y - first) - second)};
  case ColorSpace::YCoCgLifting: {
    const float t = y - 0.5f * second;
    const float blue = t - 0.5f * first;
    return {blue + first, second + t, blue};
  }
  case ColorSpace::YCbCr: {
    const float red = y + 1.5748f * second;
    const float blue = y + 1.8556f * first;
    return {red, ((y - 0.2126f * red) - 0.0722f * blue) / 0.7152f, blue};
  }
  }
  return axes;
}

} // namespace

glm::vec3 toBox(const glm::vec3& color, const SpaceSettings& space) {
  return toAxes(compress(color, space.tone), space.color);
}

glm::vec3 fromBox(const glm::vec3& box, const SpaceSettings& space) {
  return decompress(fromAxes(box, space.color), space.tone);
}

SpaceSettings withoutClamp(const SpaceSettings& space) {
  return {space.color == ColorSpace::YCoCgAsPrinted ? ColorSpace::YCoCg : space.color, space.tone,
          space.luma};
}

float boxLuma(const glm::vec3& box, const SpaceSettings& space) {
  return space.color == ColorSpace::Rgb ? luma(box) : box.x;
}

glm::vec3 minimum(const glm::vec3& a, const glm::vec3& b) {
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = a[i] < b[i] ? a[i] : b[i];
  return result;
}

glm::vec3 maximum(const glm::vec3& a, const glm::vec3& b) {
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = a[i] > b[i] ? a[i] : b[i];
  return result;
}

glm::vec3 clamped(const glm::vec3& value, const glm::vec3& low, const glm::vec3& high) {
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) {
    const float atLeast = value[i] < low[i] ? low[i] : value[i]; // the upper wall has the last word
    result[i] = atLeast > high[i] ? high[i] : atLeast;
  }
  return result;
}

glm::ivec2 texelOf(const glm::vec2& position) {
  return {static_cast<int>(std::floor(position.x)), static_cast<int>(std::floor(position.y))};
}

glm::ivec2 clampedToPicture(const glm::ivec2& pixel, const Inputs& inputs) {
  return {within(pixel.x, inputs.outputWidth()), within(pixel.y, inputs.outputHeight())};
}

glm::ivec2 clampedToDrawn(const glm::ivec2& texel, const Inputs& inputs) {
  return {within(texel.x, inputs.width()), within(texel.y, inputs.height())};
}

glm::vec3 currentColor(const Inputs& inputs, const glm::ivec2& texel) {
  const glm::ivec2 p = clampedToDrawn(texel, inputs);
  return sanitized(glm::vec3(inputs.color.texel(p.x, p.y)));
}

} // namespace taa::twin
