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

/// Of lumas, or of those of colors over 1 + their largest channel.
std::string likeness(const Teller& t, bool isCompressed) {
  const twin::WeightInputs& weighed = t.details().weighed;
  const std::string now = t.number(isCompressed ? weighed.maxCurrent : weighed.lumaCurrent);
  const std::string then = t.number(isCompressed ? weighed.maxHistory : weighed.lumaHistory);
  return "(1 − |" + now + " − " + then + "| / " + call("max", {now, then, "0.2"}) + ")^2";
}

std::string baseText(const Teller& t) {
  const WeightSettings& weight = t.settings().weight;
  const twin::WeightInputs& weighed = t.details().weighed;
  const auto n = [&](float x) { return t.number(static_cast<double>(x)); };
  switch (weight.source) { // manual §13
  case AlphaSource::Constant:
    return n(weight.alpha);
  case AlphaSource::HistoryLength:
    return "1 / (" + t.number(Id::historyKeptLength) + " + 1)";
  case AlphaSource::LumaDifference:
  case AlphaSource::LumaDifferenceCompressed:
    return n(weight.sourceMax) + " + " + likeness(t, weight.source == AlphaSource::LumaDifferenceCompressed) +
           " × (" + n(weight.sourceMin) + " − " + n(weight.sourceMax) + ")";
  case AlphaSource::LumaDifferenceAsPrinted:
    return likeness(t, true);
  case AlphaSource::Contrast:
  case AlphaSource::ContrastPerChannel:
    return "1 − (0.25 + 0.6 × clamp(|" + n(weighed.boxHigh) + " − " + n(weighed.boxLow) + "| / " +
           call("max", {n(weighed.boxCurrent), "0.00001"}) + ", 0, 1))";
  case AlphaSource::Confidence: {
    const float after = twin::confidenceAfter(t.value(Id::historyKeptLength), weighed.motion);
    return call("min", {call("max", {"1 / " + n(after), n(weight.sourceMin)}), n(weight.sourceMax)});
  }
  case AlphaSource::Depth:
    return weighed.depth == 0.0f ? "1"
                                 : "0.025 + (" + n(weight.alpha) + " − 0.025) × √(" + n(weighed.depth) + ")";
  }
  return {};
}

RowStory floorStory(const Teller& t) {
  const std::string minimum = t.number(static_cast<double>(t.settings().weight.minimum));
  if (t.settings().weight.source == AlphaSource::HistoryLength)
    return {say<"as chosen">(), t.equals(minimum, Id::alphaFloor), ""};
  return {t.value(Id::alphaFloor) < t.settings().weight.minimum ? say<"no more than the source's own">()
                                                                : say<"as chosen">(),
          t.equals(call("min", {t.number(Id::alphaBase), minimum}), Id::alphaFloor), ""};
}

/// α before motion is added.
float dampedAlpha(const Teller& t) {
  float alpha = t.value(Id::alphaBase);
  for (const Id damping : {Id::alphaLumaFlicker, Id::alphaNearClamp, Id::alphaHistoryContrast, Id::alphaRelax,
                           Id::alphaSampleDistance})
    alpha *= t.value(damping);
  return std::fmin(std::fmax(alpha, t.value(Id::alphaFloor)), 1.0f) * t.value(Id::alphaFlicker);
}

/// Base, damped, no less than the floor.
std::string dampedText(const Teller& t, bool withBase) {
  std::string text = withBase ? baseText(t) : t.number(Id::alphaBase);
  bool isProduct = false;
  for (const Id damping : {Id::alphaLumaFlicker, Id::alphaNearClamp, Id::alphaHistoryContrast, Id::alphaRelax,
                           Id::alphaSampleDistance}) {
    if (t.value(damping) == 1.0f) continue;
    text = (isProduct ? text : "(" + text + ")") + " × " + t.number(damping);
    isProduct = true;
  }
  const float flicker = t.value(Id::alphaFlicker);
  const bool isFloored = t.settings().weight.source == AlphaSource::HistoryLength ||
                         dampedAlpha(t) <= t.value(Id::alphaFloor) * flicker;
  if (isFloored) text = call("max", {text, t.number(Id::alphaFloor)});
  if (flicker == 1.0f) return text;
  return (isFloored || isProduct ? text : "(" + text + ")") + " × " + t.number(Id::alphaFlicker);
}

