// What is special about rows of a pixel, in words.
#include "core/base/Say.h"
#include "core/explanation/RowFormatter.h"
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Traced.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace taa::explanation {

bool isMoved(const RowFormatter& t) {
  if (t.value(Id::clipAmount) > 0.0f || t.color(Id::historyRectified) != t.color(Id::historyRaw)) return true;
  return t.details().trace && std::ranges::any_of(t.details().trace->rectifiedBox,
                                                  [](const twin::Operand& x) { return x.value != 0.0; });
}

bool isMixedPerChannel(const RowFormatter& t) {
  return t.settings().weight.source == AlphaSource::ContrastPerChannel;
}

bool isCurrentAlone(const RowFormatter& t) {
  const glm::vec3 channels = t.color(Id::alphaChannels);
  return isMixedPerChannel(t) ? std::fmin(channels.x, std::fmin(channels.y, channels.z)) >= 1.0f
                              : t.value(Id::blendFactor) >= 1.0f;
}

namespace {

std::string sampleWords(const RowFormatter& t) {
  if (!isTaaOn(t.settings())) return say<"the sample of this frame, at the pixel's center">();
  const std::string at = t.tuple(-t.details().jitterPx);
  return t.settings().jitter.projection == JitterProjection::Translation
             ? say<"the sample of this frame, taken %1 px from the pixel's center">(at)
             : say<"the sample of this frame, which the resolve believes %1 px from the pixel's center">(at);
}

std::string motionWords(const RowFormatter& t) {
  if (t.value(Id::motion) >= kNoPreviousPosition)
    return t.settings().inputs.motion == MotionSource::ObjectsAsPrinted
               ? say<"the surface was behind the previous camera, or its motion as printed is beyond all "
                     "numbers">()
               : say<"the surface was behind the previous camera">();
  const glm::vec2 motion = t.pair(Id::motion);
  return motion == glm::vec2(0.0f) ? say<"the surface stayed where it was">()
                                   : say<"the surface came from %1 px from here">(t.tuple(-motion));
}

std::string offsetWords(const RowFormatter& t) {
  const glm::vec2 offset = t.pair(Id::dilatedOffset);
  if (offset == glm::vec2(0.0f)) return say<"the pixel's own motion is used">();
  return say<"the motion of the neighbor at %1 is used: %2">(t.tuple(offset),
                                                             choiceLabel("dilate.method", t.settings()));
}

std::string positionWords(const RowFormatter& t) {
  if (t.settings().reproject.method == ReprojectMethod::InPlace)
    return say<"the pixel's own center: history is read in place, whatever moves">();
  return t.value(Id::dilatedMotion) >= kNoPreviousPosition ? say<"there is no previous position">() : "";
}

/// By what history is read, and where.
std::string historyWords(const RowFormatter& t) {
  const glm::vec2 at = t.details().readPosition;
  const bool isEdge = t.value(Id::depthEdge) != 0.0f;
  const std::string filter =
      isEdge ? say<"Bilinear, for depth has an edge">() : choiceLabel("history.filter", t.settings());
  const std::size_t taps = t.details().historyTaps.count;
  return say<"%1: %2 at %3, %4 of a texel from the one before">(
      filter, taps == 1 ? say<"one tap">() : say<"%1 taps">(taps), t.tuple(at),
      t.tuple((at - 0.5f) - glm::vec2(std::floor(at.x - 0.5f), std::floor(at.y - 0.5f))));
}

std::string upsampledWords(const RowFormatter& t) {
  const std::string kernel = choiceLabel("current.upsample", t.settings());
  const std::string offset = t.tuple(t.details().sampleOffset);
  const auto taps = t.details().upsampleTaps.all();
  float sum = 0.0f;
  for (const twin::Taps::Tap& tap : taps) sum += tap.weight;
  return sum > 1e-4f // else nothing is left to divide by
             ? say<"%1 over %2 samples of what was drawn smaller, the nearest %3 px from the center">(
                   kernel, taps.size(), offset)
             : say<"%1: the nearest sample, %2 px from the center">(kernel, offset);
}

std::string currentWords(const RowFormatter& t) {
  if (!isTaaOn(t.settings())) return say<"TAA is off: the sample as it is">();
  if (isUpsampled(t.settings())) return upsampledWords(t);
  const std::string filter = choiceLabel("current.filter", t.settings());
  return t.settings().current.sharpen == CurrentSharpen::None
             ? filter
             : say<"%1, then sharpened by the four around">(filter);
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

std::string reasonWords(const RowFormatter& t) {
  const int reason = static_cast<int>(t.value(Id::rejectReason));
  if (reason != 0) return say<"rejected: %1">(std::string(rejectReasonText(reason)));
  if (t.value(Id::geometricFlicker) > 0.0f)
    return say<"kept: depth differs at rest, of a thin feature that single frames miss">();
  const std::string tests = testsText(t.settings().validate);
  return tests.empty() ? say<"kept: no test runs">() : say<"kept: all tests passed (%1)">(tests);
}

/// Which sample takes the place of history.
std::string selectedWords(const RowFormatter& t) {
  const std::size_t k =
      twin::nearestSample(twin::toBox(t.color(Id::historyRaw), t.settings().space), t.details().neighborhood);
  if (k == 4) return say<"of the nine samples the pixel's own is nearest to history">();
  const int number = static_cast<int>(k);
  const std::string step = t.tuple(glm::vec2(glm::ivec2(number % 3 - 1, number / 3 - 1)));
  return say<"of the nine samples that at %1 is nearest to history">(step);
}

/// Some methods leave history where it is outside of the box, too.
std::string keptWords(const RowFormatter& t) {
  const RectifyMethod method = t.settings().rectify.method;
  if (method == RectifyMethod::Select) return say<"history is one of the nine samples: kept as it is">();
  if (method == RectifyMethod::ClipToHull || method == RectifyMethod::ClipToBoth)
    return say<"history lies within the slabs around the samples: kept as it is">();
  const twin::Neighborhood& hood = t.details().neighborhood;
  const glm::vec3 h = twin::toBox(t.color(Id::historyRaw), t.settings().space);
  return h != glm::clamp(h, hood.boxMin, hood.boxMax)
             ? say<"no wall of the box is hit on the way to the current color: kept as it is">()
             : say<"history lies inside the box: kept as it is">();
}

/// How far history was pulled.
std::string rectifiedWords(const RowFormatter& t) {
  const RectifyMethod method = t.settings().rectify.method;
  if (method == RectifyMethod::None) return say<"history is taken as it is">();
  if (!isMoved(t)) return keptWords(t);
  if (method == RectifyMethod::Select) return selectedWords(t);
  if (!(t.value(Id::clipAmount) > 0.0f))
    return say<"outside of the box, but nothing of the correction is applied">();
  const std::string words = say<"pulled %1 of the way to %2">(t.percent(Id::clipAmount), targetText(method));
  const float held = t.details().lockState.protection;
  return held > 0.0f ? say<"%1, after %2 were taken back">(words, percentText(static_cast<double>(held)))
                     : words;
}

std::string alphaWords(const RowFormatter& t) {
  if (!isTaaOn(t.settings())) return say<"TAA is off: the current frame alone">();
  if (t.value(Id::alphaInvalid) >= 1.0f) return say<"history was rejected: the current frame alone">();
  if (t.details().weighed.isFrozen) return say<"history alone: nothing of the current frame">();
  return say<"%1 current, by %2">(t.percent(Id::alpha), choiceLabel("weight.source", t.settings()));
}

std::string mixWords(const RowFormatter& t) {
  if (t.settings().blend.restart == Restart::Blurred && t.value(Id::alphaInvalid) >= 1.0f)
    return say<"history starts with the mean of the pixel and its diagonals">();
  if (isCurrentAlone(t)) return say<"the current frame alone">();
  const std::string words = isMixedPerChannel(t)
                                ? say<"mixed in each channel by its own α">()
                                : say<"%1 current, the rest history">(t.percent(Id::blendFactor));
  return twin::mixesCompressed(t.settings().blend.tone)
             ? say<"%1; mixed on the tone curve %2">(words, choiceLabel("blend.tone", t.settings()))
             : words;
}

} // namespace

std::string rowWords(Id id, const RowFormatter& t) {
  switch (id) {
  case Id::color:
    return sampleWords(t);
  case Id::depth:
    return t.value(id) == 0.0f ? say<"nothing was drawn here: the sky">() : "";
  case Id::motion:
    return motionWords(t);
  case Id::dilatedOffset:
    return offsetWords(t);
  case Id::historyPosition:
    return positionWords(t);
  case Id::historyRaw:
    return historyWords(t);
  case Id::currentFiltered:
    return currentWords(t);
  case Id::rejectReason:
    return reasonWords(t);
  case Id::historyRectified:
    return rectifiedWords(t);
  case Id::alphaBase:
    return choiceLabel("weight.source", t.settings());
  case Id::alpha:
    return alphaWords(t);
  case Id::resolved:
    return storedWords(t, mixWords(t));
  default:
    return {};
  }
}

} // namespace taa::explanation
