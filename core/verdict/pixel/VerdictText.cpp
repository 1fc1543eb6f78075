#include "core/verdict/pixel/VerdictText.h"

#include "core/base/Say.h"
#include "core/explanation/RowFormatter.h"
#include "core/render/Jitter.h"
#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"
#include "core/verdict/pixel/SurfaceMoments.h"

#include <string_view>

namespace taa {

namespace {

std::string kindLabel(VerdictKind kind) {
  return std::string(kVerdictKinds[static_cast<std::size_t>(kind)].label);
}

/// Two digits, three from 100 on: finer is noise.
std::string stepsText(double shown) {
  return numberText(255.0 * shown, 255.0 * shown < 99.5 ? 2 : 3);
}

std::string agoText(int frames) {
  if (frames <= 0) return say<"in this frame">();
  return frames == 1 ? say<"1 frame ago">() : say<"%1 frames ago">(frames);
}

const VerdictRow* decidingRow(const PixelVerdict& verdict, IntermediateId id) {
  for (const VerdictRow& row : verdict.rows)
    if (row.id == id) return &row;
  return nullptr;
}

double decidingValue(const PixelVerdict& verdict, IntermediateId id) {
  const VerdictRow* row = decidingRow(verdict, id);
  return row ? row->value : 0.0;
}

twin::RejectReason decidingReason(const PixelVerdict& verdict) {
  return static_cast<twin::RejectReason>(
      static_cast<int>(decidingValue(verdict, IntermediateId::rejectReason)));
}

std::string rejectedText(const PixelVerdict& verdict) {
  return std::string(rejectReasonText(static_cast<int>(decidingReason(verdict))));
}

std::string alphaText(const PixelVerdict& verdict) {
  return explanation::percentText(decidingValue(verdict, IntermediateId::alpha));
}

/// The label of what a setting chooses: "Catmull-Rom 5".
std::string chosenText(std::string_view path, const Settings& settings) {
  const Parameter& row = parameter(path);
  return std::string(row.choices[static_cast<std::size_t>(row.get(settings))].label);
}

bool testsGeometry(const ValidateSettings& validate) {
  return isOn(validate.depth) || isOn(validate.object) || isOn(validate.objectClass) ||
         isOn(validate.normal) || validate.velocity != VelocityTest::None;
}

/// What rectification does about history that is wrong.
std::string pulledText(const PixelVerdict& verdict, const Settings& settings) {
  if (settings.rectify.method == RectifyMethod::None) return say<"history is not rectified">();
  const double pulled = decidingValue(verdict, IntermediateId::clipAmount);
  if (pulled <= 0.005) return say<"rectification leaves it, for the old color lies inside the color box">();
  if (pulled >= 0.995)
    return say<"history is rectified fully, to a color box that still holds a part of the difference">();
  return say<"rectification removes only %1 of it">(explanation::percentText(pulled));
}

std::string ghostReason(const PixelVerdict& verdict, const Settings& settings) {
  if (verdict.isBlended)
    return say<"it was blended over the surface, so no geometry test sees that it has gone, and %1">(
        pulledText(verdict, settings));
  switch (verdict.stage) {
  case Stage::Reproject:
    return say<"history is read in place, not where the surface was">();
  case Stage::DilateMotion:
    return say<"dilation takes a neighbor's motion, so history is read where that neighbor was">();
  case Stage::Inputs:
    return say<"the motion vector is not the surface's motion">();
  case Stage::RectifyHistory:
    return say<"no geometry test runs, and %1">(pulledText(verdict, settings));
  default:
    break;
  }
  if (!testsGeometry(settings.validate))
    return say<"no geometry test runs, and %1">(pulledText(verdict, settings));
  if (decidingReason(verdict) != twin::RejectReason::Kept)
    return say<"a test rejected it (%1), and it still counts">(rejectedText(verdict));
  return say<"the geometry tests accept it, and %1">(pulledText(verdict, settings));
}

std::string averagedText(const PixelVerdict& verdict) {
  const std::string samples = numberText(decidingValue(verdict, IntermediateId::historyLength), 2);
  return samples == "1" ? say<"only 1 sample is shown">() : say<"only %1 samples are averaged">(samples);
}

/// In which way reading history is wrong depends on its filter.
std::string readingReason(const Settings& settings) {
  const std::string filter = chosenText("history.filter", settings);
  if (settings.history.filter == HistoryFilter::Point)
    return say<"history is read at the nearest pixel, not where the surface was">();
  if (settings.history.filter == HistoryFilter::Bilinear)
    return say<"resampling history (%1) loses detail every frame">(filter);
  return say<"resampling history (%1) changes detail every frame">(filter);
}

std::string flickerReason(const PixelVerdict& verdict, const Settings& settings) {
  const auto& [events, frames, largest] = verdict.repeated;
  if (verdict.stage == Stage::FilterCurrent)
    return say<"the current-frame filter (%1) takes in neighbors brighter than white, in %2 of the last %3 "
               "frames">(chosenText("current.filter", settings), events, frames);
  if (verdict.stage == Stage::Blend)
    return say<
        "in %1 of the last %2 frames the sample is brighter than white, and blending (%3) does not even "
        "that out">(events, frames, chosenText("blend.tone", settings));
  if (verdict.stage == Stage::ValidateHistory)
    return say<"tests reject history again and again, in %1 of the last %2 frames">(events, frames);
  if (verdict.stage == Stage::RectifyHistory)
    return say<"the color box changes with every jittered frame, and history is clipped to it, in %1 of the "
               "last %2 frames, by up to %3">(events, frames, explanation::percentText(largest));
  return say<"the current frame has a weight (α) of %1, so each frame's jittered sample shows">(
      alphaText(verdict));
}

std::string reasonOf(const PixelVerdict& verdict, int frame, const Settings& settings) {
  if (!isTaaOn(settings)) return say<"TAA is off, so only this frame's sample is shown. Turn TAA on">();
  switch (verdict.kind) {
  case VerdictKind::None:
    break;
  case VerdictKind::Ghost:
    return ghostReason(verdict, settings);
  case VerdictKind::DisocclusionRestart: {
    const std::string start = agoText(frame - verdict.causeFrame);
    if (verdict.stage == Stage::BlendWeight)
      return say<"history started %1, and α weighs the samples since then unequally, so %2">(
          start, averagedText(verdict));
    const bool wasNone = decidingReason(verdict) == twin::RejectReason::NoHistory;
    return wasNone ? say<"history started %1, so %2">(start, averagedText(verdict))
                   : say<"the surface came into sight %1, so %2">(start, averagedText(verdict));
  }
  case VerdictKind::Flicker:
  case VerdictKind::HighlightFlicker:
    return flickerReason(verdict, settings);
  case VerdictKind::Aliasing:
    if (verdict.stage == Stage::ValidateHistory)
      return say<"a test rejected history (%1), although the surface was visible before; %2">(
          rejectedText(verdict), averagedText(verdict));
    if (verdict.stage == Stage::Jitter) {
      const int places = jitterPeriod(settings.jitter);
      if (places == 1 || places > kFewJitterPlaces || settings.jitter.scale == 0.0f)
        return say<"all samples lie at one place of the pixel">();
      return say<"the mean of the jitter's %1 places is not the pixel's. Take a longer pattern">(places);
    }
    if (decidingValue(verdict, IntermediateId::alpha) >= 1.0)
      return say<"α is 1 although history is valid, so only this frame's sample is shown. Lower α">();
    return say<"the current frame has a weight (α) of %1, so too few samples are averaged">(
        alphaText(verdict));
  case VerdictKind::Blur:
    switch (verdict.stage) {
    case Stage::SampleHistory:
      return readingReason(settings);
    case Stage::DilateMotion:
      return say<"dilation takes a neighbor's motion, so history is read beside the surface's own place">();
    case Stage::Inputs:
      return say<"all samples so far err in one direction, so averaging more of them does not help">();
    case Stage::FilterCurrent:
      return say<"the current-frame filter (%1) mixes in neighbors">(chosenText("current.filter", settings));
    default:
      return say<"history was right, and rectification clips it toward this frame's neighborhood">();
    }
  case VerdictKind::MaskSmear:
    if (verdict.stage == Stage::Inputs)
      return say<"the material changes without motion, and no mask marks it">();
    return say<"a mask marks the surface, and history still counts: α is %1">(alphaText(verdict));
  case VerdictKind::Lag:
    if (verdict.part == ErrorPart::Older)
      return say<"the cause is older than the %1 frames that were followed: other light, or another surface">(
          kVerdictFrames);
    return say<"the light or the shading changed, and %1">(pulledText(verdict, settings));
  }
  return {};
}

/// "Ghost of the red bar, here until frame 34"
std::string faultText(const PixelVerdict& verdict, const std::string& object) {
  std::string text = kindLabel(verdict.kind);
  if (verdict.causeObject)
    text = say<"%1 of %2">(text, *verdict.causeObject == 0 ? say<"the sky">()
                                 : object.empty()          ? say<"object %1">(*verdict.causeObject)
                                                           : object);
  if (verdict.part == ErrorPart::Older && verdict.kind == VerdictKind::Lag)
    return say<"%1 since before frame %2">(text, verdict.since);
  if (verdict.kind == VerdictKind::Ghost)
    return verdict.causeObject ? say<"%1, here until frame %2">(text, verdict.causeFrame)
                               : say<"%1 since frame %2">(text, verdict.since);
  if (verdict.kind == VerdictKind::Lag || verdict.kind == VerdictKind::Aliasing)
    return say<"%1 since frame %2">(text, verdict.since);
  return text;
}

} // namespace

std::string verdictSentence(const PixelVerdict& verdict, int frame, const std::string& object,
                            const Settings& settings) {
  const std::string sentence =
      verdict.kind == VerdictKind::None
          ? say<"Nothing is wrong. %1">(verdictMeasures(verdict))
          : say<"%1: %2.">(faultText(verdict, object), reasonOf(verdict, frame, settings));
  return isFaulty(settings) ? say<"%1 Faults are injected.">(sentence) : sentence;
}

std::string verdictMeasures(const PixelVerdict& verdict) {
  return say<"Error %1/255 (visible from %2), flicker %3/255 per frame.">(
      stepsText(verdict.error), stepsText(kVisibleError), stepsText(verdict.flicker));
}

} // namespace taa
