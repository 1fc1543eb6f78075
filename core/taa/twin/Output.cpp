// Stage 10, output: what is shown of the resolved picture, sharpened (manual §18) and blurred where it is
// fast (14.4).
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Random.h"
#include "core/taa/twin/Stages.h"
#include "core/taa/twin/Upsample.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace taa::twin {
namespace {

template <typename Real>
using Nine = std::array<Vec3<Real>, 9>; // 3×3, row-major

/// Speed of what has no previous position, px; no motion is faster.
constexpr float kUnknownSpeed = 65504.0f;

constexpr std::array<std::size_t, 4> kCross{1, 3, 5, 7};
constexpr std::array<std::size_t, 4> kCorners{0, 2, 6, 8};

/// Sum of the differences of four to the middle one.
template <typename Real>
Vec3<Real> differences(const Nine<Real>& c, const std::array<std::size_t, 4>& places) {
  Vec3<Real> sum = c[places[0]] - c[4];
  for (std::size_t i = 1; i < 4; ++i) sum = sum + (c[places[i]] - c[4]);
  return sum;
}

template <typename Real>
Vec3<Real> sharpenedByLuma(const Nine<Real>& c, Real amount) {
  const Real center = named(luma(c[4]));
  if (!(center > 1e-6f)) return c[4];
  Real sum = 0.0f;
  for (const Vec3<Real>& color : c) sum = sum + (named(luma(color)) - center);
  return (1.0f - amount * ((sum / 9.0f) / center)) * c[4];
}

/// By the mean of the four around (manual 18.3).
template <typename Real>
Vec3<Real> sharpenedByLaplacian(const Nine<Real>& c, Real amount) {
  return c[4] - amount * (differences(c, kCross) / 4.0f);
}

/// By that of all nine (manual 18.3).
template <typename Real>
Vec3<Real> unsharpMasked(const Nine<Real>& c, Real amount) {
  return c[4] - amount * ((differences(c, kCross) + differences(c, kCorners)) / 9.0f);
}

/// Each color divided by 1 + its largest channel.
template <typename Real>
Nine<Real> compressMax(const Nine<Real>& colors) {
  Nine<Real> result;
  for (std::size_t k = 0; k < 9; ++k) result[k] = named(compress(colors[k], ToneSpace::MaxChannel));
  return result;
}

/// Of nine colors with bounded highlights.
template <typename Real>
Real rcasLobe(const Nine<Real>& t, Real amount) {
  const Vec3<Real> low = minimum(minimum(t[1], t[3]), minimum(t[5], t[7]));
  const Vec3<Real> high = maximum(maximum(t[1], t[3]), maximum(t[5], t[7]));
  Real lobe = 0.1875f;
  for (int i = 0; i < 3; ++i) {
    const Real least = low[i] < t[4][i] ? low[i] : t[4][i];
    const Real most = high[i] > t[4][i] ? high[i] : t[4][i];
    const Real room = high[i] > 0.0f ? least / (4.0f * high[i]) : 0.0f;
    const Real headroom = (1.0f - most) / (4.0f - 4.0f * low[i]);
    lobe = room < lobe ? room : lobe;
    lobe = headroom < lobe ? headroom : lobe;
  }
  return lobe * saturated(amount);
}

/// What sharpening in the resolve keeps away from.
template <typename Real>
Vec3<Real> meanInResolve(const Nine<Real>& current) {
  const Vec3<Real> center = compress(current[4], ToneSpace::ReinhardLuma);
  Vec3<Real> sum(0.0f);
  for (const Vec3<Real>& color : current) sum = sum + (compress(color, ToneSpace::ReinhardLuma) - center);
  const Vec3<Real> mean = center + sum / 9.0f;
  return mean == center ? current[4] : decompress(mean, ToneSpace::ReinhardLuma);
}

template <typename Real>
Vec3<Real> sharpenedByRcas(const Nine<Real>& c, Real amount) {
  const Nine<Real> t = compressMax(c);
  const Real lobe = named(rcasLobe(t, amount));
  const Vec3<Real> result = t[4] - (lobe * differences(t, kCross)) / (1.0f - 4.0f * lobe);
  return result == t[4] ? c[4] : decompress(result, ToneSpace::MaxChannel);
}

template <typename Real>
Vec3<Real> brightenedInResolve(const Nine<Real>& c, const Nine<Real>& current, Real amount) {
  return c[4] + (3.0f * amount) * maximum(c[4] - named(meanInResolve(current)), Vec3<Real>(0.0f));
}

template <typename Real>
Vec3<Real> squareRoot(const Vec3<Real>& x) {
  return {sqrt(x.x), sqrt(x.y), sqrt(x.z)};
}

template <typename Real>
Vec3<Real> toAmount(const Vec3<Real>& ratio, int steps) {
  return {powerOf256ths(ratio.x, steps), powerOf256ths(ratio.y, steps), powerOf256ths(ratio.z, steps)};
}

template <typename Real>
Vec3<Real> sharpenedInLogarithms(const Nine<Real>& c, Real amount) {
  const Vec3<Real> upright = squareRoot((1.0f + c[1]) * (1.0f + c[7]));
  const Vec3<Real> level = squareRoot((1.0f + c[3]) * (1.0f + c[5]));
  const Vec3<Real> center = 1.0f + c[4];
  const int steps = whole(amount * 256.0f + 0.5f);
  return c[4] + center * (toAmount(center / squareRoot(upright * level), steps) - 1.0f);
}

template <typename Real>
Vec3<Real> reconstructed(const Nine<Real>& c, Real amount) {
  const Real b = amount / 6.0f;
  return c[4] + ((b * b) * differences(c, kCorners) - (b * (1.0f + 2.0f * b)) * differences(c, kCross));
}

/// 1/18, 8/9, 1/18 each way (manual 6.6).
template <typename Real>
Vec3<Real> mitchellFiltered(const Nine<Real>& c) {
  return c[4] + (differences(c, kCorners) + 16.0f * differences(c, kCross)) / 324.0f;
}

template <typename Real>
Vec3<Real> sharpenedBy(const OutputSettings& settings, const Nine<Real>& c, const Nine<Real>& current) {
  const Real k = number<Real>(settings.amount);
  switch (settings.sharpen) {
  case Sharpen::None:
    break;
  case Sharpen::LumaRatio:
    return sharpenedByLuma(c, k);
  case Sharpen::Laplacian:
    return sharpenedByLaplacian(c, k);
  case Sharpen::Unsharp:
    return unsharpMasked(c, k);
  case Sharpen::Rcas:
    return sharpenedByRcas(c, k);
  case Sharpen::InResolve:
    return brightenedInResolve(c, current, k);
  case Sharpen::Logarithm:
    return sharpenedInLogarithms(c, k);
  case Sharpen::Reconstruct:
    return reconstructed(c, k);
  case Sharpen::Mitchell:
    return mitchellFiltered(c);
  }
  return c[4];
}

template <typename Real>
Vec3<Real> deringed(const Vec3<Real>& color, const Nine<Real>& c) {
  Vec3<Real> low = c[0], high = c[0];
  for (const Vec3<Real>& other : c) {
    low = minimum(low, other);
    high = maximum(high, other);
  }
  return clamped(color, low, high);
}

/// Start of the taps: interleaved gradient noise, 0 to 1.
float gradientNoise(const glm::ivec2& pixel, int frame) {
  const auto fraction = [](float x) { return x - std::floor(x); };
  const glm::vec2 place = glm::vec2(pixel) + 5.588238f * static_cast<float>(frame % 64);
  return fraction(52.9829189f * fraction(0.06711056f * place.x + 0.00583715f * place.y));
}

template <typename Real>
Vec3<Real> currentAt(const Inputs& inputs, const Vec2<Real>& position) {
  const Vec2<Real> corner(floor(position.x - 0.5f), floor(position.y - 0.5f));
  const Vec2<Real> share = (position - 0.5f) - corner;
  const auto row = [&](int y) {
    const glm::ivec2 first = texelOf(corner) + glm::ivec2(0, y);
    const Vec3<Real> left = currentColor<Real>(inputs, first);
    return left + share.x * (currentColor<Real>(inputs, first + glm::ivec2(1, 0)) - left);
  };
  const Vec3<Real> top = row(0);
  return top + share.y * (row(1) - top);
}

template <typename Real>
Vec3<Real> blurredAlong(const Inputs& inputs, const Vec2<Real>& position, const Vec2<Real>& motion,
                        Real noise) {
  const Vec2<Real> step = motion / 6.0f;
  const Real start = noise - 0.5f;
  const auto tap = [&](float i) { return currentAt(inputs, position + (start + i) * step); };
  const Vec3<Real> first = tap(-3.0f);
  Vec3<Real> sum(0.0f);
  for (int i = -2; i <= 3; ++i) sum = sum + (tap(static_cast<float>(i)) - first);
  return first + sum / 7.0f;
}

/// The layer drawn without jitter over a color (manual 21.1); `texel`: the one that holds the pixel's
/// center.
template <typename Real>
Vec3<Real> covered(const Inputs& inputs, const glm::ivec2& texel, const Vec3<Real>& color) {
  if (inputs.overlay.empty()) return color;
  const Vec4<Real> layer = read<Real>(inputs.overlay, texel);
  return storable(color * (1.0f - layer.w) + Vec3<Real>(layer));
}

/// The sharp color, and where it is fast the blurred one joined to it (manual 14.4). `texel`: the pixel's
/// nearest sample.
template <typename Real>
ShownColorOf<Real> blurredByMotion(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                                   const glm::ivec2& texel, const ShownColorOf<Real>& sharp) {
  const Vec2<Real> motion = dilateMotion<Real>(inputs, settings.dilate, texel).motion;
  const Real speed = reproject(inputs, settings.reproject, motion, pixel).speed;
  ShownColorOf<Real> shown = sharp;
  if (speed >= kUnknownSpeed) return shown;
  shown.trust = 1.0f - saturated((speed - 2.0f) / 13.0f);
  if (shown.trust >= 1.0f) return shown;
  const Vec2<Real> position =
      (Vec2<Real>(pixel) + 0.5f) * renderRatio<Real>(inputs); // render px, as the blur's way
  const Vec3<Real> fast = named(blurredAlong(inputs, position, motion * renderRatio<Real>(inputs),
                                             Real(gradientNoise(pixel, inputs.frame))));
  shown.color = fast + shown.trust * (sharp.color - fast);
  return shown;
}

} // namespace

