// Story of stage 7: history brought into the box.
#include "core/story/FormulaText.h"
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/twin/Color.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>
#include <string>

namespace taa::story {

std::string targetText(RectifyMethod method) {
  // The twin is asked in a box in which the three are different points.
  twin::Neighborhood box;
  box.boxMax = glm::vec3(4.0f);
  box.mean = glm::vec3(1.0f);
  const glm::vec3 current(3.0f);
  const auto target = twin::rectifyTarget(method, current, box);
  if (target == box.mean) return say<"the mean">();
  return target == current ? say<"the current color">() : say<"the middle of the box">();
}

namespace {

bool isRectified(const Teller& t) {
  return t.settings().rectify.method != RectifyMethod::None && !t.details().isFirst;
}

/// Whether it would be, with all of the correction.
bool isMoved(const Teller& t) {
  if (t.value(Id::clipAmount) > 0.0f || t.color(Id::historyRectified) != t.color(Id::historyRaw)) return true;
  return t.details().trace && std::ranges::any_of(t.details().trace->rectifiedBox,
                                                  [](const twin::Operand& x) { return x.value != 0.0; });
}

/// Whether a part of the correction is applied: at rest, or at geometric flicker.
bool isPartial(const Teller& t) {
  return isOn(t.settings().rectify.relaxAtRest) || t.value(Id::rectifyStrength) < 1.0f;
}

/// How far history was pulled, and what that is a part of.
std::string pulledWords(const Teller& t) {
  const std::string target = targetText(t.settings().rectify.method);
  const std::string amount = t.percent(Id::clipAmount), applied = t.percent(Id::rectifyStrength);
  const std::string held = t.percent(static_cast<double>(t.details().lockState.protection));
  const bool isRelaxed = t.value(Id::rectifyStrength)<1.0f, isHeld = t.details().lockState.protection> 0.0f;
  if (!(t.value(Id::clipAmount) > 0.0f))
    return say<"outside of the box, but nothing of the correction is applied">();
  const std::string words = say<"pulled %1 of the way to %2">(amount, target);
  if (isRelaxed && isHeld)
    return say<"%1: %2 of the correction, of which %3 are taken back">(words, applied, held);
  if (isRelaxed) return say<"%1: %2 of the correction">(words, applied);
  if (isHeld) return say<"%1: the correction, of which %2 are taken back">(words, held);
  return words;
}

/// Where the printed way back from box space cuts channels off (manual §26, D7), how it does; else nothing.
RowStory cutOffStory(const Teller& t, const glm::vec3& moved, const std::string& words) {
  const SpaceSettings& space = t.settings().space;
  const SpaceSettings axes{twin::withoutClamp(space).color, ToneSpace::Linear};
  const glm::vec3 before = twin::fromBox(moved, axes);
  const glm::vec3 after = glm::clamp(before, 0.0f, 1.0f);
  if (space.color != ColorSpace::YCoCgAsPrinted || before == after) return {};
  return {say<"%1, and cut off on the way back, as printed">(words),
          call("clamp", {t.tuple(before), "0", "1"}) + " = " +
              t.tuple(twin::compress(t.color(Id::historyRectified), space.tone)),
          say<"compressed as in the box">()};
}

/// Which sample takes the place of history.
std::string selectedWords(const Teller& t) {
  const std::size_t k = twin::nearestSample(t.box(t.color(Id::historyRaw)), t.details().neighborhood);
  if (k == 4) return say<"of the nine samples the pixel's own is nearest to history">();
  const int number = static_cast<int>(k);
  const std::string step = t.tuple(glm::vec2(glm::ivec2(number % 3 - 1, number / 3 - 1)));
  return say<"of the nine samples that at %1 is nearest to history">(step);
}

/// Some methods leave history where it is outside of the box, too.
std::string keptWords(const Teller& t) {
  const RectifyMethod method = t.settings().rectify.method;
  if (method == RectifyMethod::Select) return say<"history is one of the nine samples: kept as it is">();
  if (method == RectifyMethod::ClipToHull || method == RectifyMethod::ClipToBoth)
    return say<"history lies within the slabs around the samples: kept as it is">();
  const twin::Neighborhood& hood = t.details().neighborhood;
  const glm::vec3 h = t.box(t.color(Id::historyRaw));
  if (h != glm::clamp(h, hood.boxMin, hood.boxMax))
    return say<"no wall of the box is hit on the way to the current color: kept as it is">();
  return say<"history lies inside the box: kept as it is">();
}

/// Where all of the correction leads, in box space.
RowStory boxedStory(const Teller& t, const std::string& words) {
  if (!t.details().trace) return {words, "", ""};
  const auto& to = t.details().trace->rectifiedBox;
  const glm::dvec3 moved(to[0].value, to[1].value, to[2].value);
  if (RowStory cutOff = cutOffStory(t, glm::vec3(moved), words); !cutOff.words.empty()) return cutOff;
  const auto text = formulaText(*t.details().trace, to, {t.digits});
  if (!text) return {words, "", ""};
  return {words, *text + " = " + t.tuple(glm::vec3(moved)), say<"in box space">()};
}

RowStory rectifiedStory(const Teller& t) {
  const RectifySettings& rectify = t.settings().rectify;
  if (t.details().isFirst) return {say<"there is no history yet">(), "", ""};
  if (rectify.method == RectifyMethod::None) return {say<"history is taken as it is">(), "", ""};
  if (!isMoved(t)) return {keptWords(t), "", ""};
  const bool isSelected = rectify.method == RectifyMethod::Select;
  const std::string words = isSelected ? selectedWords(t) : pulledWords(t);
  if (isSelected || isPartial(t) || t.details().lockState.protection > 0.0f)
    return t.story(words, Id::historyRectified);
  return boxedStory(t, words);
}

RowStory clipStory(const Teller& t) {
  if (!isRectified(t)) return {say<"nothing is rectified">(), "", ""};
  if (!isMoved(t)) return {keptWords(t), "", ""};
  const std::string method = choiceLabel("rectify.method", t.settings());
  return t.story(t.value(Id::clipAmount) > 0.0f
                     ? say<"history was pulled %1 of the way: %2">(t.percent(Id::clipAmount), method)
                     : say<"history is outside, but not pulled: %1">(method),
                 Id::clipAmount);
}

RowStory strengthStory(const Teller& t) {
  const RectifySettings& rectify = t.settings().rectify;
  if (rectify.method == RectifyMethod::None) return {say<"nothing is rectified">(), "", ""};
  if (t.value(Id::geometricFlicker) > 0.0f)
    return t.story(say<"single frames miss a thin feature at rest">(), Id::rectifyStrength);
  if (!isOn(rectify.relaxAtRest)) return {say<"all of the correction is applied">(), "", ""};
  return t.story(t.value(Id::rectifyStrength) < 1.0f ? say<"less is applied where little moves">()
                                                     : say<"all of the correction is applied">(),
                 Id::rectifyStrength);
}

RowStory keptLengthStory(const Teller& t) {
  const float before = t.value(Id::historyRawLength), kept = t.value(Id::historyKeptLength);
  if (before == kept) return t.story(say<"as long as before">(), Id::historyKeptLength);
  const bool isDecayed = t.details().weighed.decays && t.value(Id::alphaInvalid) > 0.0f;
  const bool forgets = t.settings().rectify.method == RectifyMethod::ClampForget &&
                       kept != before * (1.0f - (isDecayed ? t.value(Id::alphaInvalid) : 0.0f));
  return t.story(forgets ? say<"clamped history forgets">() : say<"it decays by what is rejected">(),
                 Id::historyKeptLength);
}

} // namespace

RowStory rectifyStory(Id id, const Teller& t) {
  switch (id) {
  case Id::historyRectified:
    return rectifiedStory(t);
  case Id::clipAmount:
    return clipStory(t);
  case Id::rectifyStrength:
    return strengthStory(t);
  case Id::lock:
  case Id::lockLife:
  case Id::instability:
    return lockStory(id, t);
  case Id::historyKeptLength:
    return keptLengthStory(t);
  default: // no row of this stage
    return {};
  }
}

} // namespace taa::story
