// Color arithmetic of the CPU twin; order of operations as in the definition of the resolve.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"

#include "core/base/Light.h"
#include "core/taa/twin/ToneCurves.h"

#include <array>
#include <cmath>

namespace taa::twin {
namespace {

constexpr float kLargestHalf = 65504.0f;

/// Least denominator of the inverse tone curve: caps the result at 10⁵ times the box color.
constexpr float kMinToneDenominator = 1e-5f;

template <typename Real>
Real largestChannel(const Vec3<Real>& c) {
  return maximum(maximum(c.x, c.y), c.z);
}

template <typename Real, typename Curve>
Vec3<Real> eachChannel(const Vec3<Real>& c, Curve curve) {
  return {curve(c.x), curve(c.y), curve(c.z)};
}

/// Of the inverse of c/(1 + x).
template <typename Real>
Real inverseDivisor(Real brightness) {
  const Real rest = 1.0f - brightness;
  return maximum(rest, kMinToneDenominator);
}

int within(int value, int count) {
  return value < 0 ? 0 : value > count - 1 ? count - 1 : value;
}

} // namespace

template <typename Real>
bool isBad(Real value) {
  return !(value >= 0.0f && value <= kLargestHalf);
}

template <typename Real>
Vec3<Real> saneOr(const Vec3<Real>& other, const Vec3<Real>& color) {
  Vec3<Real> result;
  for (int i = 0; i < 3; ++i) result[i] = isBad(color[i]) ? other[i] : color[i];
  return result;
}

template <typename Real>
Vec3<Real> sanitized(const Vec3<Real>& color) {
  return saneOr(Vec3<Real>(0.0f), color);
}

template <typename Real>
Vec3<Real> storable(const Vec3<Real>& color) {
  Vec3<Real> result;
  for (int i = 0; i < 3; ++i) result[i] = minimum(maximum(color[i], 0.0f), kLargestHalf);
  return result;
}

template <typename Real>
Real luma(const Vec3<Real>& color) {
  return luminance(color);
}

template <typename Real>
Real weightLuma(const Vec3<Real>& color, WeightLuma chosen) {
  switch (chosen) {
  case WeightLuma::Rec709:
    return luma(color);
  case WeightLuma::YCoCg:
    return (0.25f * color.x + 0.5f * color.y) + 0.25f * color.z;
  }
  return luma(color);
}

template <typename Real>
Vec3<Real> compress(const Vec3<Real>& c, ToneSpace tone) {
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
    return eachChannel(c, [](Real x) { return pq(x); });
  case ToneSpace::Logarithm:
    return eachChannel(c, [](Real x) { return logarithm(x); });
  case ToneSpace::Gamma:
    return eachChannel(c, [](Real x) { return gammaEncoded(x); });
  }
  return c;
}

