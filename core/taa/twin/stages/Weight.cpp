// Stage 8, blend weight: how much the current frame counts.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/stages/Stages.h"

#include <cmath>

namespace taa::twin {
namespace {

float larger(float a, float b) {
  return a > b ? a : b;
}

float smaller(float a, float b) {
  return a < b ? a : b;
}

/// u² of Lottes and Playdead (catalogue 13.10): 1 where luma is the same.
float likeness(float current, float history) {
  const float most = larger(larger(current, history), 0.2f);
  const float u = 1.0f - std::fabs(current - history) / most;
  return u * u;
}

/// Of a contrast, a range over a color (catalogue 13.14).
float byContrast(float contrast) {
  return 1.0f - (0.25f + 0.6f * saturated(contrast));
}

float baseOf(const WeightSettings& settings, float historyLength, const Seen& seen) {
  switch (settings.source) {
  case AlphaSource::Constant:
    return settings.alpha;
  case AlphaSource::HistoryLength:
    return 1.0f / (historyLength + 1.0f);
  case AlphaSource::LumaDifference:
    return settings.most + likeness(seen.lumaCurrent, seen.lumaHistory) * (settings.least - settings.most);
  case AlphaSource::LumaDifferenceCompressed:
    return settings.most + likeness(seen.maxCurrent, seen.maxHistory) * (settings.least - settings.most);
  case AlphaSource::LumaDifferenceAsPrinted: // D1
    return likeness(seen.maxCurrent, seen.maxHistory);
  case AlphaSource::Contrast:
  case AlphaSource::ContrastPerChannel:
    return byContrast(std::fabs(seen.boxHigh - seen.boxLow) / larger(seen.boxCurrent, 1e-5f));
  case AlphaSource::Confidence:
    return smaller(larger(1.0f / confidenceAfter(historyLength, seen.motion), settings.least), settings.most);
  case AlphaSource::Depth:
    return seen.depth == 0.0f ? 1.0f : 0.025f + (settings.alpha - 0.025f) * std::sqrt(seen.depth);
  }
  return settings.alpha;
}

/// The factors against flicker (catalogue 13.11, 13.13, 13.15).
void calm(const WeightSettings& settings, const Seen& seen, Weights& result) {
  if (!seen.hasHistory) return;
  const float width = seen.boxHigh - seen.boxLow > 0.0f ? seen.boxHigh - seen.boxLow : 0.0f;
  if (settings.lumaFlicker == Switch::On) {
    const bool isCompressed = settings.flickerScale == FlickerScale::Compressed;
    const float current = isCompressed ? seen.compressedCurrent : seen.lumaCurrent;
    const float history = isCompressed ? seen.compressedHistory : seen.lumaHistory;
    const float most = larger(current, history);
    const float rest =
        1.0f - std::fabs(current - history) / (isCompressed ? larger(most, 1.001f) : 0.001f + most);
    result.lumaFlicker = rest * rest;
  }
  if (settings.nearClamp == Switch::On) {
    const float wall =
        smaller(std::fabs(seen.boxHistoryRaw - seen.boxLow), std::fabs(seen.boxHistoryRaw - seen.boxHigh));
    result.nearClamp = wall + width > 0.0f ? wall / (wall + width) : 1.0f;
  }
  if (settings.historyContrast == Switch::On)
    result.historyContrast = seen.boxHistory > 0.0f ? 1.0f / (1.0f + width / seen.boxHistory) : 1.0f;
}

/// By the distance of the sample to the pixel's center (catalogue 7.7, 13.6).
float sampleDistanceOf(const WeightSettings& settings, const Seen& seen) {
  const double x = static_cast<double>(seen.jitterPx.x), y = static_cast<double>(seen.jitterPx.y);
  const double squared = x * x + y * y;
  if (settings.sampleDistance == SampleDistance::Gaussian)
    return static_cast<float>(std::exp(-squared / (2.0 * 0.22)));
  if (settings.sampleDistance == SampleDistance::None) return 1.0f;
  const float t = saturated(seen.speed);
  const float moving = (t * t) * (3.0f - 2.0f * t);
  if (settings.sampleDistance == SampleDistance::GaussianMoving)
    return 1.0f + moving * (static_cast<float>(std::exp(-squared / (2.0 * 0.22))) - 1.0f);
  return larger(moving, static_cast<float>(squared < 1.0 ? 1.0 - squared : 0.0));
}

/// 1 − (1 − α)^(e/8) by whole powers and square roots, e the nearest eighth to Δt/Δt₀ (catalogue 13.19).
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

/// What motion adds to α (catalogue 13.4 to 13.6).
float motionTerm(const WeightSettings& settings, const Seen& seen, float alpha) {
  const float speed = speedIn(settings.motionSpeedIn, seen.speed, seen.motion, seen.picturePx);
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
    return saturated(seen.motionUv.x * seen.motionUv.x + seen.motionUv.y * seen.motionUv.y);
  case MotionAlpha::Doubled:
    return x * (smaller(2.0f * alpha, 1.0f) - alpha);
  }
  return 0.0f;
}

/// The least that the mask asks for (catalogue 13.18, 21.4).
float maskTerm(const WeightSettings& settings, const Seen& seen) {
  switch (settings.mask) {
  case MaskAlpha::Off:
    return 0.0f;
  case MaskAlpha::Responsive:
    return settings.maskAlpha * larger(seen.mask.x, seen.mask.y);
  case MaskAlpha::Reactive:
    return seen.mask.x;
  case MaskAlpha::Exclude:
    return seen.mask.y > 0.0f ? 1.0f : 0.0f;
  }
  return 0.0f;
}

/// Everything after the source, whose α stands in `result`, but for what is invalid and asked for by the
/// mask.
void compose(const WeightSettings& settings, const Seen& seen, Weights& result) {
  result.floor = settings.source == AlphaSource::HistoryLength ? settings.minimum
                                                               : smaller(result.base, settings.minimum);
  float alpha = result.base * result.lumaFlicker;
  alpha = alpha * result.nearClamp;
  alpha = alpha * result.historyContrast;
  alpha = alpha * result.relax;
  alpha = alpha * result.sampleDistance;
  alpha = larger(alpha, result.floor);
  alpha = alpha < 1.0f ? alpha : 1.0f;
  alpha = alpha * result.flicker;
  result.motion = motionTerm(settings, seen, alpha);
  const auto join = [&alpha](float term) { alpha = 1.0f - (1.0f - alpha) * (1.0f - term); };
  if (settings.motion == MotionAlpha::SquaredAsPrinted) alpha = larger(alpha - 0.025f, 0.0f); // 13.4
  if (settings.motion == MotionAlpha::Doubled) {
    alpha = alpha + result.motion;
  } else if (settings.motion == MotionAlpha::Added) {
    alpha = smaller(alpha + result.motion, 1.0f);
  } else if (settings.motion != MotionAlpha::None) {
    join(result.motion);
  }
  if (settings.velocityChange == Switch::On) join(result.velocityChange);
  if (settings.divergence == Switch::On) join(result.divergence);
  result.byFrameRate = byFrameRate(settings, alpha, seen.stepSeconds);
}

/// α of what was composed: by κ (catalogue §22), and no less than the mask and invalid history ask for; more
/// by what is rejected where N decays.
float alphaOf(const Weights& weights, const Seen& seen) {
  if (seen.isFrozen) return 0.0f;
  const float asked = larger(weights.byFrameRate * seen.confidence, weights.mask);
  return seen.decays ? smaller(asked + weights.invalid, 1.0f) : larger(asked, weights.invalid);
}

} // namespace

