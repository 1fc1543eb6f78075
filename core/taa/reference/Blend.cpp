// Stage 9, blend: current and history mixed, and how many frames' worth of samples that holds.
#include "core/base/Half.h"
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

namespace taa::reference {
namespace {

float blendFactor(float alpha, float toneWeightCurrent, float toneWeightHistory, ToneWeight tone) {
  if (alpha >= 1.0f) return 1.0f;
  if (tone == ToneWeight::None) return alpha;
  const float current = alpha * toneWeightCurrent;
  return current / (current + (1.0f - alpha) * toneWeightHistory);
}

} // namespace

Blended blend(const Settings& settings, const glm::vec3& current, const glm::vec3& history, float alpha,
              float historyLength) {
  Blended result;
  if (settings.blend.tone == ToneWeight::Luma) {
    result.toneWeightCurrent = 1.0f / (1.0f + luma(current));
    result.toneWeightHistory = 1.0f / (1.0f + luma(history));
  }
  result.factor = blendFactor(alpha, result.toneWeightCurrent, result.toneWeightHistory, settings.blend.tone);
  const float k = result.factor;
  const glm::vec3 mixed = k >= 1.0f ? current : history + k * (current - history);
  for (int i = 0; i < 3; ++i) {
    const float channel = isBad(mixed[i]) ? current[i] : mixed[i];
    result.resolved[i] = settings.history.precision == Precision::Half ? roundedToHalf(channel) : channel;
  }
  const float rest = 1.0f - alpha;
  result.historyLength = alpha >= 1.0f ? 1.0f : 1.0f / (alpha * alpha + (rest * rest) / historyLength);
  return result;
}

} // namespace taa::reference
