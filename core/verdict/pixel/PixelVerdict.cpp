#include "core/verdict/pixel/PixelVerdict.h"

#include "core/verdict/pixel/OlderError.h"
#include "core/verdict/pixel/SurfaceMoments.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace taa {

// In the order of the enumerators.
constexpr std::array<VerdictKindInfo, 9> kVerdictKinds{{
    {VerdictKind::None, "none", "Nothing is wrong",
     "The pixel is as far from the reference as a converged one may be, and still."},
    {VerdictKind::Ghost, "ghost", "Ghost", "History is of something that was there before."},
    {VerdictKind::DisocclusionRestart, "disocclusionRestart", "Restart after disocclusion",
     "The surface has just come into sight, and its few samples are not averaged yet."},
    {VerdictKind::Flicker, "flicker", "Flicker",
     "What is shown changes from frame to frame, and truth does not."},
    {VerdictKind::HighlightFlicker, "highlightFlicker", "Highlight flicker",
     "Samples brighter than white come and go."},
    {VerdictKind::Blur, "blur", "Blur", "Detail was lost by reading between pixels, or by filters."},
    {VerdictKind::Aliasing, "aliasing", "Aliasing",
     "Too few samples are averaged, although there were more."},
    {VerdictKind::MaskSmear, "maskSmear", "Smear of a mask",
     "What changes without motion is smeared, because no mask, or a wrong one, says that it does."},
    {VerdictKind::Lag, "lag", "Lag", "The light has changed, and history has not."},
}};

namespace {

using RowId = IntermediateId;

/// Rectification moves history by some of the way nearly everywhere; by less than this share it does nothing.
constexpr double kClippedShare = 0.05;

bool isRestart(const twin::PixelRecord& record) {
  return recordValue(record, RowId::alpha) >= 1.0;
}

class Judge {
 public:
  Judge(const VerdictEvidence& evidence, const Settings& settings)
      : evidence_(evidence), origin_(evidence.older ? *evidence.older : evidence.error), settings_(settings),
        now_(evidence.moments.front()) {}

  PixelVerdict verdict();

 private:
  void measure();
  void findPart();
  void findOnset();
  void conclude();
  void concludeGhost();
  void nameGhost();
  void findLastOf(int object);
  void concludeSamples();
  void concludeHistory();
  void concludeLag();
  Stage stageOfGhost();
  Stage stageOfFlicker() const;
  void addRow(RowId id, const SurfaceMoment& moment, std::optional<double> limit = {});
  void addGhostRow(RowId id, std::optional<double> limit = {});
  const SurfaceMoment* restart() const;
  bool isThrownAwayAgain() const;
  bool areSamplesOff() const;
  bool isOfOnePlace() const;
  double meanBias() const;
  bool isFiltered() const;
  bool hasJustAppeared() const;
  bool isNoFlicker() const;
  bool wasBlendedOver() const;

