// Stage 9, blend: current and history mixed, and how many frames' worth of samples that holds.
#include "core/base/Half.h"
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Random.h"
#include "core/taa/twin/Stages.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace taa::twin {
namespace {

template <typename Real>
Real blendFactor(Real alpha, Real toneWeightCurrent, Real toneWeightHistory, ToneWeight tone) {
  if (alpha >= 1.0f) return 1.0f;
  if (tone != ToneWeight::Luma && tone != ToneWeight::LumaAsPrinted) return alpha;
  const Real current = alpha * toneWeightCurrent;
  return current / (current + (1.0f - alpha) * toneWeightHistory);
}

/// 1/(1 + L); as printed (D19) of the color divided by 1 + its largest channel.
template <typename Real>
Real toneWeight(const Vec3<Real>& color, ToneWeight tone, WeightLuma chosen) {
  switch (tone) {
  case ToneWeight::Luma:
    return 1.0f / (1.0f + named(weightLuma(color, chosen)));
  case ToneWeight::LumaAsPrinted:
    return 1.0f / (1.0f + named(weightLuma(compress(color, ToneSpace::MaxChannel), chosen)));
  case ToneWeight::None:
  case ToneWeight::ReinhardChannel: // what compresses does not weigh
  case ToneWeight::MaxChannel:
  case ToneWeight::Pq:
  case ToneWeight::Logarithm:
  case ToneWeight::WhitePoint:
    break;
  }
  return 1.0f;
}

/// The mix itself, of compressed colors where the choice says so (manual 15.3 to 15.7). `keepsHistory`: a
/// share of 0 leaves it as it is, even then (invariant 65).
template <typename Real>
Vec3<Real> mixed(const Vec3<Real>& current, const Vec3<Real>& history, const Vec3<Real>& k,
                 const BlendSettings& settings, bool keepsHistory) {
  Vec3<Real> result = history + k * (current - history);
  if (mixesCompressed(settings.tone)) {
    const Vec3<Real> from = named(compress(history, settings));
    const Vec3<Real> between = from + k * (named(compress(current, settings)) - from);
    result = current == history ? history : decompress(between, settings);
  }
  for (int i = 0; i < 3; ++i) {
    if (k[i] >= 1.0f) result[i] = current[i];
    if (k[i] <= 0.0f && keepsHistory) result[i] = history[i];
  }
  return result;
}

/// x as a multiple of 1/steps, of those around it the one that `u`, 0 to 1, chooses.
template <typename Real>
Real quantized(Real x, float steps, float u) {
  return roundedBy(x, [&](float v) { return std::floor(v * steps + u) / steps; });
}

/// The half below or above x: cutting off 13 bits after `number` was added to them.
float ditheredHalf(float x, std::uint32_t number) {
  constexpr float kMinNormal = 0x1p-14f;
  if (x < kMinNormal)
    return std::floor(x * 0x1p24f + (static_cast<float>(number) + 0.5f) / 8192.0f) / 0x1p24f;
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(x) + number) & 0xFFFFE000u);
}

/// A channel as the history holds it (manual 1.6, 14.7, 20.6).
template <typename Real>
Real asStored(const HistorySettings& settings, Real x, const BlendInputsOf<Real>& mix,
              std::uint32_t channel) {
  const bool isDithered = settings.dither == Switch::On;
  const std::uint32_t bits = isDithered ? randomBits(mix.pixel, mix.frame, channel) : 0;
  const float u = isDithered ? (static_cast<float>(bits) + 0.5f) / 8192.0f : 0.5f;
  switch (settings.precision) {
  case Precision::Full:
    return x;
  case Precision::Half:
    return roundedBy(x, [&](float v) { return isDithered ? ditheredHalf(v, bits) : roundedToHalf(v); });
  case Precision::Unorm8:
    return quantized(saturated(x), 255.0f, u);
  case Precision::Unorm10:
    return quantized(saturated(x), 1023.0f, u);
  }
  return x;
}

/// What is left of a sample's variance.
template <typename Real>
Real varianceAfter(Real alpha, Real before) {
  const Real rest = 1.0f - alpha;
  return alpha * alpha + (rest * rest) / before;
}

/// As Godot counts: the first frame of all is not counted, and what decayed goes on from there.
template <typename Real>
Real countedTo16(const BlendInputsOf<Real>& mix, bool decays) {
  if (mix.isFirst) return 0.0f;
  const Real sum = mix.historyLength + mix.confidence;
  const Real counted = minimum(sum, 16.0f);
  return mix.alpha >= 1.0f && !decays ? 1.0f : counted;
}

/// N after the frame (manual §16), of a sample of confidence κ.
template <typename Real>
Real lengthAfter(const Settings& settings, const BlendInputsOf<Real>& mix) {
  const LengthRule rule = settings.blend.length;
  const Real alpha = mix.alpha, before = mix.historyLength, confidence = mix.confidence;
  if (alpha >= 1.0f && rule != LengthRule::CountTo16) return 1.0f;
  switch (rule) {
  case LengthRule::Variance:
    return 1.0f / varianceAfter(alpha, before);
  case LengthRule::Count:
    return before + confidence;
  case LengthRule::VarianceAsPrinted:
    return varianceAfter(alpha, before);
  case LengthRule::Confidence:
    return confidenceAfter(before, mix.motion);
  case LengthRule::Reciprocal:
    if (!(alpha > 1e-6f)) return before;
    return confidence / alpha > 1.0f ? confidence / alpha : 1.0f;
  case LengthRule::CountTo16:
    return countedTo16(mix, settings.validate.action == RejectAction::Decay);
  }
  return before;
}

} // namespace

template <typename Real>
BlendedOf<Real> blend(const Settings& settings, const BlendInputsOf<Real>& mix) {
  const ToneWeight tone = settings.blend.tone;
  BlendedOf<Real> result;
  searched<Real>();
  result.toneWeightCurrent = toneWeight(mix.current, tone, settings.space.luma);
  result.toneWeightHistory = toneWeight(mix.history, tone, settings.space.luma);
  const auto factorOf = [&](Real alpha) {
    return blendFactor(alpha, result.toneWeightCurrent, result.toneWeightHistory, tone);
  };
  result.factor = factorOf(mix.alpha);
  decided<Real>(IntermediateId::blendFactor);
  Vec3<Real> factors(result.factor);
  if (settings.weight.source == AlphaSource::ContrastPerChannel)
    for (int i = 0; i < 3; ++i) factors[i] = factorOf(mix.channels[i]);
  const bool mayKeepAll = isUpsampled(settings) || settings.validate.offScreen == OffScreen::OneSided;
  const Vec3<Real> color = mixed(mix.current, mix.history, factors, settings.blend, mayKeepAll);
  const Vec3<Real> sane = saneOr(mix.current, color);
  for (int i = 0; i < 3; ++i) {
    result.resolved[i] = asStored(settings.history, sane[i], mix, static_cast<std::uint32_t>(i));
  }
  decided<Real>(IntermediateId::resolved);
  if (mix.isNan) result.resolved = Vec3<Real>(std::numeric_limits<float>::quiet_NaN());
  result.historyLength = lengthAfter(settings, mix);
  decided<Real>(IntermediateId::historyLength);
  return result;
}

#define TAA_BLEND(Real)                                                                                      \
  template BlendedOf<Real> blend(const Settings& settings, const BlendInputsOf<Real>& mix);
TAA_EACH_NUMBER(TAA_BLEND)
#undef TAA_BLEND

} // namespace taa::twin
