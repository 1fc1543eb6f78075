// Story of stage 7: history brought into the box.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/twin/Color.h"

#include <glm/common.hpp>

#include <cmath>
#include <cstddef>
#include <string>

namespace taa::story {

std::string targetText(RectifyMethod method) {
  switch (method) {
  case RectifyMethod::Clamp:
  case RectifyMethod::ClampForget:
  case RectifyMethod::ClipToCenter:
  case RectifyMethod::ClampThenClip:
    return say<"the middle of the box">();
  case RectifyMethod::ShrinkAxes:
    return say<"the mean">();
  case RectifyMethod::None:
  case RectifyMethod::ClipToFiltered:
  case RectifyMethod::RayToCurrent:
  case RectifyMethod::ClipToHull:
  case RectifyMethod::ClipToBoth:
  case RectifyMethod::Select:
    break;
  }
  return say<"the current color">();
}

namespace {

/// What rectification moves, in box space.
struct Clip {
  glm::vec3 h{0.0f}, low{0.0f}, high{0.0f}, center{0.0f};
  glm::vec3 target{0.0f}; ///< what h is moved towards; h where there is no such point
  glm::vec3 moved{0.0f};  ///< where h went, before the way back is clamped as printed
  twin::Rectified result; ///< before strength and locks
};

Clip clipOf(const Teller& t) {
  Clip clip;
  clip.h = t.box(t.color(Id::historyRaw));
  clip.low = t.details().neighborhood.boxMin;
  clip.high = t.details().neighborhood.boxMax;
  clip.center = 0.5f * (clip.low + clip.high);
  clip.target = twin::rectifyTarget(t.settings().rectify.method, t.box(t.color(Id::currentFiltered)),
                                    t.details().neighborhood)
                    .value_or(clip.h);
  Settings plain = t.settings();
  plain.rectify.relaxAtRest = plain.rectify.locks = plain.rectify.instability = Switch::Off;
  twin::Inputs inputs;
  inputs.historyColor = Image(1, 1, 4); // there is a history
  clip.result = twin::rectifyHistory(inputs, plain, t.color(Id::historyRaw), t.color(Id::currentFiltered),
                                     t.details().neighborhood);
  plain.space = twin::withoutClamp(plain.space);
  clip.moved = t.box(twin::rectifyHistory(inputs, plain, t.color(Id::historyRaw),
                                          t.color(Id::currentFiltered), t.details().neighborhood)
                         .value);
  return clip;
}

/// The channel whose wall ends the way from h to the target last, and that wall; −1: h is inside.
struct Wall {
  int channel = -1;
  float at = 0.0f;
};

Wall enteredWall(const Clip& clip) {
  Wall wall;
  float most = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const float at = clip.h[i] < clip.low[i] ? clip.low[i] : clip.high[i];
    if (clip.h[i] >= clip.low[i] && clip.h[i] <= clip.high[i]) continue;
    const float share = (at - clip.h[i]) / (clip.target[i] - clip.h[i]);
    if (share > most) most = share, wall = {i, at};
  }
  return wall;
}

std::string fraction(const Teller& t, float above, float from, float to) {
  const auto n = [&](float x) { return t.number(static_cast<double>(x)); };
  return "(" + n(above) + " − " + n(from) + ") / (" + n(to) + " − " + n(from) + ")";
}

bool isMoved(const Teller& t) {
  return t.settings().rectify.method != RectifyMethod::None && !t.details().isFirst;
}

/// How far the result is on the way from h to the target, by the channel that goes farthest.
float alongToTarget(const Clip& clip) {
  const glm::vec3 toTarget = clip.target - clip.h;
  int most = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(toTarget[i]) > std::fabs(toTarget[most])) most = i;
  return toTarget[most] == 0.0f ? 0.0f : (clip.moved[most] - clip.h[most]) / toTarget[most];
}