  const VerdictEvidence& evidence_;
  const PixelError& origin_; // where the error came in
  const Settings& settings_;
  const SurfaceMoment& now_;
  PixelVerdict found_;
};

PixelVerdict Judge::verdict() {
  measure();
  findPart();
  found_.since = found_.causeFrame = evidence_.error.frame;
  if (found_.error < kVisibleError && found_.flicker < kVisibleFlicker) {
    addRow(RowId::historyLength, now_);
    addRow(RowId::alpha, now_);
    addRow(RowId::clipAmount, now_);
    addRow(RowId::rejectReason, now_);
    return found_;
  }
  findOnset();
  conclude();
  return found_;
}

void Judge::measure() {
  found_.error = largestMagnitude(shownValue(now_.resolved) - shownValue(now_.reference));
  found_.flicker = flickerOf(evidence_.moments);
}

void Judge::findPart() {
  const MainPart main = mainPart(evidence_.error);
  found_.share = main.share;
  found_.part = evidence_.older ? mainPart(*evidence_.older).part : main.part;
}

// It came in with the oldest frame that brought an eighth of what the one that brought most did.
void Judge::findOnset() {
  const glm::dvec3 error = origin_.error();
  const auto brought = [&](const ErrorOfFrame& entry) {
    return glm::dot(of(entry.split, found_.part), error);
  };
  double most = 0.0;
  for (const ErrorOfFrame& entry : origin_.frames) {
    if (brought(entry) <= most) continue;
    most = brought(entry);
    found_.causeFrame = entry.frame;
  }
  for (const ErrorOfFrame& entry : origin_.frames)
    if (brought(entry) >= most / 8.0) found_.since = entry.frame;
  const glm::dvec3 today = evidence_.error.error();
  found_.isOlder = evidence_.older.has_value() || found_.part == ErrorPart::Older ||
                   glm::dot(of(evidence_.error.sum, ErrorPart::Older), today) > 0.25 * glm::dot(today, today);
}

void Judge::conclude() {
  if (!isTaaOn(settings_)) {
    found_.kind = VerdictKind::Aliasing;
    found_.stage = Stage::Blend;
    addRow(RowId::alpha, now_);
    addRow(RowId::historyLength, now_);
    return;
  }
  if (found_.flicker >= kVisibleFlicker && !isNoFlicker()) {
    found_.kind = isHighlight(evidence_.moments) ? VerdictKind::HighlightFlicker : VerdictKind::Flicker;
    found_.stage = stageOfFlicker();
    for (const RowId id : {RowId::color, RowId::clipAmount, RowId::rejectReason, RowId::alpha})
      addRow(id, now_);
    return;
  }
  switch (found_.part) {
  case ErrorPart::Ghost:
    return concludeGhost();
  case ErrorPart::Aliasing:
    return concludeSamples();
  case ErrorPart::Lag:
  case ErrorPart::Older:
    return concludeLag();
  case ErrorPart::Blur:
  case ErrorPart::Rectification:
    return concludeHistory();
  }
}

// An error that is not of single frames' samples trembles as well, with where on the pixels things fall: what
// moved, changed or came into sight is wrong then, or the filter that takes the same from all samples.
bool Judge::isNoFlicker() const {
  if (found_.error < kVisibleError) return false;
  switch (found_.part) {
  case ErrorPart::Ghost:
  case ErrorPart::Lag:
  case ErrorPart::Blur:
    return true;
  case ErrorPart::Aliasing:
    return hasJustAppeared() || (isFiltered() && !isHighlight(evidence_.moments));
  case ErrorPart::Rectification:
  case ErrorPart::Older:
    return false;
  }
  return false;
}

void Judge::concludeGhost() {
  found_.kind = VerdictKind::Ghost;
  nameGhost();
  found_.stage = stageOfGhost();
}

// The object whose samples pull the pixel furthest the error's way; where none does, as behind what
// rectification made of them, what history was read of.
void Judge::nameGhost() {
  const glm::dvec3 error = origin_.error();
  std::map<int, double> pulls; // by object
  for (const StraySamples& stray : origin_.strays) pulls[stray.object] += glm::dot(stray.pull, error);
  double most = 0.0;
  for (const auto& [object, pull] : pulls) {
    if (pull <= most) continue;
    most = pull;
    found_.causeObject = object;
  }
  if (found_.causeObject) return findLastOf(*found_.causeObject);
  for (const ErrorOfFrame& entry : origin_.frames)
    if (entry.frame == evidence_.ghostFrame && entry.ghostObject >= 0) found_.causeObject = entry.ghostObject;
  if (evidence_.ghostFrame >= 0) found_.causeFrame = evidence_.ghostFrame - 1; // what was seen there then
}

// The latest frame that shows the object at least half as far off as any does: all of what a frame is sampled
// of, for the first samples of a history, and what is older than those followed, count many times.
void Judge::findLastOf(int object) {
  const auto offOf = [&](const StraySamples& stray) {
    return stray.object == object && stray.weight > 0.0 ? glm::dot(stray.pull, origin_.error()) / stray.weight
                                                        : 0.0;
  };
  double most = 0.0;
  for (const StraySamples& stray : origin_.strays) most = std::max(most, offOf(stray));
  for (const StraySamples& stray : origin_.strays) {
    if (most == 0.0 || offOf(stray) < 0.5 * most) continue;
    found_.causeFrame = stray.frame;
    return;
  }
}

// The first in the order of the stages that did not do what it is there for.
Stage Judge::stageOfGhost() {
  const twin::PixelRecord& record = evidence_.ghostRecord;
  const glm::dvec2 used(glm::vec2(twin::at(record, RowId::dilatedMotion)));
  addGhostRow(RowId::dilatedMotion);
  if (settings_.reproject.method == ReprojectMethod::InPlace) return Stage::Reproject;
  const bool isOfMotion = std::ranges::any_of(origin_.frames, [&](const ErrorOfFrame& entry) {
    return entry.frame == evidence_.ghostFrame && entry.isGhostOfMotion;
  });
  const ValidateSettings& validate = settings_.validate;
  const bool tests = isOn(validate.depth) || isOn(validate.object) || isOn(validate.objectClass) ||
                     isOn(validate.normal) || validate.velocity != VelocityTest::None;
  const bool isUnguarded = !tests && settings_.rectify.method == RectifyMethod::None;
  if (isOfMotion && evidence_.ghostMotion && glm::distance(used, *evidence_.ghostMotion) > 0.5) {
    const bool isNeighbors = twin::at(record, RowId::dilatedOffset) != glm::vec4(0.0f);
    const glm::dvec2 own(glm::vec2(twin::at(record, RowId::motion)));
    const bool isOwnWrong = !isNeighbors || glm::distance(own, *evidence_.ghostMotion) > 0.5;
    // Beside edges dilation reads amiss by design: to find that out is what tests and rectification are for.
    if (isOwnWrong || !isUnguarded) {
      addGhostRow(RowId::dilatedOffset);
      return isOwnWrong ? Stage::Inputs : Stage::DilateMotion;
    }
  }
  addGhostRow(RowId::depthMismatch, recordValue(record, RowId::depthAllowed));
  addGhostRow(RowId::rejectReason);
  addGhostRow(RowId::clipAmount);
  addGhostRow(RowId::alpha);
  return tests || isUnguarded ? Stage::ValidateHistory : Stage::RectifyHistory;
}

// Rectification that left history as it was in all but a few frames made none of it.
Stage Judge::stageOfFlicker() const {
  if (isThrownAwayAgain()) return Stage::ValidateHistory;
  const auto clipped = std::ranges::count_if(evidence_.moments, [](const SurfaceMoment& moment) {
    return recordValue(moment.record, RowId::clipAmount) > kClippedShare;
  });
  const bool isClipped = 8 * static_cast<std::size_t>(clipped) >= evidence_.moments.size();
  return isClipped ? Stage::RectifyHistory : Stage::BlendWeight;
}

/// The latest moment in which history was given up; null: none.
const SurfaceMoment* Judge::restart() const {
  const auto at = std::ranges::find_if(evidence_.moments,
                                       [](const SurfaceMoment& moment) { return isRestart(moment.record); });
  return at == evidence_.moments.end() ? nullptr : &*at;
}

/// Whether tests rejected history more than once. Where it starts there is none to throw away.
bool Judge::isThrownAwayAgain() const {
  return std::ranges::count_if(evidence_.moments, [](const SurfaceMoment& moment) {
           return recordValue(moment.record, RowId::rejectReason) > 1.0; // RejectReason::NoHistory
         }) > 1;
}

/// Whether it is not the filter of the current frame that is off one way: the samples before it are as well,
/// by more than half as much.
bool Judge::areSamplesOff() const {
  glm::dvec3 way(0.0), sampled(0.0), filtered(0.0);
  for (const ErrorOfFrame& entry : origin_.frames) way += of(entry.split, ErrorPart::Aliasing);
  for (const SurfaceMoment& moment : evidence_.moments) {
    sampled += glm::dvec3(glm::vec3(twin::at(moment.record, RowId::color))) - moment.reference;
    filtered += glm::dvec3(glm::vec3(twin::at(moment.record, RowId::currentFiltered))) - moment.reference;
  }
  return glm::dot(filtered, way) > 0.0 && glm::dot(sampled, way) > 0.5 * glm::dot(filtered, way);
}

/// Whether all samples have one color, as where the jitter moves nothing.
bool Judge::isOfOnePlace() const {
  constexpr double kOneColor = 1.0 / 255.0;
  const auto shown = [](const SurfaceMoment& moment) {
    return shownValue(glm::dvec3(glm::vec3(twin::at(moment.record, RowId::color))));
  };
  const glm::dvec3 first = shown(now_);
  return std::ranges::all_of(evidence_.moments, [&](const SurfaceMoment& moment) {
    return largestMagnitude(shown(moment) - first) < kOneColor;
  });
}

/// How much of the samples' errors points one way: 1 where all do, as behind a filter that blurs.
double Judge::meanBias() const {
  glm::dvec3 sum(0.0);
  double sizes = 0.0;
  for (const ErrorOfFrame& entry : origin_.frames) {
    sum += of(entry.split, ErrorPart::Aliasing);
    sizes += glm::length(of(entry.split, ErrorPart::Aliasing));
  }
  return sizes > 0.0 ? glm::length(sum) / sizes : 0.0;
}

/// Whether all of four samples or more are off one way, so that no number of them mends it.
bool Judge::isFiltered() const {
  constexpr double kOneWay = 0.8;
  const auto sampled = std::ranges::count_if(origin_.frames, [](const ErrorOfFrame& entry) {
    return of(entry.split, ErrorPart::Aliasing) != glm::dvec3(0.0);
  });
  const bool isEnough = sampled > 3 && recordValue(now_.record, RowId::historyLength) > 3.5;
  return isEnough && meanBias() > kOneWay;
}

/// Whether there could be no more samples: as many are averaged as there are frames that show the surface, or
/// it was hidden when history was given up.
bool Judge::hasJustAppeared() const {
  const auto seen = static_cast<double>(evidence_.moments.size());
  if (evidence_.endsHidden && recordValue(now_.record, RowId::historyLength) < seen + 0.5) return true;
  const SurfaceMoment* start = restart();
  if (!start) return false;
  if (start == &evidence_.moments.back() && evidence_.endsHidden) return true;
  return recordValue(start->record, RowId::rejectReason) == 1.0 || // RejectReason::NoHistory
         wasBehind(start->record);
}

void Judge::concludeSamples() {
  const bool isNew = hasJustAppeared();
  const SurfaceMoment* start = isFiltered() ? nullptr : restart();
  if (!start && isNew && !isFiltered()) start = &evidence_.moments.back();
  if (start) {
    found_.since = found_.causeFrame = start->frame;
    found_.kind = isNew ? VerdictKind::DisocclusionRestart : VerdictKind::Aliasing;
    found_.stage = Stage::ValidateHistory;
    found_.throwsGoodAway = !isNew;
    addRow(RowId::rejectReason, *start, 0.0);
    addRow(RowId::depthMismatch, *start, recordValue(start->record, RowId::depthAllowed));
    addRow(RowId::historyLength, now_);
    addRow(RowId::alpha, now_);
    return;
  }
  found_.kind = isFiltered() ? VerdictKind::Blur : VerdictKind::Aliasing;
  found_.stage = isFiltered() ? Stage::FilterCurrent : Stage::BlendWeight;
  if (isFiltered() && areSamplesOff()) {
    if (isOfOnePlace()) found_.kind = VerdictKind::Aliasing;
    found_.stage = isOfOnePlace() ? Stage::Jitter : Stage::Inputs;
    addRow(RowId::color, now_);
  }
  addRow(RowId::currentFiltered, now_);
  addRow(RowId::alpha, now_);
  addRow(RowId::historyLength, now_);
  addRow(RowId::clipAmount, now_);
}

void Judge::concludeHistory() {
  addRow(RowId::historyRaw, now_);
  addRow(RowId::historyRectified, now_);
  addRow(RowId::clipAmount, now_);
  addRow(RowId::alpha, now_);
  found_.kind = VerdictKind::Blur;
  found_.throwsGoodAway = found_.part == ErrorPart::Rectification;
  found_.stage = found_.throwsGoodAway ? Stage::RectifyHistory : Stage::SampleHistory;
}

/// Whether something was blended over the surface in the frame that brought most, or in the one before it.
bool Judge::wasBlendedOver() const {
  return std::ranges::any_of(origin_.frames, [&](const ErrorOfFrame& entry) {
    return (entry.frame == found_.causeFrame || entry.frame == found_.causeFrame - 1) && entry.isBlendedOver;
  });
}

// A surface looks other than it did because something was blended over it, because its material changes
// without motion, or because the light did. Which of them, or whether something else was there, is not known
// of what is older than all frames that were followed.
void Judge::concludeLag() {
  for (const RowId id : {RowId::historyRaw, RowId::historyRectified, RowId::clipAmount, RowId::alpha})
    addRow(id, now_);
  const bool isUnguarded = settings_.rectify.method == RectifyMethod::None;
  found_.stage = Stage::RectifyHistory;
  found_.kind = VerdictKind::Lag;
  if (found_.part == ErrorPart::Older) return;
  if (wasBlendedOver()) {
    found_.kind = VerdictKind::Ghost;
    found_.isBlended = true;
    if (isUnguarded) found_.stage = Stage::ValidateHistory;
    return;
  }
  addRow(RowId::alphaMask, now_);
  const double mask =
      std::max(recordValue(now_.record, RowId::reactive), recordValue(now_.record, RowId::responsive));
  if (mask > 0.0 || evidence_.error.frames.front().isChanging) {
    found_.kind = VerdictKind::MaskSmear;
    found_.stage = mask > 0.0 ? Stage::BlendWeight : Stage::Inputs;
  }
}

void Judge::addRow(RowId id, const SurfaceMoment& moment, std::optional<double> limit) {
  found_.rows.push_back({id, moment.frame, moment.pixel, recordValue(moment.record, id), limit});
}

void Judge::addGhostRow(RowId id, std::optional<double> limit) {
  for (const ErrorOfFrame& entry : origin_.frames)
    if (entry.frame == evidence_.ghostFrame)
      found_.rows.push_back(
          {id, entry.frame, entry.ghostPixel, recordValue(evidence_.ghostRecord, id), limit});
}

} // namespace

glm::dvec3 shownValue(const glm::dvec3& linear) {
  glm::dvec3 shown;
  for (int channel = 0; channel < 3; ++channel) {
    const double value = std::clamp(linear[channel], 0.0, 1.0);
    shown[channel] = value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
  }
  return shown;
}

PixelVerdict judge(const VerdictEvidence& evidence, const Settings& settings) {
  return Judge(evidence, settings).verdict();
}

} // namespace taa