template <typename Real>
Vec3<Real> sharpen(const OutputSettings& settings, const std::array<Vec3<Real>, 9>& c,
                   const std::array<Vec3<Real>, 9>& current) {
  if (settings.sharpen == Sharpen::None) return c[4];
  const Vec3<Real> result = sharpenedBy(settings, c, current);
  return storable(settings.dering == Switch::On ? deringed(result, c) : result);
}

template <typename Real>
ShownColorOf<Real> showOutput(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  const glm::ivec2 texel = isUpsampled(settings) ? placeOf<Real>(inputs, pixel).texel : pixel;
  Nine<Real> around, current;
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 step(k % 3 - 1, k / 3 - 1);
    const glm::ivec2 at = clampedToPicture(pixel + step, inputs);
    around[static_cast<std::size_t>(k)] = Vec3<Real>(read<Real>(inputs.resolved, at));
    current[static_cast<std::size_t>(k)] = currentColor<Real>(inputs, texel + step);
  }
  ShownColorOf<Real> shown;
  static const OutputSettings kAsItIs{};
  const OutputSettings& output = isTaaOn(settings) ? settings.output : kAsItIs;
  const Vec3<Real> sharp = named(sharpen(output, around, current));
  shown.detail = named(luma(sharp)) - named(luma(around[4]));
  shown.color = sharp;
  if (output.motionBlur == Switch::On) shown = blurredByMotion(inputs, settings, pixel, texel, shown);
  shown.color =
      covered(inputs, isUpsampled(settings) ? placeOf<Real>(inputs, pixel).still : pixel, shown.color);
  if (output.dither == Switch::On) { // manual 20.8
    const float noise = triangularNoise(pixel, inputs.frame) / 255.0f;
    const Vec3<Real> root = maximum(squareRoot(named(shown.color)) + noise, Vec3<Real>(0.0f));
    shown.color = storable(root * root);
  }
  return shown;
}

#define TAA_OUTPUT(Real)                                                                                     \
  template Vec3<Real> sharpen(const OutputSettings& settings, const std::array<Vec3<Real>, 9>& resolved,     \
                              const std::array<Vec3<Real>, 9>& current);                                     \
  template ShownColorOf<Real> showOutput(const Inputs& inputs, const Settings& settings,                     \
                                         const glm::ivec2& pixel);
TAA_EACH_NUMBER(TAA_OUTPUT)
#undef TAA_OUTPUT

} // namespace taa::twin