/// The way into the box as an expression of box space; empty where it has no short one.
std::string pathText(const Teller& t, const Clip& clip) {
  const std::string h = t.tuple(clip.h), target = t.tuple(clip.target);
  const std::string amount = t.number(static_cast<double>(clip.result.amount));
  switch (t.settings().rectify.method) {
  case RectifyMethod::Clamp:
  case RectifyMethod::ClampForget:
    return call("clamp", {h, t.tuple(clip.low), t.tuple(clip.high)});
  case RectifyMethod::ClipToCenter:
  case RectifyMethod::ClipToFiltered:
  case RectifyMethod::ClipToHull:
  case RectifyMethod::ClipToBoth:
    return h + " + " + amount + " × (" + target + " − " + h + ")";
  case RectifyMethod::RayToCurrent: // farther than to the current color, where that lies outside as well
    return h + " + " + t.number(alongToTarget(clip)) + " × (" + target + " − " + h + ")";
  case RectifyMethod::ShrinkAxes:
    return target + " + (1 − " + t.number(alongToTarget(clip)) + ") × (" + h + " − " + target + ")";
  case RectifyMethod::ClampThenClip: {
    const twin::Neighborhood& hood = t.details().neighborhood;
    const glm::vec3 first = glm::clamp(clip.h, hood.min, hood.max);
    const float second = twin::clip(RectifyMethod::ClipToCenter, first, first, clip.low, clip.high).amount;
    const std::string from = call("clamp", {h, t.tuple(hood.min), t.tuple(hood.max)});
    return from + " + " + t.number(second) + " × (" + target + " − " + from + ")";
  }
  case RectifyMethod::Select: // not through box space
  case RectifyMethod::None:
    break;
  }
  return "";
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
RowStory cutOffStory(const Teller& t, const Clip& clip, const std::string& words) {
  const SpaceSettings& space = t.settings().space;
  const SpaceSettings axes{twin::withoutClamp(space).color, ToneSpace::Linear};
  const glm::vec3 before = twin::fromBox(clip.moved, axes);
  const glm::vec3 after = glm::clamp(before, 0.0f, 1.0f);
  if (space.color != ColorSpace::YCoCgAsPrinted || before == after) return {};
  return {say<"%1, and cut off on the way back, as printed">(words),
          call("clamp", {t.tuple(before), "0", "1"}) + " = " +
              t.tuple(twin::compress(clip.result.value, space.tone)),
          say<"compressed as in the box">()};
}

/// Which sample takes the place of history.
std::string selectedWords(const Teller& t, const Clip& clip) {
  const twin::Neighborhood& hood = t.details().neighborhood;
  const std::size_t k = twin::nearestSample(clip.h, hood);
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
  const Clip clip = clipOf(t);
  if (clip.h != glm::clamp(clip.h, clip.low, clip.high))
    return say<"no wall of the box is hit on the way to the current color: kept as it is">();
  return say<"history lies inside the box: kept as it is">();
}

RowStory rectifiedStory(const Teller& t) {
  const RectifySettings& rectify = t.settings().rectify;
  if (t.details().isFirst) return {say<"there is no history yet">(), "", ""};
  if (rectify.method == RectifyMethod::None) return {say<"history is taken as it is">(), "", ""};
  const Clip clip = clipOf(t);
  if (!clip.result.moved) return {keptWords(t), "", ""};
  const bool isSelected = rectify.method == RectifyMethod::Select;
  const std::string words = isSelected ? selectedWords(t, clip) : pulledWords(t);
  if (isPartial(t) || t.details().lockState.protection > 0.0f) {
    const std::string raw = t.tuple(Id::historyRaw);
    const std::string share = t.number(static_cast<double>(t.value(Id::rectifyStrength))) + " × (1 − " +
                              t.number(static_cast<double>(t.details().lockState.protection)) + ")";
    return {words,
            t.equals(raw + " + " + share + " × (" + t.tuple(clip.result.value) + " − " + raw + ")",
                     Id::historyRectified),
            ""};
  }
  if (isSelected) return {words, t.equals(t.tuple(clip.result.value), Id::historyRectified), ""};
  if (RowStory cutOff = cutOffStory(t, clip, words); !cutOff.words.empty()) return cutOff;
  const std::string path = pathText(t, clip);
  if (path.empty()) return {words, "", ""};
  return {words, path + " = " + t.tuple(clip.moved), say<"in box space">()};
}

/// The way of h against that to `target`.
std::string partText(const Teller& t, const Clip& clip, const glm::vec3& target) {
  return call("length", {t.tuple(clip.moved) + " − " + t.tuple(clip.h)}) + " / " +
         call("length", {t.tuple(target) + " − " + t.tuple(clip.h)});
}

/// How far h goes, before what is taken back.
std::string amountText(const Teller& t, const Clip& clip) {
  const auto n = [&](float x) { return t.number(static_cast<double>(x)); };
  switch (t.settings().rectify.method) {
  case RectifyMethod::Clamp:
  case RectifyMethod::ClampForget:
    return call("length", {t.tuple(glm::clamp(clip.h, clip.low, clip.high)) + " − " + t.tuple(clip.h)}) +
           " / " + call("length", {t.tuple(clip.center) + " − " + t.tuple(clip.h)});
  case RectifyMethod::ClipToFiltered: {
    const Wall wall = enteredWall(clip);
    return wall.channel < 0
               ? ""
               : call("min", {fraction(t, wall.at, clip.h[wall.channel], clip.target[wall.channel]), "1"});
  }
  case RectifyMethod::ClipToCenter: {
    int channel = 0;
    float most = 0.0f;
    for (int i = 0; i < 3; ++i) {
      const float u = std::fabs(clip.h[i] - clip.center[i]) / (0.5f * (clip.high[i] - clip.low[i]) + 1e-8f);
      if (u > most) most = u, channel = i;
    }
    return "1 − " + n(0.5f * (clip.high[channel] - clip.low[channel]) + 1e-8f) + " / |" + n(clip.h[channel]) +
           " − " + n(clip.center[channel]) + "|";
  }
  case RectifyMethod::ClampThenClip:
    return partText(t, clip, clip.center);
  case RectifyMethod::ShrinkAxes:
    return partText(t, clip, clip.target);
  case RectifyMethod::ClipToHull:
  case RectifyMethod::ClipToBoth:
  case RectifyMethod::RayToCurrent:
    return call("min", {partText(t, clip, clip.target), "1"});
  case RectifyMethod::Select:
    return "1";
  case RectifyMethod::None:
    break;
  }
  return "";
}

RowStory clipStory(const Teller& t) {
  if (!isMoved(t)) return {say<"nothing is rectified">(), "", ""};
  const Clip clip = clipOf(t);
  if (!clip.result.moved) return {keptWords(t), "", ""};
  std::string text = amountText(t, clip);
  const std::string method = choiceLabel("rectify.method", t.settings());
  const std::string words =
      t.value(Id::clipAmount) > 0.0f
          ? say<"history was pulled %1 of the way: %2">(t.percent(Id::clipAmount), method)
          : say<"history is outside, but not pulled: %1">(method);
  if (text.empty()) return {words, "", ""};
  if (isPartial(t)) text = "(" + text + ") × " + t.number(Id::rectifyStrength);
  if (t.details().lockState.protection > 0.0f)
    text = "(" + text + ") × (1 − " + t.number(static_cast<double>(t.details().lockState.protection)) + ")";
  return {words, t.equals(text, Id::clipAmount), ""};
}

RowStory strengthStory(const Teller& t) {
  const RectifySettings& rectify = t.settings().rectify;
  if (rectify.method == RectifyMethod::None) return {say<"nothing is rectified">(), "", ""};
  const auto n = [&](float x) { return t.number(static_cast<double>(x)); };
  const bool isRelaxed = isOn(rectify.relaxAtRest), isFlicker = t.value(Id::geometricFlicker) > 0.0f;
  const std::string relaxed = n(rectify.minStrength) + " + (1 − " + n(rectify.minStrength) + ") × clamp((" +
                              t.number(Id::speed) + " / " + n(rectify.restSpeed) + ")^2, 0, 1)";
  if (isFlicker)
    return {
        say<"single frames miss a thin feature at rest">(),
        t.equals((isRelaxed ? "(" + relaxed + ") × " : "") + n(rectify.flickerStrength), Id::rectifyStrength),
        ""};
  if (!isRelaxed) return {say<"all of the correction is applied">(), "", ""};
  return {t.value(Id::rectifyStrength) < 1.0f ? say<"less is applied where little moves">()
                                              : say<"all of the correction is applied">(),
          t.equals(relaxed, Id::rectifyStrength), ""};
}

RowStory keptLengthStory(const Teller& t) {
  const float before = t.value(Id::historyRawLength), kept = t.value(Id::historyKeptLength);
  const bool isDecayed = t.details().weighed.decays && t.value(Id::alphaInvalid) > 0.0f;
  const std::string left =
      isDecayed ? t.number(Id::historyRawLength) + " × (1 − " + t.number(Id::alphaInvalid) + ")"
                : t.number(Id::historyRawLength);
  if (before == kept)
    return {say<"as long as before">(), t.equals(t.number(Id::historyRawLength), Id::historyKeptLength), ""};
  const bool forgets = t.settings().rectify.method == RectifyMethod::ClampForget &&
                       kept != before * (1.0f - (isDecayed ? t.value(Id::alphaInvalid) : 0.0f));
  if (!forgets) return {say<"it decays by what is rejected">(), t.equals(left, Id::historyKeptLength), ""};
  const std::string forgotten = call("min", {left, t.number(1.6216216)});
  const std::string held = t.number(static_cast<double>(t.details().lockState.protection));
  return {say<"clamped history forgets">(),
          t.equals(forgotten + " + " + held + " × (" + left + " − " + forgotten + ")", Id::historyKeptLength),
          ""};
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
