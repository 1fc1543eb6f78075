// Which rows no run of the resolve has to write. Every entry follows from the GLSL of the row's stage, and a
// test compares its bits with those written.
#include "core/taa/RowSources.h"

#include "core/taa/OutputPass.h"

#include <algorithm>

namespace taa {

namespace {

using enum IntermediateId;

/// `value` where nothing computes the row.
std::optional<float> constantUnless(bool isComputed, float value) {
  return isComputed ? std::nullopt : std::optional(value);
}

struct ConstantRow {
  IntermediateId id;
  std::optional<float> (*value)(const Settings&);
  bool isNumber = false;
};

bool hasMask(const Settings& s) {
  return s.inputs.mask != MaskSource::None;
}

bool hasForwardMap(const Settings& s) {
  return isOn(s.inputs.forward);
}

bool hasOverlay(const Settings& s) {
  return s.inputs.blended == BlendedAs::After;
}

bool takesEdges(const Settings& s) {
  return isOn(s.history.bilinearAtEdges) && s.history.filter != HistoryFilter::Point &&
         s.history.filter != HistoryFilter::Bilinear;
}

bool changesGamma(const Settings& s) {
  return isOn(s.neighborhood.motionGamma) || isOn(s.neighborhood.contrastGamma) ||
         isOn(s.neighborhood.maskRelax) || isOn(s.neighborhood.resolutionGamma);
}

bool weighsByLuma(const Settings& s) {
  return s.blend.tone == ToneWeight::Luma || s.blend.tone == ToneWeight::LumaAsPrinted;
}

bool comparesMotion(const Settings& s) {
  return s.validate.velocity != VelocityTest::None || isOn(s.weight.velocityChange);
}

std::optional<float> constantStrength(const Settings& s) {
  if (s.rectify.method == RectifyMethod::None) return 0.0f;
  return constantUnless(isOn(s.rectify.relaxAtRest) || findsFlicker(s), 1.0f);
}

std::optional<float> constantFloor(const Settings& s) {
  if (s.weight.source == AlphaSource::HistoryLength) return s.weight.minimum;
  return constantUnless(s.weight.source != AlphaSource::Constant, std::min(s.weight.alpha, s.weight.minimum));
}

constexpr ConstantRow kConstants[] = {
    {reactive, [](const Settings& s) { return constantUnless(hasMask(s), 0.0f); }},
    {responsive, [](const Settings& s) { return constantUnless(hasMask(s), 0.0f); }},
    {overlay, [](const Settings& s) { return constantUnless(hasOverlay(s), 0.0f); }},
    {overlayAlpha, [](const Settings& s) { return constantUnless(hasOverlay(s), 0.0f); }},
    {dilatedOffset,
     [](const Settings& s) { return constantUnless(s.dilate.method != DilateMethod::None, 0.0f); }},
    {forwardCount, [](const Settings& s) { return constantUnless(hasForwardMap(s), -1.0f); }},
    {depthEdge, [](const Settings& s) { return constantUnless(takesEdges(s), 0.0f); }},
    {sampleConfidence, [](const Settings& s) { return constantUnless(isUpsampled(s), 1.0f); }},
    {boxGamma, [](const Settings& s) { return constantUnless(changesGamma(s), s.neighborhood.gamma); }, true},
    {clipAmount,
     [](const Settings& s) { return constantUnless(s.rectify.method != RectifyMethod::None, 0.0f); }},
    {rectifyStrength, constantStrength},
    {lock, [](const Settings& s) { return constantUnless(isOn(s.rectify.locks), 0.0f); }},
    {lockLife, [](const Settings& s) { return constantUnless(isOn(s.rectify.locks), 0.0f); }},
    {instability, [](const Settings& s) { return constantUnless(isOn(s.rectify.instability), 0.0f); }},
    {geometricFlicker, [](const Settings& s) { return constantUnless(findsFlicker(s), 0.0f); }},
    {historyObjectId,
     [](const Settings& s) {
       return constantUnless(isOn(s.validate.object) || isOn(s.validate.objectClass), 0.0f);
     }},
    {normalAgreement, [](const Settings& s) { return constantUnless(isOn(s.validate.normal), 1.0f); }},
    {velocityChange, [](const Settings& s) { return constantUnless(comparesMotion(s), 0.0f); }},
    {alphaBase,
     [](const Settings& s) {
       return constantUnless(s.weight.source != AlphaSource::Constant, s.weight.alpha);
     },
     true},
    {alphaFloor, constantFloor, true},
    {alphaLumaFlicker, [](const Settings& s) { return constantUnless(isOn(s.weight.lumaFlicker), 1.0f); }},
    {alphaNearClamp, [](const Settings& s) { return constantUnless(isOn(s.weight.nearClamp), 1.0f); }},
    {alphaHistoryContrast,
     [](const Settings& s) { return constantUnless(isOn(s.weight.historyContrast), 1.0f); }},
    {alphaRelax, [](const Settings& s) { return constantUnless(isOn(s.neighborhood.maskRelax), 1.0f); }},
    {alphaSampleDistance,
     [](const Settings& s) { return constantUnless(s.weight.sampleDistance != SampleDistance::None, 1.0f); }},
    {alphaFlicker, [](const Settings& s) { return constantUnless(findsFlicker(s), 1.0f); }},
    {alphaMotion,
     [](const Settings& s) { return constantUnless(s.weight.motion != MotionAlpha::None, 0.0f); }},
    {alphaVelocityChange,
     [](const Settings& s) { return constantUnless(isOn(s.weight.velocityChange), 0.0f); }},
    {alphaDivergence, [](const Settings& s) { return constantUnless(isOn(s.weight.divergence), 0.0f); }},
    {alphaMask, [](const Settings& s) { return constantUnless(s.weight.mask != MaskAlpha::Off, 0.0f); }},
    {toneWeightCurrent, [](const Settings& s) { return constantUnless(weighsByLuma(s), 1.0f); }},
    {toneWeightHistory, [](const Settings& s) { return constantUnless(weighsByLuma(s), 1.0f); }},
    {sharpenDetail,
     [](const Settings& s) { return constantUnless(isTaaOn(s) && s.output.sharpen != Sharpen::None, 0.0f); }},
    {blurTrust,
     [](const Settings& s) { return constantUnless(isTaaOn(s) && isOn(s.output.motionBlur), 1.0f); }},
};

struct HeldEntry {
  IntermediateId id;
  HeldRow row;
  bool (*isHeld)(const Settings&);
};

constexpr auto kWithoutDilation = [](const Settings& s) {
  return !isUpsampled(s) && s.dilate.method == DilateMethod::None;
};
constexpr auto kAtFullSize = [](const Settings& s) { return !isUpsampled(s); };
constexpr auto kWithMask = [](const Settings& s) { return !isUpsampled(s) && hasMask(s); };
constexpr auto kWithForwardMap = [](const Settings& s) { return !isUpsampled(s) && hasForwardMap(s); };
constexpr auto kWithOverlay = [](const Settings& s) { return !isUpsampled(s) && hasOverlay(s); };
constexpr auto kShowsResolved = [](const Settings& s) { return !changesOutput(s); };
constexpr auto kAlways = [](const Settings&) { return true; };

// The resolve writes colors to the history that were rounded before to what it can hold, and lengths as
// 32-bit floats (blend.glsl). What else a history keeps is computed from rows and is none itself.
constexpr HeldEntry kHeld[] = {
    {color, {&FrameInputs::color}, kAtFullSize},
    {depth, {&FrameInputs::depth}, kAtFullSize},
    {motion, {&FrameInputs::motion}, kAtFullSize},
    {normal, {&FrameInputs::normal}, kAtFullSize},
    {objectId, {&FrameInputs::objectId}, kAtFullSize},
    {objectClass, {&FrameInputs::normal, nullptr, 3}, kAtFullSize},
    {reactive, {&FrameInputs::mask}, kWithMask},
    {responsive, {&FrameInputs::mask, nullptr, 1}, kWithMask},
    {overlay, {&FrameInputs::overlay}, kWithOverlay},
    {overlayAlpha, {&FrameInputs::overlay, nullptr, 3}, kWithOverlay},
    {forwardCount, {&FrameInputs::forwardCount}, kWithForwardMap},
    {dilatedDepth, {&FrameInputs::depth}, kWithoutDilation},
    {dilatedMotion, {&FrameInputs::motion}, kWithoutDilation},
    {depthExpected, {&FrameInputs::previousDepth}, kWithoutDilation},
    {historyLength, {nullptr, &History::surface}, kAlways},
    {resolved, {nullptr, &History::color}, kAlways},
    {output, {nullptr, &History::color}, kShowsResolved},
};

struct SameRow {
  IntermediateId id, as;
  bool (*isSame)(const Settings&);
};

constexpr auto kBoxIsMinMax = [](const Settings& s) {
  return s.neighborhood.box == BoxKind::MinMax && !isOn(s.neighborhood.chromaShrink) &&
         !isOn(s.neighborhood.includeFiltered);
};

constexpr SameRow kSameRows[] = {
    {alpha, alphaChannels,
     [](const Settings& s) { return s.weight.source != AlphaSource::ContrastPerChannel; }},
    {historyKeptLength, historyRawLength,
     [](const Settings& s) {
       return s.rectify.method != RectifyMethod::ClampForget && s.validate.action != RejectAction::Decay;
     }},
    {historyRectified, historyRaw, [](const Settings& s) { return s.rectify.method == RectifyMethod::None; }},
    {boxMin, neighborhoodMin, kBoxIsMinMax},
    {boxMax, neighborhoodMax, kBoxIsMinMax},
};

} // namespace

RowSources rowSources(const Settings& settings) {
  RowSources sources;
  const auto at = [&](IntermediateId id) -> RowSource& { return sources.rows[static_cast<std::size_t>(id)]; };
  for (const ConstantRow& row : kConstants) {
    at(row.id).constant = row.value(settings);
    at(row.id).isNumber = row.isNumber;
  }
  for (const HeldEntry& entry : kHeld)
    if (entry.isHeld(settings)) at(entry.id).held = entry.row;
  for (const SameRow& row : kSameRows)
    if (row.isSame(settings)) at(row.id).same = row.as;
  sources.historyTargets = historyTargets(settings);
  return sources;
}

} // namespace taa
