// Stage 8, blend weight: how much the current frame counts.
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

#include <cmath>

namespace taa::reference {
namespace {

float larger(float a, float b) {
  return a > b ? a : b;
}

float smaller(float a, float b) {
  return a < b ? a : b;
}

/// u² of Lottes and Playdead (catalogue 13.10): 1 where luma is the same.
float likeness(const Seen& seen) {
  const float most = larger(larger(seen.lumaCurrent, seen.lumaHistory), 0.2f);
  const float u = 1.0f - std::fabs(seen.lumaCurrent - seen.lumaHistory) / most;
  return u * u;
}

float baseOf(const WeightSettings& settings, float historyLength, const Seen& seen) {
  switch (settings.source) {
  case AlphaSource::Constant:
    return settings.alpha;
  case AlphaSource::HistoryLength:
    return 1.0f / (historyLength + 1.0f);
  case AlphaSource::LumaDifference:
    return settings.most + likeness(seen) * (settings.least - settings.most);
  case AlphaSource::LumaDifferenceAsPrinted:
    return likeness(seen);
  case AlphaSource::Contrast: {
    const float contrast = std::fabs(seen.boxHigh - seen.boxLow) / larger(seen.boxCurrent, 1e-5f);
    return 1.0f - (0.25f + 0.6f * saturated(contrast));
  }
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
    const float rest = 1.0f - std::fabs(seen.lumaCurrent - seen.lumaHistory) /
                                  (0.001f + larger(seen.lumaCurrent, seen.lumaHistory));
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

/// What motion adds (catalogue 13.4 to 13.6).
float motionTerm(const WeightSettings& settings, const Seen& seen) {
  const float x = saturated(seen.speed / settings.motionSpeed);
  switch (settings.motion) {
  case MotionAlpha::None:
    return 0.0f;
  case MotionAlpha::Linear:
    return x;
  case MotionAlpha::Squared:
    return x * x;
  case MotionAlpha::SquaredAsPrinted: // fractions of the picture: D11
    return saturated(seen.motionUv.x * seen.motionUv.x + seen.motionUv.y * seen.motionUv.y);
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

} // namespace

Weights weigh(const WeightSettings& settings, float historyLength, float invalid, const Seen& seen) {
  Weights result;
  result.base = baseOf(settings, historyLength, seen);
  result.floor = settings.source == AlphaSource::HistoryLength ? settings.minimum
                                                               : smaller(result.base, settings.minimum);
  calm(settings, seen, result);
  result.relax = 1.0f / (1.0f + 0.5f * seen.relax);
  result.motion = motionTerm(settings, seen);
  result.mask = maskTerm(settings, seen);
  if (settings.velocityChange == Switch::On)
    result.velocityChange = saturated(seen.velocityChange / settings.velocityChangeSpeed);
  result.divergence = seen.divergence;
  result.invalid = invalid;
  float alpha = result.base * result.lumaFlicker;
  alpha = alpha * result.nearClamp;
  alpha = alpha * result.historyContrast;
  alpha = alpha * result.relax;
  alpha = larger(alpha, result.floor);
  alpha = alpha < 1.0f ? alpha : 1.0f;
  const auto join = [&alpha](float term) { alpha = 1.0f - (1.0f - alpha) * (1.0f - term); };
  if (settings.motion != MotionAlpha::None) join(result.motion);
  if (settings.velocityChange == Switch::On) join(result.velocityChange);
  if (settings.divergence == Switch::On) join(result.divergence);
  alpha = alpha * seen.confidence; // catalogue §22
  result.alpha = larger(larger(alpha, result.mask), result.invalid);
  return result;
}

} // namespace taa::reference
