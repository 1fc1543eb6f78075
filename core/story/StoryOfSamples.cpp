// Stories of stages 1, 2 and 5: whose motion, where from, and the box.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/twin/Color.h"

#include <cmath>
#include <string>

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
  return t.story(sampleMotionWords(t, offset), id);
}

RowStory reprojectStory(Id id, const Teller& t) {
  const glm::vec2 motion = t.pair(Id::dilatedMotion);
  const bool isInPlace = t.settings().reproject.method == ReprojectMethod::InPlace;
  if (isInPlace && id == Id::historyPosition)
    return t.story(say<"the pixel's own center: history is read in place, whatever moves">(), id);
  if (motion.x >= kNoPreviousPosition && !(isInPlace && id == Id::onScreen))
    return {say<"there is no previous position">(), "", ""};
  if (id == Id::historyPosition) return t.story(say<"the pixel's center less the motion">(), id);
  if (id == Id::onScreen) {
    const glm::ivec2& size = t.details().picturePx;
    const std::string position = t.tuple(t.pair(Id::historyPosition));
    return {t.value(id) != 0.0f ? say<"%1 lies inside %2 × %3 px">(position, size.x, size.y)
                                : say<"%1 lies outside %2 × %3 px">(position, size.x, size.y),
            "", ""};
  }
  return t.story(say<"length of the motion">(), id);
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
  const NeighborhoodShape shape = t.settings().neighborhood.shape;
  const twin::Neighborhood& hood = t.details().neighborhood;
  const std::string words = shape == NeighborhoodShape::Varying
                                ? tapWords(id, t.number(hood.tapReach))
                                : momentWords(id, hood.members.size(), shape == NeighborhoodShape::Rounded);
  return {words, t.formula(id), t.channelName(0)};
}

/// What motion does to γ.
std::string gammaMotionWords(const NeighborhoodSettings& chosen, float speed) {
  if (speed == 0.0f) return say<"as chosen: nothing moves">();
  return chosen.gammaMoving < chosen.gamma   ? say<"smaller by motion">()
         : chosen.gammaMoving > chosen.gamma ? say<"larger by motion">()
                                             : say<"as chosen">();
}

/// Whether contrast between the current color and history made γ larger.
bool isGrown(const Teller& t) {
  const SpaceSettings& space = t.settings().space;
  const twin::Neighborhood& hood = t.details().neighborhood;
  const float half = 0.5f * twin::boxLuma(hood.deviation, space), mean = twin::boxLuma(hood.mean, space);
  const float now = twin::boxLuma(hood.samples[4], space);
  const float past = twin::boxLuma(t.box(t.color(Id::historyRaw)), space);
  const float then = std::fmin(std::fmax(past, mean - half), mean + half);
  return std::fabs(now - then) > 0.05f * std::fmax(std::fmax(now, then), 0.15f);
}

RowStory gammaStory(const Teller& t) {
  const NeighborhoodSettings& chosen = t.settings().neighborhood;
  std::string words = say<"as chosen">();
  if (isOn(chosen.motionGamma)) words = gammaMotionWords(chosen, t.value(Id::speed));
  if (isOn(chosen.resolutionGamma) && t.details().picturePx.y > 1188)
    words = say<"%1, smaller for tall pictures">(words);
  if (isOn(chosen.contrastGamma) && !t.details().isFirst && isGrown(t))
    words = say<"%1, larger by contrast">(words);
  if (isOn(chosen.maskRelax) && std::fmax(t.value(Id::reactive), t.value(Id::responsive)) > 0.0f)
    words = say<"%1, wider by the mask">(words);
  return t.story(words, Id::boxGamma);
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
  return t.story(wallWords(chosen, isOn(chosen.chromaShrink) && t.settings().space.color != ColorSpace::Rgb),
                 id);
}

} // namespace

RowStory sampleStory(Id id, const Teller& t) {
  return intermediate(id).stage == Stage::DilateMotion ? dilateStory(id, t) : reprojectStory(id, t);
}

RowStory boxStory(Id id, const Teller& t) {
  if (id == Id::boxGamma) return gammaStory(t);
  if (id == Id::boxMin || id == Id::boxMax) return wallStory(id, t);
  return momentStory(id, t);
}

} // namespace taa::story
