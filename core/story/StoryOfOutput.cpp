// Stories of stage 10 and of the reference: what is shown of the mix, and how far it is from what it should
// be.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Known.h"

#include <array>
#include <string>

namespace taa::story {

namespace {

/// What was done to the resolved color.
std::string shownWords(const Teller& t) {
  const OutputSettings& output = t.settings().output;
  const bool isCovered = t.value(Id::overlayAlpha) > 0.0f || t.color(Id::overlay) != glm::vec3(0.0f);
  const bool isBlurred = t.value(Id::blurTrust) < 1.0f;
  const std::string label = choiceLabel("output.sharpen", t.settings());
  std::string words = output.sharpen == Sharpen::Mitchell ? say<"the resolved color filtered: %1">(label)
                                                          : say<"the resolved color sharpened: %1">(label);
  if (output.sharpen == Sharpen::None)
    words = isCovered || isBlurred ? say<"the resolved color">() : say<"the resolved color as it is">();
  else if (isCovered || isBlurred)
    words = say<"the sharpened color">();
  if (isBlurred)
    words = say<"%1, %2 blurred along its motion">(
        words, t.percent(1.0 - static_cast<double>(t.value(Id::blurTrust))));
  if (isCovered) words = say<"%1, the overlay over it">(words);
  return isOn(output.dither) ? say<"%1, and noise of a step of 8 bits for the screen">(words) : words;
}

RowStory detailStory(const Teller& t) {
  if (t.settings().output.sharpen == Sharpen::None) return {say<"off">(), "", ""};
  const float detail = t.value(Id::sharpenDetail);
  return t.story(
      detail > 0   ? say<"made brighter: luma of the sharpened color less that of the resolved one">()
      : detail < 0 ? say<"made darker: luma of the sharpened color less that of the resolved one">()
                   : say<"luma of the sharpened color is that of the resolved one">(),
      Id::sharpenDetail);
}

RowStory trustStory(const Teller& t) {
  if (!isOn(t.settings().output.motionBlur)) return {say<"off">(), "", ""};
  if (t.value(Id::speed) >= kNoPreviousPosition) return {say<"the motion is not known">(), "", ""};
  return t.story(t.value(Id::blurTrust) < 1.0f ? say<"fast surfaces are blurred along their motion">()
                                               : say<"not blurred: it is no faster than 2 px a frame">(),
                 Id::blurTrust);
}

RowStory relativeStory(const glm::vec3& is, const glm::vec3& should, const Teller& t) {
  std::string sum;
  for (int i = 0; i < 3; ++i) {
    const std::string reference = t.number(should[i]);
    sum += sum.empty() ? "(" : " + ";
    sum += "(" + t.number(is[i]) + " − " + reference + ")^2 / (" + reference + "^2 + 0.01)";
  }
  return {say<"the squared difference over the reference's own square, the mean of red, green and blue">(),
          t.equals(sum + ") / 3", Id::relativeError), ""};
}

RowStory errorStory(Id id, const Teller& t) {
  if (!twin::isKnown(t.probed.record, Id::reference)) return {say<"there is no reference yet">(), "", ""};
  const glm::vec3 is = t.color(Id::output), should = t.color(Id::reference);
  switch (id) {
  case Id::reference:
    return {say<"the mean of the reference's samples of this instant">(), "", ""};
  case Id::referenceError: {
    const std::string words =
        t.value(id) > 0   ? say<"too bright: luma of the output less luma of the reference">()
        : t.value(id) < 0 ? say<"too dark: luma of the output less luma of the reference">()
                          : say<"as it should be: luma of the output less luma of the reference">();
    return {words, t.equals(t.number(twin::luma(is)) + " − " + t.number(twin::luma(should)), id), ""};
  }
  case Id::referenceErrorAbs: {
    std::array<std::string, 3> channels;
    for (int i = 0; i < 3; ++i)
      channels[static_cast<std::size_t>(i)] = "|" + t.number(is[i]) + " − " + t.number(should[i]) + "|";
    return {say<"the largest difference of red, green and blue">(), t.equals(call("max", channels), id), ""};
  }
  case Id::relativeError:
    return relativeStory(is, should, t);
  case Id::flip:
    return {t.value(id) == 0.0f ? say<"nothing of the difference is seen">()
                                : say<"what is seen of the difference from the reference here, of 1">(),
            "", ""};
  case Id::ssimMap:
    return {t.value(id) == 0.0f ? say<"its structure is that of the reference">()
                                : say<"how unlike the reference's structure it is, in 11 × 11 pixels">(),
            "", ""};
  default: // no error
    return {};
  }
}

RowStory engineStory(Id id, const Teller& t) {
  if (!twin::isKnown(t.probed.record, Id::engineOutput))
    return {say<"there is no output of an engine">(), "", ""};
  const glm::vec3 is = t.color(Id::resolved), other = t.color(Id::engineOutput);
  if (id == Id::engineOutput) return {say<"what the engine's own TAA made of this frame">(), "", ""};
  if (id == Id::engineDifference) {
    const std::string words =
        t.value(id) > 0
            ? say<"brighter than the engine's: luma of the resolved color less luma of its output">()
        : t.value(id) < 0
            ? say<"darker than the engine's: luma of the resolved color less luma of its output">()
            : say<"as bright as the engine's: luma of the resolved color less luma of its output">();
    return {words, t.equals(t.number(twin::luma(is)) + " − " + t.number(twin::luma(other)), id), ""};
  }
  std::array<std::string, 3> channels;
  for (int i = 0; i < 3; ++i)
    channels[static_cast<std::size_t>(i)] = "|" + t.number(is[i]) + " − " + t.number(other[i]) + "|";
  return {say<"the largest difference of red, green and blue">(), t.equals(call("max", channels), id), ""};
}

} // namespace

RowStory outputStory(Id id, const Teller& t) {
  if (overTime(id) == OverTime::Flicker) return flickerStory(id, t);
  if (overTime(id) == OverTime::Parts) return partsStory(id, t);
  if (isOfEngine(id)) return engineStory(id, t);
  if (isOfReference(id)) return errorStory(id, t);
  if (id == Id::sharpenDetail) return detailStory(t);
  return id == Id::blurTrust ? trustStory(t) : t.story(shownWords(t), id);
}

} // namespace taa::story