float confidenceAfter(float before, const glm::vec2& motionPx) {
  const bool isStill = std::fabs(motionPx.x) < 0.01f && std::fabs(motionPx.y) < 0.01f; // NaN moves
  return isStill ? before + 10.0f : 1.0f;
}

Weights weigh(const WeightSettings& settings, float historyLength, float invalid, const Seen& seen) {
  Weights result;
  result.base = baseOf(settings, historyLength, seen);
  calm(settings, seen, result);
  result.relax = 1.0f / (1.0f + 0.5f * seen.relax);
  result.mask = maskTerm(settings, seen);
  result.sampleDistance = sampleDistanceOf(settings, seen);
  if (settings.velocityChange == Switch::On)
    result.velocityChange = saturated(seen.velocityChange / settings.velocityChangeSpeed);
  result.divergence = seen.divergence;
  result.flicker = seen.isFlicker ? settings.flickerShare : 1.0f;
  result.invalid = invalid;
  compose(settings, seen, result);
  result.alpha = alphaOf(result, seen);
  result.channels = glm::vec3(result.alpha);
  if (settings.source != AlphaSource::ContrastPerChannel) return result;
  for (int channel = 0; channel < 3; ++channel) {
    Weights one = result;
    one.base = byContrast(seen.contrast[channel]);
    compose(settings, seen, one);
    result.channels[channel] = alphaOf(one, seen);
  }
  return result;
}

Weights weigh(const Settings& settings, float historyLength, float invalid, const Seen& seen) {
  Weights result = weigh(settings.weight, historyLength, invalid, seen);
  if (isTaaOn(settings)) return result;
  result.alpha = 1.0f;
  result.channels = glm::vec3(1.0f);
  return result;
}

} // namespace taa::twin
