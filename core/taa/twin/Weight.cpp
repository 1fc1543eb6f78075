// Stage 8, blend weight: how much the current frame counts.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <cmath>

namespace taa::twin {
namespace {

/// u² of Lottes and Playdead (manual 13.10): 1 where luma is the same.
float lumaLikeness(float current, float history) {
  const float most = maximum(maximum(current, history), 0.2f);
  const float u = 1.0f - std::fabs(current - history) / most;
  return u * u;
}

/// Of a contrast, a range over a color (manual 13.14).
float contrastWeight(float contrast) {
  return 1.0f - (0.25f + 0.6f * saturated(contrast));
}

/// The same of each channel, by the range of the nine samples (manual 13.14, 14.2).
glm::vec3 channelWeights(const WeightInputs& weighed) {
  return {contrastWeight(weighed.contrast.x), contrastWeight(weighed.contrast.y),
          contrastWeight(weighed.contrast.z)};
}

float baseWeight(const WeightSettings& settings, float historyLength, const WeightInputs& weighed) {
  switch (settings.source) {
  case AlphaSource::Constant:
    return settings.alpha;
  case AlphaSource::HistoryLength:
    return 1.0f / (historyLength + 1.0f);
  case AlphaSource::LumaDifference:
    return settings.sourceMax +
           lumaLikeness(weighed.lumaCurrent, weighed.lumaHistory) * (settings.sourceMin - settings.sourceMax);
  case AlphaSource::LumaDifferenceCompressed:
    return settings.sourceMax +
           lumaLikeness(weighed.maxCurrent, weighed.maxHistory) * (settings.sourceMin - settings.sourceMax);
  case AlphaSource::LumaDifferenceAsPrinted: // D1
    return lumaLikeness(weighed.maxCurrent, weighed.maxHistory);
  case AlphaSource::Contrast:
  case AlphaSource::ContrastPerChannel:
    return contrastWeight(std::fabs(weighed.boxHigh - weighed.boxLow) / maximum(weighed.boxCurrent, 1e-5f));
  case AlphaSource::Confidence:
    return minimum(maximum(1.0f / confidenceAfter(historyLength, weighed.motion), settings.sourceMin),
                   settings.sourceMax);
  case AlphaSource::Depth:
    return weighed.depth == 0.0f ? 1.0f : 0.025f + (settings.alpha - 0.025f) * std::sqrt(weighed.depth);
  }
  return settings.alpha;
}

float boxWidth(const WeightInputs& weighed) {
  const float width = weighed.boxHigh - weighed.boxLow;
  return width > 0.0f ? width : 0.0f;
}

/// Against flicker where luma differs (manual 13.11).
float lumaFlickerFactor(const WeightSettings& settings, const WeightInputs& weighed) {
  if (settings.lumaFlicker == Switch::Off || !weighed.hasHistory) return 1.0f;
  const bool isCompressed = settings.flickerScale == FlickerScale::Compressed;
  const float current = isCompressed ? weighed.compressedCurrent : weighed.lumaCurrent;
  const float history = isCompressed ? weighed.compressedHistory : weighed.lumaHistory;
  const float largest = maximum(current, history);
  const float rest =
      1.0f - std::fabs(current - history) / (isCompressed ? maximum(largest, 1.001f) : 0.001f + largest);
  return rest * rest;
}

/// Where history is near a wall of the box (manual 13.13).
float nearClampFactor(const WeightSettings& settings, const WeightInputs& weighed) {
  if (settings.nearClamp == Switch::Off || !weighed.hasHistory) return 1.0f;
  const float wall = minimum(std::fabs(weighed.boxHistoryRaw - weighed.boxLow),
                             std::fabs(weighed.boxHistoryRaw - weighed.boxHigh));
  const float sum = wall + boxWidth(weighed);
  return sum > 0.0f ? wall / sum : 1.0f;
}

/// Where the box is large against history (manual 13.15).
float historyContrastFactor(const WeightSettings& settings, const WeightInputs& weighed) {
  if (settings.historyContrast == Switch::Off || !weighed.hasHistory) return 1.0f;
  return weighed.boxHistory > 0.0f ? 1.0f / (1.0f + boxWidth(weighed) / weighed.boxHistory) : 1.0f;
}

/// Where the mask widens the box (manual 13.18).
float relaxFactor(const WeightInputs& weighed) {
  return 1.0f / (1.0f + 0.5f * weighed.relax);
}

/// Where a single frame may miss what is there (manual 13.9).
float flickerFactor(const WeightSettings& settings, const WeightInputs& weighed) {
  return weighed.isFlicker ? settings.flickerShare : 1.0f;
}

/// The least that is left of α: no more than a source gives by itself, but 1/(N+1) is raised to it.
float minWeight(const WeightSettings& settings, float base) {
  return settings.source == AlphaSource::HistoryLength ? settings.minimum : minimum(base, settings.minimum);
}

/// As the blend mode "screen" mixes.
float screen(float a, float b) {
  return 1.0f - (1.0f - a) * (1.0f - b);
}

/// By the distance of the sample to the pixel's center (manual 7.7, 13.6).
float sampleDistanceFactor(const WeightSettings& settings, const WeightInputs& weighed) {
  const double x = static_cast<double>(weighed.jitterPx.x), y = static_cast<double>(weighed.jitterPx.y);
  const double squared = x * x + y * y;
  const auto bell = [squared] { return static_cast<float>(std::exp(-squared / (2.0 * 0.22))); };
  const float t = saturated(weighed.speed);
  const float moving = (t * t) * (3.0f - 2.0f * t);
  switch (settings.sampleDistance) {
  case SampleDistance::None:
    break;
  case SampleDistance::Gaussian:
    return bell();
  case SampleDistance::Parabola:
    return maximum(moving, static_cast<float>(squared < 1.0 ? 1.0 - squared : 0.0));
  case SampleDistance::GaussianMoving:
    return 1.0f + moving * (bell() - 1.0f);
  }
  return 1.0f;
}

/// 1 − (1 − α)^(e/8) by whole powers and square roots, e the nearest eighth to Δt/Δt₀ (manual 13.19).
float byFrameRate(const WeightSettings& settings, float alpha, double stepSeconds) {
  if (settings.frameRate == Switch::Off) return alpha;
  double eighths = std::round(stepSeconds * static_cast<double>(settings.referenceRate) * 8.0);
  eighths = eighths < 1.0 ? 1.0 : eighths > 64.0 ? 64.0 : eighths;
  if (eighths == 8.0) return alpha;
  const float kept = 1.0f - alpha;
  float power = 1.0f;
  for (; eighths >= 8.0; eighths -= 8.0) power = power * kept;
  float root = kept;
  for (double share = 4.0; share >= 1.0; share /= 2.0) {
    root = std::sqrt(root);
    if (eighths < share) continue;
    eighths -= share;
    power = power * root;
  }
  return 1.0f - power;
}

/// What motion adds to α (manual 13.4 to 13.6).
float motionWeight(const WeightSettings& settings, const WeightInputs& weighed, float alpha) {
  const float speed = speedIn(settings.motionSpeedIn, weighed.speed, weighed.motion, weighed.picturePx);
  const float x = saturated(speed / settings.motionSpeed);
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
float maskWeight(const WeightSettings& settings, const WeightInputs& weighed) {
  switch (settings.mask) {
  case MaskAlpha::Off:
    return 0.0f;
  case MaskAlpha::Responsive:
    return settings.maskAlpha * maximum(weighed.mask.x, weighed.mask.y);
  case MaskAlpha::Reactive:
    return weighed.mask.x;
  case MaskAlpha::Exclude:
    return weighed.mask.y > 0.0f ? 1.0f : 0.0f;
  }
  return 0.0f;
}

/// α with what motion adds to it.
float movedWeight(MotionAlpha chosen, float alpha, float motion) {
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
void compose(const WeightSettings& settings, const WeightInputs& weighed, Weights& result) {
  result.floor = minWeight(settings, result.base);
  float alpha = result.base * result.lumaFlicker;
  alpha = alpha * result.nearClamp;
  alpha = alpha * result.historyContrast;
  alpha = alpha * result.relax;
  alpha = alpha * result.sampleDistance;
  alpha = maximum(alpha, result.floor);
  alpha = alpha < 1.0f ? alpha : 1.0f;
  alpha = alpha * result.flicker;
  result.motion = motionWeight(settings, weighed, alpha);
  alpha = movedWeight(settings.motion, alpha, result.motion);
  if (settings.velocityChange == Switch::On) alpha = screen(alpha, result.velocityChange);
  if (settings.divergence == Switch::On) alpha = screen(alpha, result.divergence);
  result.byFrameRate = byFrameRate(settings, alpha, weighed.stepSeconds);
}

/// α of what was composed: by κ (manual §22), and no less than the mask and invalid history ask for; more
/// by what is rejected where N decays.
float wholeWeight(const Weights& weights, const WeightInputs& weighed) {
  if (weighed.isFrozen) return 0.0f;
  const float asked = maximum(weights.byFrameRate * weighed.confidence, weights.mask);
  return weighed.decays ? minimum(asked + weights.invalid, 1.0f) : maximum(asked, weights.invalid);
}

} // namespace

float confidenceAfter(float before, const glm::vec2& motionPx) {
  const bool isStill = std::fabs(motionPx.x) < 0.01f && std::fabs(motionPx.y) < 0.01f; // NaN moves
  return isStill ? before + 10.0f : 1.0f;
}

Weights blendWeight(const WeightSettings& settings, float historyLength, float invalid,
                    const WeightInputs& weighed) {
  Weights result;
  result.base = baseWeight(settings, historyLength, weighed);
  result.lumaFlicker = lumaFlickerFactor(settings, weighed);
  result.nearClamp = nearClampFactor(settings, weighed);
  result.historyContrast = historyContrastFactor(settings, weighed);
  result.relax = relaxFactor(weighed);
  result.mask = maskWeight(settings, weighed);
  result.sampleDistance = sampleDistanceFactor(settings, weighed);
  if (settings.velocityChange == Switch::On)
    result.velocityChange = saturated(weighed.velocityChange / settings.velocityChangeSpeed);
  result.divergence = weighed.divergence;
  result.flicker = flickerFactor(settings, weighed);
  result.invalid = invalid;
  compose(settings, weighed, result);
  result.alpha = wholeWeight(result, weighed);
  result.channels = glm::vec3(result.alpha);
  if (settings.source != AlphaSource::ContrastPerChannel) return result;
  const glm::vec3 bases = channelWeights(weighed);
  for (int channel = 0; channel < 3; ++channel) {
    Weights one = result;
    one.base = bases[channel];
    compose(settings, weighed, one);
    result.channels[channel] = wholeWeight(one, weighed);
  }
  return result;
}

Weights blendWeight(const Settings& settings, float historyLength, float invalid,
                    const WeightInputs& weighed) {
  Weights result = blendWeight(settings.weight, historyLength, invalid, weighed);
  if (isTaaOn(settings)) return result;
  result.alpha = 1.0f;
  result.channels = glm::vec3(1.0f);
  return result;
}

} // namespace taa::twin
