#include "core/verdict/pixel/VerdictText.h"

#include "core/base/Say.h"
#include "core/settings/Faults.h"
#include "core/story/StoryText.h"

#include <cmath>

namespace taa {

namespace {

std::string kindLabel(VerdictKind kind) {
  return sayLabel(kVerdictKinds[static_cast<std::size_t>(kind)].label);
}

std::string stepsText(double shown) {
  return story::numberText(255.0 * shown, 3);
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

bool testsGeometry(const ValidateSettings& validate) {
  return isOn(validate.depth) || isOn(validate.object) || isOn(validate.objectClass) ||
         isOn(validate.normal) || validate.velocity != VelocityTest::None;
}

std::string pulledText(const PixelVerdict& verdict, const Settings& settings) {
  if (settings.rectify.method == RectifyMethod::None) return say<"history is taken as it is">();
  const double pulled = decidingValue(verdict, IntermediateId::clipAmount);
  if (pulled == 0.0) return say<"its color lies within those around, so that rectification leaves it">();
  return say<"rectification pulls it %1 of the way only">(story::percentText(pulled));
}

std::string ghostReason(const PixelVerdict& verdict, const Settings& settings) {
  if (verdict.isBlended)
    return say<"it was blended over the surface, where no geometry tells that it has gone, and %1">(
        pulledText(verdict, settings));
  switch (verdict.stage) {
  case Stage::Reproject:
    return say<"history is read in place, not where the surface was">();
  case Stage::DilateMotion:
    return say<"the pixel follows a neighbor's motion, and reads what that neighbor came from">();
  case Stage::Inputs:
    return say<"its motion vector is not the surface's motion">();
  case Stage::RectifyHistory:
    return say<"no test of geometry runs, and %1">(pulledText(verdict, settings));
  default:
    break;
  }
  if (!testsGeometry(settings.validate))
    return say<"no test of geometry runs, and %1">(pulledText(verdict, settings));
  const int reason = static_cast<int>(decidingValue(verdict, IntermediateId::rejectReason));
  if (reason != 0) return say<"it was found out (%1), and still counts">(sayLabel(rejectReasonText(reason)));
  return say<"the tests of geometry let it pass, and %1">(pulledText(verdict, settings));
}

std::string averagedText(const PixelVerdict& verdict) {
  const std::string samples = story::numberText(decidingValue(verdict, IntermediateId::historyLength), 3);
  return samples == "1" ? say<"1 sample is shown">() : say<"%1 samples are averaged">(samples);
}

/// In which way reading history is wrong depends on its filter.
std::string readingReason(HistoryFilter filter) {
  if (filter == HistoryFilter::Point)
    return say<"history is read at the nearest pixel, beside where the surface was">();
  if (filter == HistoryFilter::Bilinear) return say<"reading history between its pixels takes detail">();
  return say<"reading history between its pixels changes detail">();
}

std::string restartReason(const PixelVerdict& verdict) {
  const int reason = static_cast<int>(decidingValue(verdict, IntermediateId::rejectReason));
  if (verdict.throwsGoodAway)
    return say<"history was thrown away (%1), although the surface was there; %2">(
        sayLabel(rejectReasonText(reason)), averagedText(verdict));
  return say<"the surface was not to be seen before, and %1">(averagedText(verdict));
}

std::string reasonOf(const PixelVerdict& verdict, const Settings& settings) {
  if (!isTaaOn(settings)) return say<"TAA is off">();
  switch (verdict.kind) {
  case VerdictKind::None:
    break;
  case VerdictKind::Ghost:
    return ghostReason(verdict, settings);
  case VerdictKind::DisocclusionRestart:
    return restartReason(verdict);
  case VerdictKind::Flicker:
  case VerdictKind::HighlightFlicker:
    if (verdict.stage == Stage::ValidateHistory) return say<"history is thrown away again and again">();
    if (verdict.stage == Stage::RectifyHistory)
      return say<"rectification follows the samples of single frames">();
    return say<"each sample shows, for the current frame counts %1">(
        story::percentText(decidingValue(verdict, IntermediateId::alpha)));
  case VerdictKind::Aliasing:
    if (verdict.stage == Stage::ValidateHistory) return restartReason(verdict);
    if (verdict.stage == Stage::Jitter) return say<"all samples are of one place in the pixel">();
    return say<"the current frame counts %1">(
        story::percentText(decidingValue(verdict, IntermediateId::alpha)));
  case VerdictKind::Blur:
    if (verdict.stage == Stage::SampleHistory) return readingReason(settings.history.filter);
    if (verdict.stage == Stage::Inputs)
      return say<"the samples of all frames are off the same way, so that no number of them mends it">();
    if (verdict.stage == Stage::FilterCurrent)
      return say<"the filter of the current frame takes detail, frame by frame">();
    return say<"rectification takes good history back to the colors around">();
  case VerdictKind::MaskSmear:
    if (verdict.stage == Stage::Inputs)
      return say<"its material changes without motion, and no mask says so">();
    return say<"the mask is set, and history counts all the same">();
  case VerdictKind::Lag:
    if (verdict.part == ErrorPart::Older)
      return say<"history is of before that, and whether the light was another then, or something else was "
                 "there, is not known">();
    return say<"what is seen has changed, and %1">(pulledText(verdict, settings));
  }
  return {};
}

/// "Ghost of the red bar, 6 frames ago"
std::string faultText(const PixelVerdict& verdict, int frame, const std::string& object) {
  std::string text = kindLabel(verdict.kind);
  if (verdict.causeObject)
    text = say<"%1 of %2">(text, *verdict.causeObject == 0 ? say<"the sky">()
                                 : object.empty()          ? say<"object %1">(*verdict.causeObject)
                                                           : object);
  if (verdict.part == ErrorPart::Older && verdict.kind == VerdictKind::Lag)
    text = say<"%1, since before frame %2">(text, verdict.since);
  else if (verdict.kind == VerdictKind::Ghost || verdict.kind == VerdictKind::DisocclusionRestart)
    text = say<"%1, %2">(text, agoText(frame - verdict.causeFrame));
  else if (verdict.kind == VerdictKind::Lag || verdict.kind == VerdictKind::Aliasing)
    text = say<"%1, since frame %2">(text, verdict.since);
  return text;
}

} // namespace

std::string verdictSentence(const PixelVerdict& verdict, int frame, const std::string& object,
                            const Settings& settings) {
  const std::string sentence =
      verdict.kind == VerdictKind::None
          ? say<"Nothing is wrong: %1">(verdictMeasures(verdict))
          : say<"%1: %2.">(faultText(verdict, frame, object), reasonOf(verdict, settings));
  return isFaulty(settings) ? say<"%1 Faults are injected.">(sentence) : sentence;
}

std::string verdictMeasures(const PixelVerdict& verdict) {
  return say<"%1 of 255 steps off the reference, where up to %2 are no error, and %3 from frame to frame.">(
      stepsText(verdict.error), stepsText(kVisibleError), stepsText(verdict.flicker));
}

} // namespace taa
