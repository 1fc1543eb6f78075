#include "core/explanation/ProbeHeadline.h"

#include "core/base/Say.h"
#include "core/base/Text.h"
#include "core/explanation/ProbeValues.h"
#include "core/settings/Faults.h"
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Known.h"
#include "core/taa/twin/Stages.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cctype>
#include <cmath>
#include <utility>

namespace taa {

namespace {

using explanation::countsLess;
using explanation::Id;
using explanation::percentText;
using explanation::tupleText;
using explanation::Values;

// --- Whose motion ---

/// Motion of the pixel itself in px of the picture. Sizes of what is drawn are whole, so it is known to some
/// thousandths.
glm::vec2 ownMotion(const Values& v) {
  const glm::vec2 motion = v.pair(Id::motion);
  return motion.x >= kNoPreviousPosition ? motion : motion / v.settings.inputs.renderScale;
}

std::string movedText(const glm::vec2& motion) {
  if (motion.x >= kNoPreviousPosition) return say<"no previous position">();
  if (motion == glm::vec2(0.0f)) return say<"did not move">();
  return say<"moved %1 px">(tupleText(motion, 3));
}

/// On a surface that leans the neighbor in front has nearly the motion of the pixel: that is not worth a
/// word.
std::string motionLine(const Values& v) {
  const glm::vec2 offset = v.pair(Id::dilatedOffset), used = v.pair(Id::dilatedMotion), own = ownMotion(v);
  if (v.settings.reproject.method == ReprojectMethod::InPlace)
    return say<"%1, but history is read in place">(movedText(own));
  const bool isSame = glm::distance(own, used) <= 0.01f + 0.01f * glm::length(used);
  if (offset == glm::vec2(0.0f)) return movedText(used);
  if (isSame) return movedText(own);
  const std::string at = tupleText(offset, 3);
  if (used.x >= kNoPreviousPosition)
    return say<"%1, but follows the neighbor at %2, which has no previous position">(movedText(own), at);
  if (used == glm::vec2(0.0f))
    return say<"%1, but follows the neighbor at %2, which did not move">(movedText(own), at);
  return say<"%1, but follows the neighbor at %2, which moved %3 px">(movedText(own), at, tupleText(used, 3));
}

// --- What became of history ---

/// Whether a color lies outside of the samples around and of the box made from them, by more than a fiftieth
/// of white, box space.
bool isUnlikeAround(const Values& v, Id id) {
  constexpr float kVisible = 0.02f;
  const glm::vec3 color = twin::toBox(v.color(id), v.settings.space);
  const glm::vec3 low = glm::min(v.color(Id::neighborhoodMin), v.color(Id::boxMin));
  const glm::vec3 high = glm::max(v.color(Id::neighborhoodMax), v.color(Id::boxMax));
  for (int i = 0; i < 3; ++i)
    if (color[i] < low[i] - kVisible || color[i] > high[i] + kVisible) return true;
  return false;
}

std::string depthText(float depth) {
  return depth == 0.0f ? say<"the sky">() : say<"%1 m">(numberText(depth, 3));
}

/// What of the depth speaks against it: "another surface by its depth (6.15 m, expected 8.6 m)".
std::string surfaceText(const Values& v) {
  return say<"another surface by its depth (%1, expected %2)">(depthText(v.of(Id::historyDepth)),
                                                               depthText(v.of(Id::depthExpected)));
}

std::string untestedText(const Values& v, const std::string& text) {
  return isOn(v.settings.validate.depth) ? text : say<"%1; no depth test runs">(text);
}

std::string keptText(const Values& v) {
  const RectifySettings& rectify = v.settings.rectify;
  std::string text;
  if (v.of(Id::clipAmount) <= 0)
    text = say<"history kept as it was">();
  else if (rectify.method == RectifyMethod::Select)
    text = say<"history replaced by the sample that is most like it">();
  else
    text = say<"history kept, pulled %1 of the way to %2">(v.percent(Id::clipAmount),
                                                           explanation::targetText(rectify.method));
  if (v.of(Id::lock) > 0) text = say<"%1, locked">(text);
  if (v.of(Id::instability) > 0) text = say<"%1, for its luma comes and goes">(text);
  return text;
}

/// What speaks against history that was kept.
std::string doubtText(const Values& v, const std::string& kept) {
  if (v.of(Id::geometricFlicker) > 0)
    return say<"%1; its depth differs as of a thin feature at rest, which single frames miss">(kept);
  switch (historyDoubt(v.record, v.settings)) {
  case HistoryDoubt::None:
    break;
  case HistoryDoubt::OffScreen:
    return v.settings.history.border == HistoryBorder::Black
               ? say<"%1, although it lies off the screen, where it is black">(kept)
               : say<"%1, although it lies off the screen, where the border is read instead">(kept);
  case HistoryDoubt::OtherColor:
    return say<"%1, although its color is none of those around">(kept);
  case HistoryDoubt::OtherSurface:
    return untestedText(v, say<"%1, although it is of %2">(kept, surfaceText(v)));
  case HistoryDoubt::Ghost:
    return untestedText(
        v,
        say<"%1, although it is a ghost, %2 of the result: %3, and in a color that is none of those around">(
            kept, percentText(1.0 - static_cast<double>(v.of(Id::blendFactor))), surfaceText(v)));
  }
  // What was allowed only for the slope is worth knowing where it is much.
  const float mismatch = v.of(Id::depthMismatch);
  const float tolerance = v.settings.validate.depthTolerance;
  if (!isOn(v.settings.validate.depth) || !(mismatch > 2.0f * tolerance)) return kept;
  return say<"%1; its depth is off by %2, and %3 are allowed where the surface recedes so">(
      kept, percentText(mismatch), v.percent(Id::depthAllowed));
}

/// Beyond the one border that is tested as printed history is kept whole (manual 5.7).
bool isFrozen(const Values& v) {
  return v.settings.validate.offScreen == OffScreen::OneSided &&
         static_cast<int>(v.of(Id::rejectReason)) == static_cast<int>(twin::RejectReason::OffScreen);
}

std::string historyLine(const Values& v) {
  const int reason = static_cast<int>(v.of(Id::rejectReason));
  if (!isTaaOn(v.settings)) return say<"TAA is off">();
  if (reason == 0) return doubtText(v, keptText(v));
  if (twin::isFirst(v.record)) return say<"there is no history yet">();
  const std::string why(rejectReasonText(reason));
  const float invalid = v.of(Id::alphaInvalid);
  if (invalid >= 1.0f) return say<"history rejected: %1">(why);
  if (isFrozen(v)) return say<"history kept whole, as printed: %1">(why);
  if (countsLess(v)) return say<"history counts less: %1">(why);
  return say<"history failed a test (%1), which changes nothing: it counted no more before">(why);
}

// --- How α came about ---

/// A sum of samples is rarely whole: "7" or "6.4".
std::string lengthText(float frames) {
  return numberText(frames, 3);
}

std::string lowered(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

/// α of the source by itself: "1/(7 + 1)", or the source's name and value.
std::string sourceText(const Values& v) {
  if (v.settings.weight.source == AlphaSource::HistoryLength)
    return say<"1/(%1 + 1)">(lengthText(v.of(Id::historyKeptLength)));
  return lowered(explanation::choiceLabel("weight.source", v.settings)) + " " + v.number(Id::alphaBase);
}

/// Source × what damps it, not below the floor.
std::string dampedSource(const Values& v, const std::string& source) {
  std::string text = source;
  float product = v.of(Id::alphaBase);
  for (const Id damping : {Id::alphaLumaFlicker, Id::alphaNearClamp, Id::alphaHistoryContrast, Id::alphaRelax,
                           Id::alphaSampleDistance}) {
    if (v.of(damping) == 1.0f) continue;
    text += " × " + v.number(damping);
    product *= v.of(damping);
  }
  const bool isByLength = v.settings.weight.source == AlphaSource::HistoryLength;
  if (isByLength || product < v.of(Id::alphaFloor)) text = say<"max(%1, %2)">(text, v.number(Id::alphaFloor));
  return v.of(Id::alphaFlicker) == 1.0f ? text : text + " × " + v.number(Id::alphaFlicker);
}

/// And what motion adds (manual §13), and how much the samples say where fewer are drawn (manual §22).
std::string alphaLine(const Values& v, const FrameInfo& info) {
  if (twin::isFirst(v.record) || v.of(Id::alphaInvalid) >= 1 || !isTaaOn(v.settings))
    return say<"α = 1: the current frame alone">();
  if (isFrozen(v)) return say<"α = 0: history alone">();
  const std::string source = sourceText(v);
  std::string text = dampedSource(v, source);
  if (v.of(Id::alphaMotion) > 0) text = say<"%1 and %2 by motion">(text, v.number(Id::alphaMotion));
  if (v.of(Id::alphaVelocityChange) > 0)
    text = say<"%1 and %2 by its change">(text, v.number(Id::alphaVelocityChange));
  if (v.of(Id::alphaDivergence) > 0)
    text = say<"%1 and %2 by divergence">(text, v.number(Id::alphaDivergence));
  if (isOn(v.settings.weight.frameRate) &&
      explanation::framesTaken(info.stepSeconds, v.settings.weight) != 1.0)
    text = say<"%1 by the frame's time">(text);
  if (isUpsampled(v.settings)) text = say<"κ %1 × (%2)">(v.number(Id::sampleConfidence), text);
  if (v.of(Id::alphaMask) > 0) text = say<"max(%1, %2 by mask)">(text, v.number(Id::alphaMask));
  if (v.of(Id::alphaInvalid) > 0)
    text = v.settings.validate.action == RejectAction::Decay
               ? say<"%1 and %2 as rejected">(text, v.number(Id::alphaInvalid))
               : say<"%1, at least %2 when rejected">(text, v.number(Id::alphaInvalid));
  if (text != source) text += " = " + v.number(Id::alpha); // a source alone is told with its value
  if (v.settings.weight.source == AlphaSource::ContrastPerChannel)
    text = say<"%1, of channels %2">(text, tupleText(v.color(Id::alphaChannels), 3));
  if (v.settings.weight.source == AlphaSource::HistoryLength)
    return say<"N = %1 → α = %2">(lengthText(v.of(Id::historyKeptLength)), text);
  return say<"α = %1">(text);
}

// --- What is left ---

std::string lengthLine(const Values& v) {
  const std::string length = lengthText(v.of(Id::historyLength));
  const HistoryDoubt doubt = historyDoubt(v.record, v.settings);
  if (doubt == HistoryDoubt::OtherSurface || doubt == HistoryDoubt::Ghost)
    return say<"N = %1 counts samples of the other surface, too">(length);
  switch (v.settings.blend.length) {
  case LengthRule::Confidence:
  case LengthRule::VarianceAsPrinted:
    return say<"N = %1 from now on">(length);
  case LengthRule::Variance:
  case LengthRule::Count:
  case LengthRule::Reciprocal:
  case LengthRule::CountTo16:
    break;
  }
  return say<"Frames of samples now: N = %1">(length);
}

/// What is shown instead of the resolved color; empty where that is.
std::string outputLine(const Values& v) {
  const OutputSettings& output = v.settings.output;
  const float detail = v.of(Id::sharpenDetail), trust = v.of(Id::blurTrust);
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (output.sharpen != Sharpen::None && detail != 0) {
    const std::string amount = numberText(std::fabs(detail), 4);
    add(detail > 0 ? say<"sharpened: %1 brighter">(amount) : say<"sharpened: %1 darker">(amount));
  }
  if (isOn(output.motionBlur) && trust < 1)
    add(say<"%1 motion blur">(percentText(1.0 - static_cast<double>(trust))));
  if (v.of(Id::overlayAlpha) > 0) add(say<"%1 hidden by the overlay">(v.percent(Id::overlayAlpha)));
  return text.empty() ? text : say<"Shown %1">(text);
}

std::string capitalized(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

} // namespace

HistoryDoubt historyDoubt(const twin::PixelRecord& record, const Settings& settings) {
  const Values v{record, settings};
  if (v.of(Id::rejectReason) != 0.0f || v.of(Id::blendFactor) >= 1.0f) return HistoryDoubt::None;
  if (v.of(Id::onScreen) == 0.0f) return HistoryDoubt::OffScreen;
  if (v.of(Id::geometricFlicker) > 0.0f) return HistoryDoubt::None; // found to be the same, at rest
  const bool isUnlike = isUnlikeAround(v, Id::historyRectified);
  if (v.of(Id::depthMismatch) > v.of(Id::depthAllowed))
    return isUnlike ? HistoryDoubt::Ghost : HistoryDoubt::OtherSurface;
  return isUnlike && v.of(Id::clipAmount) == 0.0f ? HistoryDoubt::OtherColor : HistoryDoubt::None;
}

std::vector<std::string> probeHeadline(const twin::PixelRecord& record, const Settings& settings,
                                       const FrameInfo& info) {
  const Values v{record, settings};
  std::vector<std::string> lines{capitalized(say<"%1, %2">(motionLine(v), historyLine(v))),
                                 alphaLine(v, info), lengthLine(v)};
  if (std::string shown = outputLine(v); !shown.empty()) lines.push_back(std::move(shown));
  if (const auto faults = injectedFaults(settings); !faults.empty())
    lines.push_back(say<"Faults are injected: %1">(joined(faults)));
  return lines;
}

} // namespace taa
