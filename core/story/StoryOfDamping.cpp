// Stories of stage 8: the factors that damp the weight of the current frame, so that it flickers less.
#include "core/story/StoryText.h"

#include "core/base/Say.h"

#include <glm/vec2.hpp>

#include <cmath>
#include <string>

namespace taa::story {

namespace {

RowStory lumaFlickerStory(const Teller& t) {
  const WeightSettings& weight = t.settings().weight;
  const twin::WeightInputs& weighed = t.details().weighed;
  if (!isOn(weight.lumaFlicker)) return {say<"off">(), "", ""};
  if (!weighed.hasHistory) return {say<"there is no history yet">(), "", ""};
  const bool isCompressed = weight.flickerScale == FlickerScale::Compressed;
  const std::string now =
      t.number(static_cast<double>(isCompressed ? weighed.compressedCurrent : weighed.lumaCurrent));
  const std::string then =
      t.number(static_cast<double>(isCompressed ? weighed.compressedHistory : weighed.lumaHistory));
  const std::string most =
      isCompressed ? call("max", {now, then, "1.001"}) : "(0.001 + " + call("max", {now, then}) + ")";
  return {t.value(Id::alphaLumaFlicker) < 1.0f ? say<"less where luma differs from history">()
                                               : say<"luma is that of history">(),
          t.equals("(1 − |" + now + " − " + then + "| / " + most + ")^2", Id::alphaLumaFlicker), ""};
}

RowStory clampStory(const Teller& t) {
  const twin::WeightInputs& weighed = t.details().weighed;
  if (!isOn(t.settings().weight.nearClamp)) return {say<"off">(), "", ""};
  if (!weighed.hasHistory) return {say<"there is no history yet">(), "", ""};
  const float width = weighed.boxHigh - weighed.boxLow > 0.0f ? weighed.boxHigh - weighed.boxLow : 0.0f;
  const float past = weighed.boxHistoryRaw;
  const float wall = std::fmin(std::fabs(past - weighed.boxLow), std::fabs(past - weighed.boxHigh));
  if (!(wall + width > 0.0f)) return {say<"the box has no width">(), "", ""};
  const std::string far = t.number(static_cast<double>(wall));
  return {
      t.value(Id::alphaNearClamp) < 1.0f ? say<"less where history is near a wall of the box">()
                                         : say<"history is far from the walls of the box">(),
      t.equals(far + " / (" + far + " + " + t.number(static_cast<double>(width)) + ")", Id::alphaNearClamp),
      ""};
}

RowStory contrastStory(const Teller& t) {
  const twin::WeightInputs& weighed = t.details().weighed;
  if (!isOn(t.settings().weight.historyContrast)) return {say<"off">(), "", ""};
  if (!weighed.hasHistory) return {say<"there is no history yet">(), "", ""};
  if (!(weighed.boxHistory > 0.0f)) return {say<"history is black">(), "", ""};
  const float width = weighed.boxHigh - weighed.boxLow > 0.0f ? weighed.boxHigh - weighed.boxLow : 0.0f;
  return {t.value(Id::alphaHistoryContrast) < 1.0f ? say<"less where the box is large against history">()
                                                   : say<"the box has no width">(),
          t.equals("1 / (1 + " + t.number(static_cast<double>(width)) + " / " +
                       t.number(static_cast<double>(weighed.boxHistory)) + ")",
                   Id::alphaHistoryContrast),
          ""};
}

RowStory sampleDistanceStory(const Teller& t) {
  const glm::vec2 jitter = t.details().weighed.jitterPx;
  const std::string squared = "(" + t.number(static_cast<double>(jitter.x)) + ")^2 + (" +
                              t.number(static_cast<double>(jitter.y)) + ")^2";
  switch (t.settings().weight.sampleDistance) {
  case SampleDistance::None:
    return {say<"off">(), "", ""};
  case SampleDistance::Gaussian:
    return {t.value(Id::alphaSampleDistance) < 1.0f ? say<"less the farther the sample is from the center">()
                                                    : say<"the sample lies at the center">(),
            t.equals("exp(−(" + squared + ") / 0.44)", Id::alphaSampleDistance), ""};
  case SampleDistance::GaussianMoving: {
    const std::string moving = "smooth(" + t.number(Id::speed) + ")";
    return {t.value(Id::alphaSampleDistance) < 1.0f
                ? say<"it moves: less the farther the sample is from the center">()
            : jitter == glm::vec2(0.0f) ? say<"the sample lies at the center">()
                                        : say<"all samples count alike where little moves">(),
            t.equals("1 + " + moving + " × (exp(−(" + squared + ") / 0.44) − 1)", Id::alphaSampleDistance),
            ""};
  }
  case SampleDistance::Parabola:
    return {t.value(Id::alphaSampleDistance) < 1.0f
                ? say<"less the farther the sample is from the center, unless it moves">()
            : jitter == glm::vec2(0.0f) ? say<"the sample lies at the center">()
                                        : say<"it moves">(),
            t.equals(call("max", {"smooth(" + t.number(Id::speed) + ")",
                                  call("max", {"1 − (" + squared + ")", "0"})}),
                     Id::alphaSampleDistance),
            ""};
  }
  return {};
}

RowStory relaxStory(const Teller& t) {
  if (!isOn(t.settings().neighborhood.maskRelax)) return {say<"off">(), "", ""};
  return {t.value(Id::alphaRelax) < 1.0f ? say<"less where the mask relaxes the box">() : say<"not masked">(),
          t.equals("1 / (1 + 0.5 × " + t.number(t.details().weighed.relax) + ")", Id::alphaRelax), ""};
}

RowStory featureStory(const Teller& t) {
  if (t.value(Id::geometricFlicker) == 0.0f) return {say<"no geometric flicker">(), "", ""};
  return {say<"a single frame may miss a thin feature">(),
          t.equals(t.number(t.settings().weight.flickerShare), Id::alphaFlicker), ""};
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
