// Stories of stage 8: the factors that damp the weight of the current frame, so that it flickers less.
#include "core/story/StoryText.h"

#include "core/base/Say.h"

#include <glm/vec2.hpp>

#include <cmath>
#include <string>

namespace taa::story {

namespace {

/// Whether there is anything to compare with.
std::string whyNot(const Teller& t, Switch isUsed) {
  if (!isOn(isUsed)) return say<"off">();
  return t.details().weighed.hasHistory ? "" : say<"there is no history yet">();
}

RowStory lumaFlickerStory(const Teller& t) {
  if (std::string why = whyNot(t, t.settings().weight.lumaFlicker); !why.empty()) return {why, "", ""};
  return {t.value(Id::alphaLumaFlicker) < 1.0f ? say<"less where luma differs from history">()
                                               : say<"luma is that of history">(),
          t.formula(Id::alphaLumaFlicker), ""};
}

RowStory clampStory(const Teller& t) {
  const twin::WeightInputs& weighed = t.details().weighed;
  if (std::string why = whyNot(t, t.settings().weight.nearClamp); !why.empty()) return {why, "", ""};
  const bool isFlat = !(weighed.boxHigh > weighed.boxLow);
  if (isFlat && weighed.boxHistoryRaw == weighed.boxLow) return {say<"the box has no width">(), "", ""};
  return {t.value(Id::alphaNearClamp) < 1.0f ? say<"less where history is near a wall of the box">()
                                             : say<"history is far from the walls of the box">(),
          t.formula(Id::alphaNearClamp), ""};
}

RowStory contrastStory(const Teller& t) {
  if (std::string why = whyNot(t, t.settings().weight.historyContrast); !why.empty()) return {why, "", ""};
  if (!(t.details().weighed.boxHistory > 0.0f)) return {say<"history is black">(), "", ""};
  return {t.value(Id::alphaHistoryContrast) < 1.0f ? say<"less where the box is large against history">()
                                                   : say<"the box has no width">(),
          t.formula(Id::alphaHistoryContrast), ""};
}

std::string sampleDistanceWords(const Teller& t) {
  const bool isLess = t.value(Id::alphaSampleDistance) < 1.0f;
  const bool isCentered = t.details().weighed.jitterPx == glm::vec2(0.0f);
  switch (t.settings().weight.sampleDistance) {
  case SampleDistance::None:
    break;
  case SampleDistance::Gaussian:
    return isLess ? say<"less the farther the sample is from the center">()
                  : say<"the sample lies at the center">();
  case SampleDistance::GaussianMoving:
    return isLess       ? say<"it moves: less the farther the sample is from the center">()
           : isCentered ? say<"the sample lies at the center">()
                        : say<"all samples count alike where little moves">();
  case SampleDistance::Parabola:
    return isLess       ? say<"less the farther the sample is from the center, unless it moves">()
           : isCentered ? say<"the sample lies at the center">()
                        : say<"it moves">();
  }
  return say<"off">();
}

RowStory sampleDistanceStory(const Teller& t) {
  const bool isUsed = t.settings().weight.sampleDistance != SampleDistance::None;
  return {sampleDistanceWords(t), isUsed ? t.formula(Id::alphaSampleDistance) : "", ""};
}

RowStory relaxStory(const Teller& t) {
  if (!isOn(t.settings().neighborhood.maskRelax)) return {say<"off">(), "", ""};
  return {t.value(Id::alphaRelax) < 1.0f ? say<"less where the mask relaxes the box">() : say<"not masked">(),
          t.formula(Id::alphaRelax), ""};
}

RowStory featureStory(const Teller& t) {
  if (t.value(Id::geometricFlicker) == 0.0f) return {say<"no geometric flicker">(), "", ""};
  return {say<"a single frame may miss a thin feature">(), t.formula(Id::alphaFlicker), ""};
}

} // namespace

RowStory dampingStory(Id id, const Teller& t) {
  switch (id) {
  case Id::alphaLumaFlicker:
    return lumaFlickerStory(t);
  case Id::alphaNearClamp:
    return clampStory(t);
  case Id::alphaHistoryContrast:
    return contrastStory(t);
  case Id::alphaRelax:
    return relaxStory(t);
  case Id::alphaSampleDistance:
    return sampleDistanceStory(t);
  case Id::alphaFlicker:
    return featureStory(t);
  default: // no factor
    return {};
  }
}

} // namespace taa::story