RowStory motionStory(const Teller& t) {
  const WeightSettings& weight = t.settings().weight;
  const std::string x = "clamp(" + speedText(t, weight.motionSpeedIn) + " / " +
                        t.number(static_cast<double>(weight.motionSpeed)) + ", 0, 1)";
  const std::string words =
      t.value(Id::speed) > 0 ? say<"motion of %1 px">(t.number(Id::speed)) : say<"nothing moves">();
  switch (weight.motion) {
  case MotionAlpha::None:
    return {say<"off">(), "", ""};
  case MotionAlpha::Linear:
  case MotionAlpha::Added:
    return {words, t.equals(x, Id::alphaMotion), ""};
  case MotionAlpha::Squared:
    return {words, t.equals(x + "^2", Id::alphaMotion), ""};
  case MotionAlpha::SquaredAsPrinted: {
    const glm::vec2 uv = t.details().weighed.motionUv;
    return {say<"motion of %1 px, as fractions of the picture">(t.number(Id::speed)),
            t.equals("clamp((" + t.number(static_cast<double>(uv.x)) + ")^2 + (" +
                         t.number(static_cast<double>(uv.y)) + ")^2, 0, 1)",
                     Id::alphaMotion),
            ""};
  }
  case MotionAlpha::Doubled: {
    const std::string alpha = t.number(static_cast<double>(dampedAlpha(t)));
    return {t.value(Id::speed) > 0 ? say<"motion of %1 px doubles α at most">(t.number(Id::speed))
                                   : say<"nothing moves">(),
            t.equals(x + " × (" + call("min", {"2 × " + alpha, "1"}) + " − " + alpha + ")", Id::alphaMotion),
            ""};
  }
  }
  return {};
}

std::string screenedText(const Teller& t, bool withBase) {
  const WeightSettings& weight = t.settings().weight;
  std::string text = dampedText(t, withBase);
  const auto join = [&](Id term) {
    if (t.value(term) > 0.0f) text = "1 − (1 − (" + text + ")) × (1 − " + t.number(term) + ")";
  };
  switch (weight.motion) {
  case MotionAlpha::None:
    break;
  case MotionAlpha::SquaredAsPrinted:
    text = call("max", {text + " − 0.025", "0"});
    join(Id::alphaMotion);
    break;
  case MotionAlpha::Linear:
  case MotionAlpha::Squared:
    join(Id::alphaMotion);
    break;
  case MotionAlpha::Doubled:
    text += " + " + t.number(Id::alphaMotion);
    break;
  case MotionAlpha::Added:
    text = call("min", {text + " + " + t.number(Id::alphaMotion), "1"});
    break;
  }
  if (isOn(weight.velocityChange)) join(Id::alphaVelocityChange);
  if (isOn(weight.divergence)) join(Id::alphaDivergence);
  return text;
}

double frames(const Teller& t) {
  return framesTaken(t.details().weighed.stepSeconds, t.settings().weight);
}

RowStory frameRateStory(const Teller& t) {
  const std::string screened = screenedText(t, false);
  if (!isOn(t.settings().weight.frameRate) || frames(t) == 1.0)
    return {isOn(t.settings().weight.frameRate) ? say<"as long as the frame it is meant for">()
                                                : say<"off: whatever time the frame takes">(),
            t.equals(screened, Id::alphaFrameRate), ""};
  return {say<"for a frame that counts as %1">(t.number(frames(t))),
          t.equals("1 − (1 − (" + screened + "))^" + t.number(frames(t)), Id::alphaFrameRate), ""};
}

RowStory maskStory(const Teller& t) {
  const WeightSettings& weight = t.settings().weight;
  switch (weight.mask) {
  case MaskAlpha::Off:
    return {say<"off">(), "", ""};
  case MaskAlpha::Responsive:
    return {t.value(Id::alphaMask) > 0 ? say<"the mask asks for that much">() : say<"not masked">(),
            t.equals(t.number(static_cast<double>(weight.maskAlpha)) + " × " +
                         call("max", {t.number(Id::reactive), t.number(Id::responsive)}),
                     Id::alphaMask),
            ""};
  case MaskAlpha::Reactive:
    return {t.value(Id::alphaMask) > 0 ? say<"as much as was blended in">() : say<"nothing was blended in">(),
            t.equals(t.number(Id::reactive), Id::alphaMask), ""};
  case MaskAlpha::Exclude:
    return {t.value(Id::alphaMask) > 0 ? say<"the mask leaves history out">() : say<"not masked">(), "", ""};
  }
  return {};
}

RowStory divergenceStory(const Teller& t) {
  if (!isOn(t.settings().weight.divergence)) return {say<"off">(), "", ""};
  if (t.value(Id::alphaDivergence) == 0.0f)
    return {say<"neighbors move along, or the pixel rests">(), "", ""};
  const twin::Divergence& d = t.details().divergence;
  return {say<"a neighbor goes only %1 along">(t.percent(static_cast<double>(d.least))),
          t.equals("clamp(1 − " + t.number(d.least) + ", 0, 1) × clamp(√(" + t.number(d.fastest) + ") / " +
                       t.number(t.settings().weight.divergenceSpeed) + ", 0, 1)",
                   Id::alphaDivergence),
          ""};
}

