// Stage 9, blend: current and history mixed, and how many frames' worth of samples that holds.
#include "core/base/Half.h"
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

namespace taa::reference {
namespace {

float blendFactor(float alpha, float toneWeightCurrent, float toneWeightHistory, ToneWeight tone) {
  if (alpha >= 1.0f) return 1.0f;
  if (tone != ToneWeight::Luma && tone != ToneWeight::LumaAsPrinted) return alpha;
  const float current = alpha * toneWeightCurrent;
  return current / (current + (1.0f - alpha) * toneWeightHistory);
}

/// 1/(1 + L); as printed (D19) of the color divided by 1 + its largest channel.
float toneWeight(const glm::vec3& color, ToneWeight tone) {
  if (tone == ToneWeight::Luma) return 1.0f / (1.0f + luma(color));
  if (tone == ToneWeight::LumaAsPrinted) return 1.0f / (1.0f + luma(compress(color, ToneSpace::MaxChannel)));
  return 1.0f;
}

/// The mix itself, of compressed colors where the choice says so (catalogue 15.3, 15.4). `keepsHistory`: a
/// share of 0 leaves it as it is, even then (invariant 65).
glm::vec3 mix(const glm::vec3& current, const glm::vec3& history, float k, ToneWeight tone,
              bool keepsHistory) {
  if (k >= 1.0f) return current;
  if (k <= 0.0f && keepsHistory) return history;
  if (tone != ToneWeight::ReinhardChannel && tone != ToneWeight::MaxChannel)
    return history + k * (current - history);
  if (current == history) return history;
  const ToneSpace space =
      tone == ToneWeight::ReinhardChannel ? ToneSpace::ReinhardChannel : ToneSpace::MaxChannel;
  const glm::vec3 from = compress(history, space);
  return decompress(from + k * (compress(current, space) - from), space);
}

/// N after the frame (catalogue §16).
float lengthAfter(float alpha, float before, float confidence, LengthRule rule) {
  if (alpha >= 1.0f) return 1.0f;
  if (rule == LengthRule::Count) return before + confidence;
  const float rest = 1.0f - alpha;
  const float variance = alpha * alpha + (rest * rest) / before;
  return rule == LengthRule::VarianceAsPrinted ? variance : 1.0f / variance;
}

} // namespace

Blended blend(const Settings& settings, const glm::vec3& current, const glm::vec3& history, float alpha,
              float historyLength, float confidence) {
  Blended result;
  result.toneWeightCurrent = toneWeight(current, settings.blend.tone);
  result.toneWeightHistory = toneWeight(history, settings.blend.tone);
  result.factor = blendFactor(alpha, result.toneWeightCurrent, result.toneWeightHistory, settings.blend.tone);
  const glm::vec3 mixed = mix(current, history, result.factor, settings.blend.tone, isUpsampled(settings));
  for (int i = 0; i < 3; ++i) {
    const float channel = isBad(mixed[i]) ? current[i] : mixed[i];
    result.resolved[i] = settings.history.precision == Precision::Half ? roundedToHalf(channel) : channel;
  }
  result.historyLength = lengthAfter(alpha, historyLength, confidence, settings.blend.length);
  return result;
}

} // namespace taa::reference
