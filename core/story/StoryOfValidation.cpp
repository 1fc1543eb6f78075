// Story of stage 6: whether history belongs to the surface at all.
#include "core/story/StoryText.h"

#include "core/base/Say.h"

#include <cmath>
#include <string>

namespace taa::story {

namespace {

RowStory mismatchStory(const Teller& t) {
  const float expected = t.value(Id::depthExpected), stored = t.value(Id::historyDepth);
  if (t.details().isFirst) return {say<"there is no history to compare with">(), "", ""};
  const bool countsNearer = t.settings().validate.depthDirection == DepthDirection::Nearer;
  if (countsNearer && t.value(Id::depthMismatch) == 0.0f && stored != expected)
    return {say<"farther than expected: it hid nothing">(), "", ""};
  if (expected == 0.0f || stored == 0.0f)
    return {expected == stored ? say<"the sky, as before">() : say<"the sky against a surface">(), "", ""};
  const bool isMore = t.value(Id::depthMismatch) > t.value(Id::depthAllowed);
  const bool isTested = isOn(t.settings().validate.depth);
  const bool isFlicker = t.value(Id::geometricFlicker) > 0.0f;
  return {isFlicker  ? say<"more than is allowed, of a thin feature at rest">()
          : isMore   ? isTested ? say<"more than is allowed: another surface">()
                                : say<"more than a depth test would allow, but none runs">()
            : isTested ? say<"no more than is allowed">()
                     : say<"no more than a depth test would allow">(),
          t.formula(Id::depthMismatch), ""};
}

RowStory allowedStory(const Teller& t) {
  const ValidateSettings& validate = t.settings().validate;
  const bool hasSlope = t.value(Id::depthExpected) != 0.0f && t.value(Id::dilatedDepth) != 0.0f;
  std::string words =
      hasSlope ? say<"the tolerance, and more for the surface's slope">() : say<"the tolerance">();
  if (!isOn(validate.depth)) words = say<"%1, of a depth test that does not run">(words);
  return t.story(words, Id::depthAllowed);
}

RowStory geometricFlickerStory(const Teller& t) {
  if (!findsFlicker(t.settings())) return {say<"off">(), "", ""};
  if (t.value(Id::geometricFlicker) > 0.0f)
    return {say<"nothing parts by more than %1 px, and what is nearer is thin: single frames miss it">(
                t.number(t.settings().validate.restLimit)),
            "", ""};
  if (t.value(Id::depthMismatch) > t.value(Id::depthAllowed))
    return {say<"something moves against it, or what is nearer is not thin">(), "", ""};
  return {say<"its depth is that of history">(), "", ""};
}

/// `reason` is what the table calls it.
std::string rejectedWords(const Teller& t, const std::string& reason) {
  switch (static_cast<twin::RejectReason>(static_cast<int>(t.value(Id::rejectReason)))) {
  case twin::RejectReason::Depth:
    return say<"rejected: %1, %2 off where %3 is allowed">(reason, t.number(Id::depthMismatch),
                                                           t.number(Id::depthAllowed));
  case twin::RejectReason::OffScreen:
    return say<"rejected: %1, at %2">(reason, t.tuple(t.pair(Id::historyPosition)));
  case twin::RejectReason::Speed:
    return say<"rejected: %1, %2 px where %3 are allowed">(reason, t.number(Id::speed),
                                                           t.number(t.settings().validate.speedLimit));
  case twin::RejectReason::Object:
    return say<"rejected: %1, %2 was here">(reason, t.number(Id::historyObjectId));
  case twin::RejectReason::Normal:
    return say<"rejected: %1, cosine %2">(reason, t.number(Id::normalAgreement));
  case twin::RejectReason::Velocity:
    return say<"rejected: %1, it changed by %2 px">(reason, t.number(Id::velocityChange));
  case twin::RejectReason::Kept:
  case twin::RejectReason::NoHistory:
  case twin::RejectReason::NoPrevious:
  case twin::RejectReason::Class:
    break;
  }
  return say<"rejected: %1">(reason);
}

/// Those that run, by what they would reject for.
std::string testsText(const ValidateSettings& validate) {
  std::string text;
  const auto add = [&text](bool runs, twin::RejectReason reason) {
    if (runs) text += (text.empty() ? "" : ", ") + std::string(rejectReasonText(static_cast<int>(reason)));
  };
  add(validate.offScreen != OffScreen::Keep, twin::RejectReason::OffScreen);
  add(isOn(validate.depth), twin::RejectReason::Depth);
  add(isOn(validate.object), twin::RejectReason::Object);
  add(isOn(validate.objectClass), twin::RejectReason::Class);
  add(isOn(validate.normal), twin::RejectReason::Normal);
  add(isOn(validate.speed), twin::RejectReason::Speed);
  add(validate.velocity != VelocityTest::None, twin::RejectReason::Velocity);
  return text;
}

RowStory reasonStory(const Teller& t) {
  const int reason = static_cast<int>(t.value(Id::rejectReason));
  if (reason == 0 && t.value(Id::geometricFlicker) > 0.0f)
    return {say<"kept: depth differs at rest, of a thin feature that single frames miss">(), "", ""};
  if (reason == 0) {
    const std::string tests = testsText(t.settings().validate);
    return {tests.empty() ? say<"kept: no test runs">() : say<"kept: all tests passed (%1)">(tests), "", ""};
  }
  return {rejectedWords(t, std::string(rejectReasonText(reason))), "", ""};
}

RowStory normalStory(const Teller& t) {
  if (!isOn(t.settings().validate.normal)) return {say<"off">(), "", ""};
  if (t.details().isFirst) return {say<"there is no history to compare with">(), "", ""};
  const glm::vec3 now = t.details().geometry.normal, then = t.details().match.normal;
  if (now == then && now == glm::vec3(0.0f)) return {say<"the sky, as before">(), "", ""};
  if (then == glm::vec3(0.0f) && t.value(Id::normalAgreement) == 1.0f)
    return {say<"history keeps no normals yet">(), "", ""};
  const double cosine = std::fmax(-1.0, std::fmin(1.0, static_cast<double>(t.value(Id::normalAgreement))));
  return {say<"the surface turned by %1 degrees">(t.number(std::acos(cosine) * 57.29577951)),
          t.formula(Id::normalAgreement), ""};
}

RowStory velocityStory(const Teller& t) {
  const VelocityTest test = t.settings().validate.velocity;
  if (test == VelocityTest::None && !isOn(t.settings().weight.velocityChange)) return {say<"off">(), "", ""};
  if (t.details().isFirst) return {say<"there is no history to compare with">(), "", ""};
  const glm::vec2 now = t.details().geometry.motion, then = t.details().match.motion;
  if (now.x >= kNoPreviousPosition || then.x >= kNoPreviousPosition)
    return {say<"there is no motion to compare">(), "", ""};
  if (t.value(Id::velocityChange) == 0.0f && then == glm::vec2(0.0f) && now != then)
    return {say<"history keeps no motion yet">(), "", ""};
  const std::string words = t.value(Id::velocityChange) == 0.0f
                                ? say<"its motion is the same as a frame ago">()
                                : say<"its motion is another than a frame ago">();
  return t.story(words, Id::velocityChange);
}

} // namespace

RowStory validateStory(Id id, const Teller& t) {
  switch (id) {
  case Id::depthExpected:
    return {t.value(id) == 0.0f   ? say<"the sky, or nothing before">()
            : t.details().isFirst ? say<"where the surface would have been a frame before">()
                                  : say<"where the surface was in the previous frame">(),
            "", ""};
  case Id::historyDepth:
    return {t.details().isFirst ? say<"there is no history yet">()
                                : say<"of the depths stored around, the one that fits best">(),
            "", ""};
  case Id::depthMismatch:
    return mismatchStory(t);
  case Id::depthAllowed:
    return allowedStory(t);
  case Id::geometricFlicker:
    return geometricFlickerStory(t);
  case Id::historyObjectId:
    if (t.details().isFirst) return {say<"there is no history yet">(), "", ""};
    if (!isOn(t.settings().validate.object) && !isOn(t.settings().validate.objectClass))
      return {say<"not kept: no test compares objects">(), "", ""};
    return {t.value(id) == 0.0f                    ? say<"the sky, or not kept yet">()
            : t.value(id) == t.value(Id::objectId) ? say<"the same object">()
                                                   : say<"another object than now">(),
            "", ""};
  case Id::normalAgreement:
    return normalStory(t);
  case Id::velocityChange:
    return velocityStory(t);
  case Id::rejectReason:
    return reasonStory(t);
  default: // no row of this stage
    return {};
  }
}

} // namespace taa::story