RowStory invalidStory(const Teller& t) {
  const float invalid = t.value(Id::alphaInvalid);
  if (t.details().weighed.isFrozen) return {say<"history outside is kept whole, as printed">(), "", ""};
  if (invalid == 0.0f) return {say<"history was kept">(), "", ""};
  const std::string words = invalid >= 1.0f ? say<"history was dropped">()
                            : t.details().weighed.decays || invalid > alphaBeforeRejection(t.probed.record)
                                ? say<"history counts less">()
                                : say<"it counted no more before">();
  const ValidateSettings& validate = t.settings().validate;
  const auto reason = static_cast<twin::RejectReason>(static_cast<int>(t.value(Id::rejectReason)));
  const bool isSoft = validate.action == RejectAction::RaiseAlpha && reason >= twin::RejectReason::Depth;
  const std::string whole = isSoft ? t.number(validate.softAlpha) : "1";
  const std::string text = reason == twin::RejectReason::Velocity
                               ? "clamp((" + t.number(Id::velocityChange) + " − " +
                                     t.number(validate.velocityLimit) + ") × " +
                                     t.number(validate.velocityGain) + ", 0, 1) × " + whole
                               : whole;
  return {words, t.equals(text, Id::alphaInvalid), ""};
}

std::string alphaText(const Teller& t, bool withBase) {
  const bool isScaled = isOn(t.settings().weight.frameRate) && frames(t) != 1.0;
  std::string text = isScaled ? t.number(Id::alphaFrameRate) : screenedText(t, withBase);
  if (isUpsampled(t.settings())) text = t.number(Id::sampleConfidence) + " × (" + text + ")";
  const bool isMasked = t.value(Id::alphaMask) > 0, isInvalid = t.value(Id::alphaInvalid) > 0;
  if (t.details().weighed.decays && isInvalid) {
    if (isMasked) text = call("max", {text, t.number(Id::alphaMask)});
    return call("min", {text + " + " + t.number(Id::alphaInvalid), "1"});
  }
  if (isMasked || isInvalid) text = call("max", {text, t.number(Id::alphaMask), t.number(Id::alphaInvalid)});
  return text;
}

/// Red with a base of its own: the same terms, but those that look at α itself.
RowStory channelAlphasStory(const Teller& t) {
  const WeightSettings& weight = t.settings().weight;
  if (weight.source != AlphaSource::ContrastPerChannel)
    return {say<"α in each, %1">(t.number(Id::alpha)), "", ""};
  if (t.value(Id::alphaInvalid) >= 1.0f)
    return {say<"history was rejected: the current frame alone">(), "", ""};
  if (t.details().weighed.isFrozen) return {say<"history alone: nothing of the current frame">(), "", ""};
  const float contrast = t.details().weighed.contrast.x;
  twin::PixelRecord record = t.probed.record;
  const auto set = [&](Id id, float value) { twin::at(record, id).x = value; };
  set(Id::alphaBase, 1.0f - (0.25f + 0.6f * twin::saturated(contrast)));
  set(Id::alphaFloor, std::fmin(twin::at(record, Id::alphaBase).x, weight.minimum));
  const ProbedPixel red{record, t.details(), t.settings(), t.probed.info, t.probed.pixel};
  const Teller teller{red, t.digits};
  if (weight.motion == MotionAlpha::Doubled) {
    const float alpha = dampedAlpha(teller);
    const float speed = twin::speedIn(weight.motionSpeedIn, t.value(Id::speed), t.details().weighed.motion,
                                      t.details().picturePx);
    set(Id::alphaMotion,
        twin::saturated(speed / weight.motionSpeed) * (std::fmin(2.0f * alpha, 1.0f) - alpha));
  }
  const std::string words = say<"of each channel's own contrast, red's is %1: base %2">(
      t.number(contrast), teller.number(Id::alphaBase));
  if (isOn(weight.frameRate) && frames(t) != 1.0) return {words, "", ""};
  return {words, alphaText(teller, false) + " = " + t.number(t.color(Id::alphaChannels).x), "R"};
}

RowStory alphaStory(const Teller& t) {
  const float invalid = t.value(Id::alphaInvalid);
  if (invalid >= 1.0f)
    return {say<"history was rejected: the current frame alone">(), t.equals("1", Id::alpha), ""};
  if (t.details().weighed.isFrozen)
    return {say<"history alone: nothing of the current frame">(), t.equals("0", Id::alpha), ""};
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
  return {words, t.equals(alphaText(t, true), Id::alpha), ""};
}

RowStory changeStory(const Teller& t) {
  if (!isOn(t.settings().weight.velocityChange)) return {say<"off">(), "", ""};
  return {say<"its motion changed by %1 px">(t.number(Id::velocityChange)),
          t.equals("clamp(" + t.number(Id::velocityChange) + " / " +
                       t.number(static_cast<double>(t.settings().weight.velocityChangeSpeed)) + ", 0, 1)",
                   Id::alphaVelocityChange),
          ""};
}

} // namespace

RowStory weightStory(Id id, const Teller& t) {
  switch (id) {
  case Id::alphaBase:
    return {choiceLabel("weight.source", t.settings()), t.equals(baseText(t), id), ""};
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
