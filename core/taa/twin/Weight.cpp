// Stage 8, blend weight: how much the current frame counts.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"

#include <cmath>

namespace taa::twin {
namespace {

/// u² of Lottes and Playdead (manual 13.10): 1 where luma is the same.
template <typename Real>
Real lumaLikeness(Real current, Real history) {
  const Real most = maximum(maximum(current, history), 0.2f);
  const Real u = 1.0f - fabs(current - history) / most;
  return u * u;
}

/// Of a contrast, a range over a color (manual 13.14).
template <typename Real>
Real contrastWeight(Real contrast) {
  return 1.0f - (0.25f + 0.6f * saturated(contrast));
}

/// The same of each channel, by the range of the nine samples (manual 13.14, 14.2).
template <typename Real>
Vec3<Real> channelWeights(const WeightInputsOf<Real>& weighed) {
  return {contrastWeight(weighed.contrast.x), contrastWeight(weighed.contrast.y),
          contrastWeight(weighed.contrast.z)};
}

template <typename Real>
Real baseWeight(const WeightSettings& settings, Real historyLength, const WeightInputsOf<Real>& weighed) {
  switch (settings.source) {
  case AlphaSource::Constant:
    return number<Real>(settings.alpha);
  case AlphaSource::HistoryLength:
    return 1.0f / (historyLength + 1.0f);
  case AlphaSource::LumaDifference:
    return number<Real>(settings.sourceMax) +
           lumaLikeness(weighed.lumaCurrent, weighed.lumaHistory) *
               (number<Real>(settings.sourceMin) - number<Real>(settings.sourceMax));
  case AlphaSource::LumaDifferenceCompressed:
    return number<Real>(settings.sourceMax) +
           lumaLikeness(weighed.maxCurrent, weighed.maxHistory) *
               (number<Real>(settings.sourceMin) - number<Real>(settings.sourceMax));
  case AlphaSource::LumaDifferenceAsPrinted: // D1
    return lumaLikeness(weighed.maxCurrent, weighed.maxHistory);
  case AlphaSource::Contrast:
  case AlphaSource::ContrastPerChannel:
    return contrastWeight(fabs(weighed.boxHigh - weighed.boxLow) / maximum(weighed.boxCurrent, 1e-5f));
  case AlphaSource::Confidence:
    return minimum(
        maximum(1.0f / confidenceAfter(historyLength, weighed.motion), number<Real>(settings.sourceMin)),
        number<Real>(settings.sourceMax));
  case AlphaSource::Depth:
    return weighed.depth == 0.0f ? 1.0f
                                 : 0.025f + (number<Real>(settings.alpha) - 0.025f) * sqrt(weighed.depth);
  }
  return number<Real>(settings.alpha);
}

template <typename Real>
Real boxWidth(const WeightInputsOf<Real>& weighed) {
  const Real width = weighed.boxHigh - weighed.boxLow;
  return maximum(width, 0.0f);
}

/// Against flicker where luma differs (manual 13.11).
template <typename Real>
Real lumaFlickerFactor(const WeightSettings& settings, const WeightInputsOf<Real>& weighed) {
  if (settings.lumaFlicker == Switch::Off || !weighed.hasHistory) return 1.0f;
  const bool isCompressed = settings.flickerScale == FlickerScale::Compressed;
  const Real current = isCompressed ? weighed.compressedCurrent : weighed.lumaCurrent;
  const Real history = isCompressed ? weighed.compressedHistory : weighed.lumaHistory;
  const Real largest = maximum(current, history);
  const Real rest =
      1.0f - fabs(current - history) / (isCompressed ? maximum(largest, 1.001f) : 0.001f + largest);
  return rest * rest;
}

/// Where history is near a wall of the box (manual 13.13).
template <typename Real>
Real nearClampFactor(const WeightSettings& settings, const WeightInputsOf<Real>& weighed) {
  if (settings.nearClamp == Switch::Off || !weighed.hasHistory) return 1.0f;
  const Real wall =
      minimum(fabs(weighed.boxHistoryRaw - weighed.boxLow), fabs(weighed.boxHistoryRaw - weighed.boxHigh));
  const Real sum = wall + boxWidth(weighed);
  return sum > 0.0f ? wall / sum : 1.0f;
}

/// Where the box is large against history (manual 13.15).
template <typename Real>
Real historyContrastFactor(const WeightSettings& settings, const WeightInputsOf<Real>& weighed) {
  if (settings.historyContrast == Switch::Off || !weighed.hasHistory) return 1.0f;
  return weighed.boxHistory > 0.0f ? 1.0f / (1.0f + boxWidth(weighed) / weighed.boxHistory) : 1.0f;
}

/// Where the mask widens the box (manual 13.18).
template <typename Real>
Real relaxFactor(const WeightInputsOf<Real>& weighed) {
  return 1.0f / (1.0f + 0.5f * weighed.relax);
}

/// Where a single frame may miss what is there (manual 13.9).
template <typename Real>
Real flickerFactor(const WeightSettings& settings, const WeightInputsOf<Real>& weighed) {
  return weighed.isFlicker ? number<Real>(settings.flickerShare) : 1.0f;
}

/// The least that is left of α: no more than a source gives by itself, but 1/(N+1) is raised to it.
template <typename Real>
Real minWeight(const WeightSettings& settings, Real base) {
  return settings.source == AlphaSource::HistoryLength ? number<Real>(settings.minimum)
                                                       : minimum(base, number<Real>(settings.minimum));
}

/// As the blend mode "screen" mixes.
template <typename Real>
Real screen(Real a, Real b) {
  return 1.0f - (1.0f - a) * (1.0f - b);
}

/// By the distance of the sample to the pixel's center (manual 7.7, 13.6).
template <typename Real>
Real sampleDistanceFactor(const WeightSettings& settings, const WeightInputsOf<Real>& weighed) {
  const auto x = static_cast<Wide<Real>>(weighed.jitterPx.x), y = static_cast<Wide<Real>>(weighed.jitterPx.y);
  const Wide<Real> squared = x * x + y * y;
  const auto bell = [squared] { return static_cast<Real>(exp(-squared / (2.0 * 0.22))); };
  const Real moving = smooth(weighed.speed);
  switch (settings.sampleDistance) {
  case SampleDistance::None:
    break;
  case SampleDistance::Gaussian:
    return bell();
  case SampleDistance::Parabola:
    return maximum(moving, static_cast<Real>(squared < 1.0 ? 1.0 - squared : 0.0));
  case SampleDistance::GaussianMoving:
    return 1.0f + moving * (bell() - 1.0f);
  }
  return 1.0f;
}

/// 1 − (1 − α)^(e/8), e the nearest eighth to Δt/Δt₀ (manual 13.19).
template <typename Real>
Real byFrameRate(const WeightSettings& settings, Real alpha, double stepSeconds) {
  if (settings.frameRate == Switch::Off) return alpha;
  double eighths = std::round(stepSeconds * static_cast<double>(settings.referenceRate) * 8.0);
  eighths = eighths < 1.0 ? 1.0 : eighths > 64.0 ? 64.0 : eighths;
  if (eighths == 8.0) return alpha;
  return 1.0f - powerOf256ths(1.0f - alpha, 32 * static_cast<int>(eighths));
}

/// What motion adds to α (manual 13.4 to 13.6).
template <typename Real>
Real motionWeight(const WeightSettings& settings, const WeightInputsOf<Real>& weighed, Real alpha) {
  const Real speed = speedIn(settings.motionSpeedIn, weighed.speed, weighed.motion, weighed.picturePx);
  const Real x = saturated(speed / number<Real>(settings.motionSpeed));
  switch (settings.motion) {
  case MotionAlpha::None:
    return 0.0f;
  case MotionAlpha::Linear:
  case MotionAlpha::Added:
    return x;
  case MotionAlpha::Squared:
    return x * x;
  case MotionAlpha::SquaredAsPrinted: // fractions of the picture: D11
    return saturated(weighed.motionUv.x * weighed.motionUv.x + weighed.motionUv.y * weighed.motionUv.y);
  case MotionAlpha::Doubled:
    return x * (minimum(2.0f * alpha, 1.0f) - alpha);
  }
  return 0.0f;
}

/// The least that the mask asks for (manual 13.18, 21.4).
template <typename Real>
Real maskWeight(const WeightSettings& settings, const WeightInputsOf<Real>& weighed) {
  switch (settings.mask) {
  case MaskAlpha::Off:
    return 0.0f;
  case MaskAlpha::Responsive:
    return number<Real>(settings.maskAlpha) * maximum(weighed.mask.x, weighed.mask.y);
  case MaskAlpha::Reactive:
    return weighed.mask.x;
  case MaskAlpha::Exclude:
    return weighed.mask.y > 0.0f ? 1.0f : 0.0f;
  }
  return 0.0f;
}

/// α with what motion adds to it.
template <typename Real>
Real movedWeight(MotionAlpha chosen, Real alpha, Real motion) {
  switch (chosen) {
  case MotionAlpha::None:
    break;
  case MotionAlpha::Linear:
  case MotionAlpha::Squared:
    return screen(alpha, motion);
  case MotionAlpha::SquaredAsPrinted: // from α − 0.025: 13.4
    return screen(maximum(alpha - 0.025f, 0.0f), motion);
  case MotionAlpha::Doubled:
    return alpha + motion;
  case MotionAlpha::Added:
    return minimum(alpha + motion, 1.0f);
  }
  return alpha;
}

/// Everything after the source, whose α stands in `result`, but for what is invalid and asked for by the
/// mask.
template <typename Real>
void compose(const WeightSettings& settings, const WeightInputsOf<Real>& weighed, WeightsOf<Real>& result) {
  result.floor = minWeight(settings, result.base);
  Real alpha = result.base * result.lumaFlicker;
  alpha = alpha * result.nearClamp;
  alpha = alpha * result.historyContrast;
  alpha = alpha * result.relax;
  alpha = alpha * result.sampleDistance;
  alpha = maximum(alpha, result.floor);
  alpha = minimum(alpha, 1.0f);
  alpha = alpha * result.flicker;
  result.motion = motionWeight(settings, weighed, alpha);
  alpha = movedWeight(settings.motion, alpha, result.motion);
  if (settings.velocityChange == Switch::On) alpha = screen(alpha, result.velocityChange);
  if (settings.divergence == Switch::On) alpha = screen(alpha, result.divergence);
  result.byFrameRate = byFrameRate(settings, alpha, weighed.stepSeconds);
}

/// α of what was composed: by κ (manual §22), and no less than the mask and invalid history ask for; more
/// by what is rejected where N decays.
template <typename Real>
Real wholeWeight(const WeightsOf<Real>& weights, const WeightInputsOf<Real>& weighed) {
  if (weighed.isFrozen) return 0.0f;
  const Real asked = maximum(weights.byFrameRate * weighed.confidence, weights.mask);
  return weighed.decays ? minimum(asked + weights.invalid, 1.0f) : maximum(asked, weights.invalid);
}

} // namespace

template <typename Real>
Real confidenceAfter(Real before, const Vec2<Real>& motionPx) {
  const bool isStill = fabs(motionPx.x) < 0.01f && fabs(motionPx.y) < 0.01f; // NaN moves
  return isStill ? before + 10.0f : 1.0f;
}

namespace {

/// What α is composed of.
template <typename Real>
void observeTerms(WeightsOf<Real>& terms) {
  observe(IntermediateId::alphaBase, terms.base);
  observe(IntermediateId::alphaLumaFlicker, terms.lumaFlicker);
  observe(IntermediateId::alphaNearClamp, terms.nearClamp);
  observe(IntermediateId::alphaHistoryContrast, terms.historyContrast);
  observe(IntermediateId::alphaRelax, terms.relax);
  observe(IntermediateId::alphaSampleDistance, terms.sampleDistance);
  observe(IntermediateId::alphaVelocityChange, terms.velocityChange);
  observe(IntermediateId::alphaDivergence, terms.divergence);
  observe(IntermediateId::alphaFlicker, terms.flicker);
  observe(IntermediateId::alphaMask, terms.mask);
  observe(IntermediateId::alphaInvalid, terms.invalid);
}

} // namespace

template <typename Real>
WeightsOf<Real> blendWeight(const WeightSettings& settings, Real historyLength, Real invalid,
                            const WeightInputsOf<Real>& weighed) {
  WeightsOf<Real> result;
  searched<Real>();
  result.base = baseWeight(settings, historyLength, weighed);
  decided<Real>(IntermediateId::alphaBase);
  result.lumaFlicker = lumaFlickerFactor(settings, weighed);
  decided<Real>(IntermediateId::alphaLumaFlicker);
  result.nearClamp = nearClampFactor(settings, weighed);
  decided<Real>(IntermediateId::alphaNearClamp);
  result.historyContrast = historyContrastFactor(settings, weighed);
  decided<Real>(IntermediateId::alphaHistoryContrast);
  result.relax = relaxFactor(weighed);
  result.mask = maskWeight(settings, weighed);
  decided<Real>(IntermediateId::alphaMask);
  result.sampleDistance = sampleDistanceFactor(settings, weighed);
  if (settings.velocityChange == Switch::On)
    result.velocityChange = saturated(weighed.velocityChange / number<Real>(settings.velocityChangeSpeed));
  result.divergence = weighed.divergence;
  result.flicker = flickerFactor(settings, weighed);
  result.invalid = invalid;
  observeTerms(result);
  compose(settings, weighed, result);
  result.alpha = wholeWeight(result, weighed);
  result.channels = Vec3<Real>(result.alpha);
  if (settings.source != AlphaSource::ContrastPerChannel) return result;
  const Vec3<Real> bases = channelWeights(weighed);
  for (int channel = 0; channel < 3; ++channel) {
    WeightsOf<Real> one = result;
    one.base = bases[channel];
    compose(settings, weighed, one);
    result.channels[channel] = wholeWeight(one, weighed);
  }
  return result;
}

template <typename Real>
WeightsOf<Real> blendWeight(const Settings& settings, Real historyLength, Real invalid,
                            const WeightInputsOf<Real>& weighed) {
  WeightsOf<Real> result = blendWeight(settings.weight, historyLength, invalid, weighed);
  if (isTaaOn(settings)) return result;
  result.alpha = 1.0f;
  result.channels = Vec3<Real>(1.0f);
  return result;
}

#define TAA_WEIGHT(Real)                                                                                     \
  template Real confidenceAfter(Real before, const Vec2<Real>& motionPx);                                    \
  template WeightsOf<Real> blendWeight(const Settings& settings, Real historyLength, Real invalid,           \
                                       const WeightInputsOf<Real>& weighed);                                 \
  template WeightsOf<Real> blendWeight(const WeightSettings& settings, Real historyLength, Real invalid,     \
                                       const WeightInputsOf<Real>& weighed);
TAA_EACH_NUMBER(TAA_WEIGHT)
#undef TAA_WEIGHT

} // namespace taa::twin
