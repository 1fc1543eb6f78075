// Stories of stage 8: how the weight of the current frame came about.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/twin/Color.h"

#include <cmath>
#include <string>

namespace taa::story {

double framesTaken(double stepSeconds, const WeightSettings& weight) {
  const double eighths = std::round(stepSeconds * static_cast<double>(weight.referenceRate) * 8.0);
  return std::fmin(std::fmax(eighths, 1.0), 64.0) / 8.0;
}

float alphaBeforeRejection(const twin::PixelRecord& record) {
  const auto value = [&record](Id id) { return twin::at(record, id).x; };
  return std::fmax(value(Id::alphaFrameRate) * value(Id::sampleConfidence), value(Id::alphaMask));
}

namespace {

RowStory floorStory(const Teller& t) {
  const bool isLess = t.settings().weight.source != AlphaSource::HistoryLength &&
                      t.value(Id::alphaFloor) < t.settings().weight.minimum;
  return {isLess ? say<"no more than the source's own">() : say<"as chosen">(), t.formula(Id::alphaFloor),
          ""};
}

/// α before motion is added.
float dampedAlpha(const Teller& t) {
  float alpha = t.value(Id::alphaBase);
  for (const Id damping : {Id::alphaLumaFlicker, Id::alphaNearClamp, Id::alphaHistoryContrast, Id::alphaRelax,
                           Id::alphaSampleDistance})
    alpha *= t.value(damping);
  return std::fmin(std::fmax(alpha, t.value(Id::alphaFloor)), 1.0f) * t.value(Id::alphaFlicker);
}

std::string motionWords(const Teller& t) {
  const std::string speed = t.number(Id::speed);
  if (!(t.value(Id::speed) > 0)) return say<"nothing moves">();
  switch (t.settings().weight.motion) {
  case MotionAlpha::SquaredAsPrinted:
    return say<"motion of %1 px, as fractions of the picture">(speed);
  case MotionAlpha::Doubled:
    return say<"motion of %1 px doubles α at most">(speed);
  case MotionAlpha::None:
  case MotionAlpha::Linear:
  case MotionAlpha::Squared:
  case MotionAlpha::Added:
    break;
  }
  return say<"motion of %1 px">(speed);
}

RowStory motionStory(const Teller& t) {
  if (t.settings().weight.motion == MotionAlpha::None) return {say<"off">(), "", ""};
  return {motionWords(t), t.formula(Id::alphaMotion), ""};
}

double frames(const Teller& t) {
  return framesTaken(t.details().weighed.stepSeconds, t.settings().weight);
}

RowStory frameRateStory(const Teller& t) {
  const bool isScaled = isOn(t.settings().weight.frameRate);
  return {!isScaled          ? say<"off: whatever time the frame takes">()
          : frames(t) == 1.0 ? say<"as long as the frame it is meant for">()
                             : say<"for a frame that counts as %1">(t.number(frames(t))),
          t.formula(Id::alphaFrameRate), ""};
}

std::string maskWords(const Teller& t) {
  const bool isMasked = t.value(Id::alphaMask) > 0;
  switch (t.settings().weight.mask) {
  case MaskAlpha::Off:
    return say<"off">();
  case MaskAlpha::Responsive:
    return isMasked ? say<"the mask asks for that much">() : say<"not masked">();
  case MaskAlpha::Reactive:
    return isMasked ? say<"as much as was blended in">() : say<"nothing was blended in">();
  case MaskAlpha::Exclude:
    return isMasked ? say<"the mask leaves history out">() : say<"not masked">();
  }
  return {};
}

RowStory maskStory(const Teller& t) {
  const MaskAlpha mask = t.settings().weight.mask;
  const bool isComputed = mask == MaskAlpha::Responsive || mask == MaskAlpha::Reactive;
  return {maskWords(t), isComputed ? t.formula(Id::alphaMask) : "", ""};
}

RowStory divergenceStory(const Teller& t) {
  if (!isOn(t.settings().weight.divergence)) return {say<"off">(), "", ""};
  if (t.value(Id::alphaDivergence) == 0.0f)
    return {say<"neighbors move along, or the pixel rests">(), "", ""};
  return {say<"a neighbor goes only %1 along">(t.percent(static_cast<double>(t.details().divergence.least))),
          t.formula(Id::alphaDivergence), ""};
}

RowStory invalidStory(const Teller& t) {
  const float invalid = t.value(Id::alphaInvalid);
  if (t.details().weighed.isFrozen) return {say<"history outside is kept whole, as printed">(), "", ""};
  if (invalid == 0.0f) return {say<"history was kept">(), "", ""};
  const std::string words = invalid >= 1.0f ? say<"history was dropped">()
                            : t.details().weighed.decays || invalid > alphaBeforeRejection(t.probed.record)
                                ? say<"history counts less">()
                                : say<"it counted no more before">();
  return {words, t.formula(Id::alphaInvalid), ""};
}

RowStory channelAlphasStory(const Teller& t) {
  if (t.settings().weight.source != AlphaSource::ContrastPerChannel)
    return {say<"α in each, %1">(t.number(Id::alpha)), "", ""};
  if (t.value(Id::alphaInvalid) >= 1.0f)
    return {say<"history was rejected: the current frame alone">(), "", ""};
  if (t.details().weighed.isFrozen) return {say<"history alone: nothing of the current frame">(), "", ""};
  return {say<"of each channel's own contrast, red's is %1">(t.number(t.details().weighed.contrast.x)),
          t.formula(Id::alphaChannels, 0), "R"};
}

RowStory alphaStory(const Teller& t) {
  const float invalid = t.value(Id::alphaInvalid);
  if (invalid >= 1.0f)
    return {say<"history was rejected: the current frame alone">(), t.formula(Id::alpha), ""};
  if (t.details().weighed.isFrozen)
    return {say<"history alone: nothing of the current frame">(), t.formula(Id::alpha), ""};
  std::string words =
      say<"%1 current, by %2">(t.percent(Id::alpha), choiceLabel("weight.source", t.settings()));
  if (t.value(Id::alphaFloor) == t.value(Id::alpha) && t.value(Id::alphaBase) < t.value(Id::alphaFloor))
    words = say<"%1; no less than the floor">(words);
  if (t.value(Id::alphaFlicker) != 1.0f)
    words =
        say<"%1; %2 of that, for single frames may miss a thin feature">(words, t.number(Id::alphaFlicker));
  const float mask = t.value(Id::alphaMask), alpha = t.value(Id::alpha);
  const bool isComposed = alpha > std::fmax(mask, invalid); // else it is not motion that it comes from
  if (isComposed && t.value(Id::alphaMotion) > 0 && dampedAlpha(t) < 1.0f)
    words = say<"%1; raised by motion of %2 px">(words, t.number(Id::speed));
  if (mask > 0 && mask == alpha && mask > t.value(Id::alphaFrameRate) * t.value(Id::sampleConfidence))
    words = say<"%1; raised where the mask asks for it">(words);
  if (invalid > 0 && (t.details().weighed.decays || invalid > alphaBeforeRejection(t.probed.record)))
    words = say<"%1; raised where history was rejected">(words);
  return t.story(words, Id::alpha, true);
}

RowStory changeStory(const Teller& t) {
  if (!isOn(t.settings().weight.velocityChange)) return {say<"off">(), "", ""};
  return {say<"its motion changed by %1 px">(t.number(Id::velocityChange)),
          t.formula(Id::alphaVelocityChange), ""};
}

} // namespace

RowStory weightStory(Id id, const Teller& t) {
  switch (id) {
  case Id::alphaBase:
    return {choiceLabel("weight.source", t.settings()), t.formula(id), ""};
  case Id::alphaFloor:
    return floorStory(t);
  case Id::alphaLumaFlicker:
  case Id::alphaNearClamp:
  case Id::alphaHistoryContrast:
  case Id::alphaRelax:
  case Id::alphaSampleDistance:
  case Id::alphaFlicker:
    return dampingStory(id, t);
  case Id::alphaMotion:
    return motionStory(t);
  case Id::alphaVelocityChange:
    return changeStory(t);
  case Id::alphaDivergence:
    return divergenceStory(t);
  case Id::alphaFrameRate:
    return frameRateStory(t);
  case Id::alphaMask:
    return maskStory(t);
  case Id::alphaInvalid:
    return invalidStory(t);
  case Id::alpha:
    return alphaStory(t);
  case Id::alphaChannels:
    return channelAlphasStory(t);
  default: // no row of this stage
    return {};
  }
}

} // namespace taa::story