template <typename Real>
Vec3<Real> decompress(const Vec3<Real>& y, ToneSpace tone) {
  switch (tone) {
  case ToneSpace::Linear:
    return y;
  case ToneSpace::ReinhardLuma:
    return y / inverseDivisor(named(luma(y)));
  case ToneSpace::ReinhardChannel:
    return {y.x / inverseDivisor(named(y.x)), y.y / inverseDivisor(named(y.y)),
            y.z / inverseDivisor(named(y.z))};
  case ToneSpace::MaxChannel:
    return y / inverseDivisor(named(largestChannel(y)));
  case ToneSpace::Pq:
    return eachChannel(y, [](Real x) { return inversePq(x); });
  case ToneSpace::Logarithm:
    return eachChannel(y, [](Real x) { return inverseLogarithm(x); });
  case ToneSpace::Gamma:
    return eachChannel(y, [](Real x) { return gammaDecoded(x); });
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

template <typename Real>
Vec3<Real> compress(const Vec3<Real>& color, const BlendSettings& blend) {
  if (blend.tone == ToneWeight::WhitePoint)
    return eachChannel(color, [&](Real c) { return whitePoint(c, number<Real>(blend.white)); });
  return compress(color, sameCurve(blend.tone));
}

template <typename Real>
Vec3<Real> decompress(const Vec3<Real>& color, const BlendSettings& blend) {
  if (blend.tone == ToneWeight::WhitePoint)
    return eachChannel(color, [&](Real y) { return inverseWhitePoint(y, number<Real>(blend.white)); });
  return decompress(color, sameCurve(blend.tone));
}

namespace {

/// The chosen axes (manual §9), and back.
template <typename Real>
Vec3<Real> toAxes(const Vec3<Real>& c, ColorSpace space) {
  switch (space) {
  case ColorSpace::Rgb:
    return c;
  case ColorSpace::YCoCg:
  case ColorSpace::YCoCgAsPrinted: {
    const Real y = (0.25f * c.x + 0.5f * c.y) + 0.25f * c.z;
    const Real co = 0.5f * c.x - 0.5f * c.z;
    const Real cg = (-0.25f * c.x + 0.5f * c.y) - 0.25f * c.z;
    return {y, co, cg};
  }
  case ColorSpace::YCoCgLifting: {
    const Real co = c.x - c.z;
    const Real t = c.z + 0.5f * co;
    const Real cg = c.y - t;
    return {t + 0.5f * cg, co, cg};
  }
  case ColorSpace::YCbCr: {
    const Real y = luma(c);
    return {y, (c.z - y) / 1.8556f, (c.x - y) / 1.5748f};
  }
  }
  return c;
}

template <typename Real>
Vec3<Real> fromAxes(const Vec3<Real>& axes, ColorSpace space) {
  const auto& [y, first, second] = std::array{axes.x, axes.y, axes.z};
  switch (space) {
  case ColorSpace::Rgb:
    break;
  case ColorSpace::YCoCg:
    return {(y + first) - second, y + second, (y - first) - second};
  case ColorSpace::YCoCgAsPrinted: // D7: clamped, compressed or not
    return {saturated((y + first) - second), saturated(y + second), saturated((y - first) - second)};
  case ColorSpace::YCoCgLifting: {
    const Real t = y - 0.5f * second;
    const Real blue = t - 0.5f * first;
    return {blue + first, second + t, blue};
  }
  case ColorSpace::YCbCr: {
    const Real red = y + 1.5748f * second;
    const Real blue = y + 1.8556f * first;
    return {red, ((y - 0.2126f * red) - 0.0722f * blue) / 0.7152f, blue};
  }
  }
  return axes;
}

} // namespace

template <typename Real>
Vec3<Real> toBox(const Vec3<Real>& color, const SpaceSettings& space) {
  return toAxes(compress(color, space.tone), space.color);
}

template <typename Real>
Vec3<Real> fromBox(const Vec3<Real>& box, const SpaceSettings& space) {
  return decompress(fromAxes(box, space.color), space.tone);
}

SpaceSettings withoutClamp(const SpaceSettings& space) {
  return {space.color == ColorSpace::YCoCgAsPrinted ? ColorSpace::YCoCg : space.color, space.tone,
          space.luma};
}

template <typename Real>
Real boxLuma(const Vec3<Real>& box, const SpaceSettings& space) {
  return space.color == ColorSpace::Rgb ? luma(box) : box.x;
}

template <typename Real>
Vec3<Real> minimum(const Vec3<Real>& a, const Vec3<Real>& b) {
  Vec3<Real> result;
  for (int i = 0; i < 3; ++i) result[i] = minimum(a[i], b[i]);
  return result;
}

template <typename Real>
Vec3<Real> maximum(const Vec3<Real>& a, const Vec3<Real>& b) {
  Vec3<Real> result;
  for (int i = 0; i < 3; ++i) result[i] = maximum(a[i], b[i]);
  return result;
}

template <typename Real>
Vec3<Real> clamped(const Vec3<Real>& value, const Vec3<Real>& low, const Vec3<Real>& high) {
  Vec3<Real> result;
  for (int i = 0; i < 3; ++i) result[i] = bounded(value[i], low[i], high[i]);
  return result;
}

template <typename Real>
glm::ivec2 texelOf(const Vec2<Real>& position) {
  return {whole(position.x), whole(position.y)};
}

glm::ivec2 clampedToPicture(const glm::ivec2& pixel, const Inputs& inputs) {
  return {within(pixel.x, inputs.outputWidth()), within(pixel.y, inputs.outputHeight())};
}

glm::ivec2 clampedToDrawn(const glm::ivec2& texel, const Inputs& inputs) {
  return {within(texel.x, inputs.width()), within(texel.y, inputs.height())};
}

template <typename Real>
Vec3<Real> currentColor(const Inputs& inputs, const glm::ivec2& texel) {
  const glm::ivec2 p = clampedToDrawn(texel, inputs);
  return sanitized(Vec3<Real>(read<Real>(inputs.color, p)));
}

#define TAA_COLOR(Real)                                                                                      \
  template bool isBad(Real value);                                                                           \
  template Vec3<Real> saneOr(const Vec3<Real>& other, const Vec3<Real>& color);                              \
  template Vec3<Real> sanitized(const Vec3<Real>& color);                                                    \
  template Vec3<Real> storable(const Vec3<Real>& color);                                                     \
  template Real luma(const Vec3<Real>& color);                                                               \
  template Real weightLuma(const Vec3<Real>& color, WeightLuma chosen);                                      \
  template Vec3<Real> compress(const Vec3<Real>& color, ToneSpace tone);                                     \
  template Vec3<Real> decompress(const Vec3<Real>& color, ToneSpace tone);                                   \
  template Vec3<Real> compress(const Vec3<Real>& color, const BlendSettings& blend);                         \
  template Vec3<Real> decompress(const Vec3<Real>& color, const BlendSettings& blend);                       \
  template Vec3<Real> toBox(const Vec3<Real>& color, const SpaceSettings& space);                            \
  template Vec3<Real> fromBox(const Vec3<Real>& box, const SpaceSettings& space);                            \
  template Real boxLuma(const Vec3<Real>& box, const SpaceSettings& space);                                  \
  template Vec3<Real> minimum(const Vec3<Real>& a, const Vec3<Real>& b);                                     \
  template Vec3<Real> maximum(const Vec3<Real>& a, const Vec3<Real>& b);                                     \
  template Vec3<Real> clamped(const Vec3<Real>& value, const Vec3<Real>& low, const Vec3<Real>& high);       \
  template glm::ivec2 texelOf(const Vec2<Real>& position);                                                   \
  template Vec3<Real> currentColor(const Inputs& inputs, const glm::ivec2& texel);
TAA_EACH_NUMBER(TAA_COLOR)
#undef TAA_COLOR

} // namespace taa::twin
