// Stories of stages 1, 2 and 5: whose motion, where from, and the box.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/twin/Color.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace taa::story {

namespace {

/// Whose motion, that of the neighbor at `offset` or, if that is zero, the pixel's own.
std::string sampleMotionWords(const Teller& t, const glm::vec2& offset) {
  const bool isOwn = offset == glm::vec2(0.0f);
  if (isUpsampled(t.settings()))
    return isOwn ? say<"motion of the pixel itself, in px of the picture">()
                 : say<"motion of the neighbor at %1, in px of the picture">(t.tuple(offset));
  return isOwn ? say<"motion of the pixel itself">() : say<"motion of the neighbor at %1">(t.tuple(offset));
}

RowStory dilateStory(Id id, const Teller& t) {
  const glm::vec2 offset = t.pair(Id::dilatedOffset);
  const bool isOwn = offset == glm::vec2(0.0f);
  if (id == Id::dilatedOffset)
    return {isOwn ? say<"the pixel's own motion is used">()
                  : say<"the motion of the neighbor at %1 is used: %2">(
                        t.tuple(offset), choiceLabel("dilate.method", t.settings())),
            "", ""};
  if (id == Id::dilatedMotion && t.value(id) >= kNoPreviousPosition)
    return {say<"the surface was behind the previous camera">(), "", ""};
  if (id == Id::dilatedDepth)
    return {isOwn ? say<"depth of the pixel itself">() : say<"depth of the neighbor at %1">(t.tuple(offset)),
            "", ""};
  if (!isUpsampled(t.settings())) return {sampleMotionWords(t, offset), "", ""};
  return {sampleMotionWords(t, offset),
          t.equals(t.tuple(t.details().drawnMotion) + " / " + t.tuple(t.details().renderRatio), id), ""};
}

RowStory reprojectStory(Id id, const Teller& t) {
  const glm::vec2 motion = t.pair(Id::dilatedMotion), center = glm::vec2(t.probed.pixel) + 0.5f;
  const bool isInPlace = t.settings().reproject.method == ReprojectMethod::InPlace;
  if (isInPlace && id == Id::historyPosition)
    return {say<"the pixel's own center: history is read in place, whatever moves">(),
            t.equals(t.tuple(center), id), ""};
  if (motion.x >= kNoPreviousPosition && !(isInPlace && id == Id::onScreen))
    return {say<"there is no previous position">(), "", ""};
  if (id == Id::historyPosition)
    return {say<"the pixel's center less the motion">(),
            t.equals(t.tuple(center) + " − " + t.tuple(motion), id), ""};
  if (id == Id::onScreen) {
    const glm::ivec2& size = t.details().picturePx;
    const std::string position = t.tuple(t.pair(Id::historyPosition));
    return {t.value(id) != 0.0f ? say<"%1 lies inside %2 × %3 px">(position, size.x, size.y)
                                : say<"%1 lies outside %2 × %3 px">(position, size.x, size.y),
            "", ""};
  }
  return {say<"length of the motion">(), t.equals(call("length", {t.tuple(motion)}), id), ""};
}

/// Y or red of samples, and what each counts for the moments.
struct WeightedSamples {
  std::vector<float> values, weights;
  bool isEqual = true;
};

WeightedSamples setOf(const Teller& t, const std::vector<twin::NeighborhoodSample>& members) {
  const MomentWeights kind = t.settings().neighborhood.weights;
  WeightedSamples set;
  set.isEqual = kind == MomentWeights::Equal;
  for (const twin::NeighborhoodSample& member : members) {
    set.values.push_back(t.box(member.color).x);
    set.weights.push_back(twin::momentWeight(t.settings(), member));
  }
  return set;
}

/// The cross, which rounding looks at besides.
WeightedSamples crossOf(const Teller& t) {
  std::vector<twin::NeighborhoodSample> cross;
  for (const std::size_t k : {1u, 3u, 4u, 5u, 7u})
    cross.push_back({t.details().neighborhood.colors[k], k == 4 ? 0u : 1u});
  return setOf(t, cross);
}

float meanOf(const WeightedSamples& set) {
  double sum = 0, total = 0;
  for (std::size_t k = 0; k < set.values.size(); ++k) {
    sum += static_cast<double>(set.weights[k]) * static_cast<double>(set.values[k]);
    total += static_cast<double>(set.weights[k]);
  }
  return static_cast<float>(sum / total);
}

std::string list(const Teller& t, const std::vector<float>& values, const char* between) {
  std::string text;
  for (const float value : values)
    text += (text.empty() ? "" : between) + t.number(static_cast<double>(value));
  return text;
}

std::string meanText(const Teller& t, const WeightedSamples& set) {
  if (!set.isEqual) return weightedMean(t, set.weights, set.values);
  return "(" + list(t, set.values, " + ") + ") / " + std::to_string(set.values.size());
}

std::string deviationText(const Teller& t, const WeightedSamples& set) {
  const std::string mean = t.number(static_cast<double>(meanOf(set)));
  std::string sum, total;
  for (std::size_t k = 0; k < set.values.size(); ++k) {
    const std::string square = "(" + t.number(static_cast<double>(set.values[k])) + " − " + mean + ")^2";
    const std::string weight = t.number(static_cast<double>(set.weights[k]));
    sum += (k == 0 ? "" : " + ") + (set.isEqual ? square : weight + " × " + square);
    total += (k == 0 ? "" : " + ") + weight;
  }
  return "√((" + sum + ") / " + (set.isEqual ? std::to_string(set.values.size()) : "(" + total + ")") + ")";
}

/// Of `count` samples; where `isRounded`, of the cross among them as well.
std::string momentWords(Id id, std::size_t count, bool isRounded) {
  switch (id) {
  case Id::neighborhoodMean:
    return isRounded ? say<"mean of the %1 samples and of the cross">(count)
                     : say<"mean of the %1 samples">(count);
  case Id::neighborhoodDeviation:
    return say<"spread of the %1 samples about their mean">(count);
  case Id::neighborhoodMin:
    return isRounded ? say<"smallest of the %1 samples and of the cross">(count)
                     : say<"smallest of the %1 samples">(count);
  case Id::neighborhoodMax:
    return isRounded ? say<"largest of the %1 samples and of the cross">(count)
                     : say<"largest of the %1 samples">(count);
  default: // no moment
    return {};
  }
}

/// How far the taps that vary lie from the center: κ of manual 8.5.
std::string reachText(const Teller& t) {
  const float depth = twin::viewDepth(t.value(Id::dilatedDepth), t.details().depthTerms);
  if (depth == 0.0f) return t.number(0.5);
  const std::string reach = " = " + t.number(t.details().neighborhood.tapReach);
  if (t.value(Id::speed) * depth == 0.0f) return t.number(0.5) + " + " + t.number(0.1667) + reach;
  return t.number(0.5) + " + " + t.number(0.1667) + " × clamp(" + t.number(0.5) + " / (" +
         t.number(Id::speed) + " × " + t.number(depth) + "), 0, 1)" + reach;
}

std::string tapWords(Id id, const std::string& reach) {
  switch (id) {
  case Id::neighborhoodMean:
    return say<"mean of four taps on the diagonals, off by %1 px each way">(reach);
  case Id::neighborhoodDeviation:
    return say<"spread of four taps about their mean, off by %1 px each way">(reach);
  case Id::neighborhoodMin:
    return say<"smallest of four taps on the diagonals, off by %1 px each way">(reach);
  case Id::neighborhoodMax:
    return say<"largest of four taps on the diagonals, off by %1 px each way">(reach);
  default: // no moment
    return {};
  }
}

RowStory momentStory(Id id, const Teller& t) {
  const WeightedSamples set = setOf(t, t.details().neighborhood.members), five = crossOf(t);
  const bool isRounded = t.settings().neighborhood.shape == NeighborhoodShape::Rounded;
  const auto rounded = [&](const std::string& all, const std::string& cross) {
    return isRounded ? "(" + all + " + " + cross + ") / 2" : all;
  };
  const auto first = [&](Id row) { return " = " + t.number(static_cast<double>(t.color(row).x)); };
  const bool isVarying = t.settings().neighborhood.shape == NeighborhoodShape::Varying;
  const std::string words =
      isVarying ? tapWords(id, reachText(t)) : momentWords(id, set.values.size(), isRounded);
  if (id == Id::neighborhoodMean)
    return {words, rounded(meanText(t, set), meanText(t, five)) + first(id), t.channelName(0)};
  if (id == Id::neighborhoodDeviation) return {words, deviationText(t, set) + first(id), t.channelName(0)};
  const std::string function = id == Id::neighborhoodMin ? "min" : "max";
  const auto extreme = [&](const WeightedSamples& of) {
    return function + "(" + list(t, of.values, ", ") + ")";
  };
  return {words, rounded(extreme(set), extreme(five)) + first(id), t.channelName(0)};
}

/// What motion does to γ.
std::string gammaMotionWords(const NeighborhoodSettings& chosen, float speed) {
  if (speed == 0.0f) return say<"as chosen: nothing moves">();
  return chosen.gammaMoving < chosen.gamma   ? say<"smaller by motion">()
         : chosen.gammaMoving > chosen.gamma ? say<"larger by motion">()
                                             : say<"as chosen">();
}

RowStory gammaStory(const Teller& t) {
  const NeighborhoodSettings& chosen = t.settings().neighborhood;
  const auto n = [&](float x) { return t.number(static_cast<double>(x)); };
  std::string text = n(chosen.gamma), words = say<"as chosen">();
  if (isOn(chosen.motionGamma)) {
    text = n(chosen.gammaMoving) + " + (" + text + " − " + n(chosen.gammaMoving) + ") × clamp(1 − " +
           speedText(t, chosen.gammaSpeedIn) + " / " + n(chosen.gammaSpeed) + ", 0, 1)^2";
    words = gammaMotionWords(chosen, t.value(Id::speed));
  }
  if (isOn(chosen.resolutionGamma)) {
    text = "(" + text + ") × clamp(1188 / " + std::to_string(t.details().picturePx.y) + ", 0.75, 1)";
    if (t.details().picturePx.y > 1188) words = say<"%1, smaller for tall pictures">(words);
  }
  if (isOn(chosen.contrastGamma) && !t.details().isFirst) {
    const SpaceSettings& space = t.settings().space;
    const twin::Neighborhood& hood = t.details().neighborhood;
    const float half = 0.5f * twin::boxLuma(hood.deviation, space);
    const float mean = twin::boxLuma(hood.mean, space);
    const std::string current = n(twin::boxLuma(hood.samples[4], space));
    const std::string past = call("clamp", {n(twin::boxLuma(t.box(t.color(Id::historyRaw)), space)),
                                            n(mean) + " − " + n(half), n(mean) + " + " + n(half)});
    text += " + " + n(chosen.contrastGrowth) + " × smooth((|" + current + " − " + past + "| / " +
            call("max", {current, past, "0.15"}) + " − 0.05) / 0.5)";
    const float now = twin::boxLuma(hood.samples[4], space);
    const float then =
        std::fmin(std::fmax(twin::boxLuma(t.box(t.color(Id::historyRaw)), space), mean - half), mean + half);
    if (std::fabs(now - then) > 0.05f * std::fmax(std::fmax(now, then), 0.15f))
      words = say<"%1, larger by contrast">(words);
  }
  if (isOn(chosen.maskRelax)) {
    text =
        "(" + text + ") × (1 + 1.5 × " + n(std::fmax(t.value(Id::reactive), t.value(Id::responsive))) + ")";
    if (std::fmax(t.value(Id::reactive), t.value(Id::responsive)) > 0.0f)
      words = say<"%1, wider by the mask">(words);
  }
  return {words, t.equals(text, Id::boxGamma), ""};
}

/// What walls of the box are made of.
std::string wallWords(const NeighborhoodSettings& chosen, bool isShrunk) {
  std::string words = say<"extreme of the samples">();
  if (chosen.box == BoxKind::Variance) words = say<"γ deviations from the mean">();
  if (chosen.box == BoxKind::Intersection)
    words = say<"the narrower of the samples' extreme and γ deviations">();
  if (isOn(chosen.includeFiltered)) words = say<"%1, wide enough for the filtered color">(words);
  if (isShrunk) words = say<"%1; chroma an eighth of the luma range around the pixel">(words);
  return words;
}

RowStory wallStory(Id id, const Teller& t) {
  const NeighborhoodSettings& chosen = t.settings().neighborhood;
  const bool isLow = id == Id::boxMin;
  const Id extreme = isLow ? Id::neighborhoodMin : Id::neighborhoodMax;
  const bool isShrunk = isOn(chosen.chromaShrink) && t.settings().space.color != ColorSpace::Rgb;
  const auto text = [&](const glm::vec3& v) {
    return isShrunk ? t.number(static_cast<double>(v.x)) : t.tuple(v);
  };
  const std::string moments = text(t.color(Id::neighborhoodMean)) + (isLow ? " − " : " + ") +
                              t.number(Id::boxGamma) + " × " + text(t.color(Id::neighborhoodDeviation));
  std::string wall = chosen.box == BoxKind::Variance ? moments : text(t.color(extreme));
  if (chosen.box == BoxKind::Intersection) wall = call(isLow ? "max" : "min", {wall, moments});
  if (isOn(chosen.includeFiltered))
    wall = call(isLow ? "min" : "max", {wall, text(t.box(t.color(Id::currentFiltered)))});
  return {wallWords(chosen, isShrunk), wall + " = " + text(t.color(id)), isShrunk ? t.channelName(0) : ""};
}

} // namespace

std::string speedText(const Teller& t, SpeedUnit unit) {
  const glm::ivec2& size = t.details().picturePx;
  if (unit == SpeedUnit::Pixels) return t.number(Id::speed);
  if (unit == SpeedUnit::Lines1080) return t.number(Id::speed) + " × 1080 / " + std::to_string(size.y);
  const glm::vec2 motion = t.pair(Id::dilatedMotion);
  return "1080 × √((" + t.number(motion.x) + " / " + std::to_string(size.x) + ")^2 + (" + t.number(motion.y) +
         " / " + std::to_string(size.y) + ")^2)";
}

RowStory sampleStory(Id id, const Teller& t) {
  return intermediate(id).stage == Stage::DilateMotion ? dilateStory(id, t) : reprojectStory(id, t);
}

RowStory boxStory(Id id, const Teller& t) {
  if (id == Id::boxGamma) return gammaStory(t);
  if (id == Id::boxMin || id == Id::boxMax) return wallStory(id, t);
  return momentStory(id, t);
}

} // namespace taa::story
