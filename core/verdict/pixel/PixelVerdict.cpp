#include "core/verdict/pixel/PixelVerdict.h"

#include "core/base/Light.h"
#include "core/render/Jitter.h"
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
using twin::RejectReason;

/// Rectification moves history by some of the way nearly everywhere; by less than this share it does nothing.
constexpr double kClippedShare = 0.05;

/// So many samples at most are a young history, which began 8 frames ago: an older one is expected to average
/// as many.
constexpr std::size_t kYoungFrames = 9;
/// So few samples are too few, however they are weighed.
constexpr std::size_t kFewFrames = 4;
/// At this weight of the current frame (2 − α)/α = 3 frames' samples are averaged.
constexpr double kFewSamplesAlpha = 0.5;
/// At this one one and a half: what is seen is the current frame's sample.
constexpr double kOneSampleAlpha = 0.8;
/// And at this one seven, which flicker whatever rectification does.
constexpr double kFlickeringAlpha = 0.25;
/// What changes by this share of its error in each frame is right every other frame.
constexpr double kMostlyFlicker = 0.6;

/// A part of so much of the error explains it.
constexpr double kExplainsAll = 0.9;

/// History read by less than this beside its place, px, is of the same spot and its neighbors.
constexpr double kBesidePx = 1.5;
/// Over all frames: half a pixel is where a texel ends.
constexpr double kDriftPx = 0.5;

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
  void concludeFlicker();
  void concludeGhost();
  void nameGhost();
  void findLastOf(int object);
  void concludeSamples();
  void concludeHistory();
  void concludeLag();
  void concludeDrift();
  void concludeChange();
  void addHistoryRows();
  Stage stageOfGhost();
  std::optional<Stage> stageOfDrift() const;
  Stage stageOfFlicker();
  void addRow(RowId id, const SurfaceMoment& moment, std::optional<double> limit = {});
  void addGhostRow(RowId id, std::optional<double> limit = {});
  const SurfaceMoment* restart() const;
  bool averagesTooFew() const;
  double smallerWeight() const;
  bool isPassed() const;
  std::map<int, double> pulls() const;
  bool isOfAnother() const;
  double changedShare() const;
  bool hasChanged() const { return changedShare() > 0.5; }
  bool areHighlightsRare() const;
  double shareOf(ErrorPart part) const;
  bool isGhostBelowBlur() const;
  bool isPartlyGhost() const;
  bool isOfOtherPlace() const;
  int rejections() const;
  void limitOnset();
  bool areSamplesOff() const;
  bool isOfOnePlace() const;
  bool isOfFewPlaces() const;
  double rectifiedShare() const;
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
  limitOnset();
  found_.isOlder = evidence_.older.has_value() || found_.part == ErrorPart::Older ||
                   glm::dot(of(evidence_.error.sum, ErrorPart::Older), today) > 0.25 * glm::dot(today, today);
}

// What was not to be seen in a frame had not begun then: parts may cancel for a while.
void Judge::limitOnset() {
  for (const SurfaceMoment& moment : evidence_.moments) {
    if (moment.frame < found_.since) return;
    if (largestMagnitude(shownValue(moment.resolved) - shownValue(moment.reference)) >= kVisibleError)
      continue;
    found_.since = std::max(found_.since, std::min(moment.frame + 1, now_.frame));
    return;
  }
}

void Judge::conclude() {
  if (!isTaaOn(settings_)) {
    found_.kind = VerdictKind::Aliasing;
    found_.stage = Stage::Jitter; // every sample lies in the middle of its pixel
    addRow(RowId::alpha, now_);
    addRow(RowId::historyLength, now_);
    return;
  }
  const bool isFlicker = found_.flicker >= kVisibleFlicker && !isNoFlicker();
  if (averagesTooFew() && !(isFlicker && smallerWeight() < kOneSampleAlpha)) {
    found_.kind = VerdictKind::Aliasing;
    found_.stage = Stage::BlendWeight;
    for (const RowId id : {RowId::alpha, RowId::historyLength, RowId::rejectReason, RowId::color})
      addRow(id, now_);
    return;
  }
  if (isFlicker) {
    concludeFlicker();
    return;
  }
  switch (found_.part) {
  case ErrorPart::Ghost:
    concludeGhost();
    return;
  case ErrorPart::Aliasing:
    concludeSamples();
    return;
  case ErrorPart::Lag:
  case ErrorPart::Older:
    concludeLag();
    return;
  case ErrorPart::Blur:
    if (hasChanged() && !isPartlyGhost()) {
      concludeLag();
      return;
    }
    if (isPassed() || isOfAnother() || isGhostBelowBlur()) {
      concludeGhost();
      return;
    }
    concludeHistory();
    return;
  case ErrorPart::Rectification:
    if (hasJustAppeared()) {
      concludeSamples();
      return;
    }
    if (isOfAnother()) {
      concludeGhost();
      return;
    }
    concludeHistory();
    return;
  }
}

void Judge::concludeFlicker() {
  found_.kind = isHighlight(evidence_.moments) ? VerdictKind::HighlightFlicker : VerdictKind::Flicker;
  found_.stage = stageOfFlicker();
  for (const RowId id : {RowId::color, RowId::clipAmount, RowId::rejectReason, RowId::alpha})
    addRow(id, now_);
}

// An error that is not of single frames' samples trembles as well, with where on the pixels things fall: what
// moved, changed or came into sight is wrong then, or the filter that takes the same from all samples.
bool Judge::isNoFlicker() const {
  if (found_.error < kVisibleError) return false;
  // What takes back some of all that reading took does so now and then.
  if (found_.part == ErrorPart::Blur && found_.share > kExplainsAll) return true;
  if (found_.flicker > kMostlyFlicker * found_.error) return false;
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
  // What lies beside a surface on its own object is no ghost of another place.
  const auto used = glm::dvec2(glm::vec2(twin::at(evidence_.ghostRecord, RowId::dilatedMotion)));
  const bool isNear = evidence_.ghostMotion && glm::distance(used, *evidence_.ghostMotion) < kBesidePx;
  if (!isNear || !found_.causeObject || found_.causeObject != evidence_.object) return;
  const bool isNeighbors = twin::at(evidence_.ghostRecord, RowId::dilatedOffset) != glm::vec4(0.0f);
  if (hasChanged()) {
    found_.causeObject.reset();
    concludeChange();
    return;
  }
  found_.kind = VerdictKind::Blur;
  found_.stage = isNeighbors ? Stage::DilateMotion : Stage::SampleHistory;
  found_.causeObject.reset();
}

// Over the frames since it came in, reading history a fraction of a pixel off adds up: it shows the wrong
// place although no single frame's motion is far off.
std::optional<Stage> Judge::stageOfDrift() const {
  glm::dvec2 used(0.0), own(0.0);
  for (const SurfaceMoment& moment : evidence_.moments) {
    if (moment.frame < found_.since || !moment.motion || isRestart(moment.record)) break;
    used += glm::dvec2(glm::vec2(twin::at(moment.record, RowId::dilatedMotion))) - *moment.motion;
    own += glm::dvec2(glm::vec2(twin::at(moment.record, RowId::motion))) - *moment.motion;
  }
  if (glm::length(used) <= kDriftPx) return {};
  if (settings_.reproject.method == ReprojectMethod::InPlace) return Stage::Reproject;
  return glm::length(own) > 0.5 * glm::length(used) ? Stage::Inputs : Stage::DilateMotion;
}

// The object whose samples pull the pixel furthest the error's way; where none does, as behind what
// rectification made of them, what history was read of.
void Judge::nameGhost() {
  double most = 0.0;
  for (const auto& [object, pull] : pulls()) {
    if (pull <= most) continue;
    most = pull;
    found_.causeObject = object;
  }
  if (found_.causeObject) {
    findLastOf(*found_.causeObject);
    return;
  }
  for (const ErrorOfFrame& entry : origin_.frames)
    if (found_.part != ErrorPart::Ghost && entry.frame == found_.causeFrame && entry.passedBy >= 0)
      found_.causeObject = entry.passedBy;
  if (found_.causeObject) return;
  for (const ErrorOfFrame& entry : origin_.frames)
    if (entry.frame == evidence_.ghostFrame && entry.ghostObject >= 0) found_.causeObject = entry.ghostObject;
  if (evidence_.ghostFrame >= 0) found_.causeFrame = evidence_.ghostFrame - 1; // what was seen there then
}

/// How far each object's samples that history was read of instead of the surface pull the pixel the error's
/// way: 1 is all of the error.
std::map<int, double> Judge::pulls() const {
  const glm::dvec3 error = origin_.error();
  std::map<int, double> found;
  for (const OutlierSamples& outlier : origin_.outliers)
    found[outlier.object] += glm::dot(outlier.pull, error) / std::max(glm::dot(error, error), 1e-12);
  return found;
}

/// Whether most of the error is other objects' samples, by whichever part they came to count.
bool Judge::isOfAnother() const {
  double sum = 0.0;
  for (const auto& [object, pull] : pulls())
    if (object != evidence_.object) sum += std::max(pull, 0.0);
  return evidence_.object >= 0 && sum > 0.5;
}

/// How much of the error is that truth was another on the surface itself when its samples were taken: each
/// frame's as nearly today's as its four texels there allow, by what its samples count today. Following the
/// error step by step leaves it to blur where an edge that moves lies within reach of the filter.
double Judge::changedShare() const {
  if (evidence_.older) return 0.0;
  const std::vector<ErrorOfFrame>& frames = evidence_.error.frames;
  const glm::dvec3 error = evidence_.error.error();
  double sum = 0.0;
  for (std::size_t at = 0; at < std::min(frames.size(), evidence_.moments.size()); ++at) {
    const SurfaceMoment& moment = evidence_.moments[at];
    const double counts = frames[at].weight - (at + 1 < frames.size() ? frames[at + 1].weight : 0.0);
    if (moment.former) sum += counts * glm::dot(*moment.former - now_.reference, error);
  }
  return sum / std::max(glm::dot(error, error), 1e-12);
}

/// How much of the error a part makes; below 0 it works against the others.
double Judge::shareOf(ErrorPart part) const {
  const glm::dvec3 error = origin_.error();
  return glm::dot(of(origin_.sum, part), error) / std::max(glm::dot(error, error), 1e-12);
}

/// Whether the ghost alone makes most of the error, and rectification takes back from blur.
bool Judge::isGhostBelowBlur() const {
  return shareOf(ErrorPart::Rectification) < 0.0 && shareOf(ErrorPart::Ghost) > 0.5;
}

/// Whether ghosts add a quarter of the error or more, or take it away.
bool Judge::isPartlyGhost() const {
  return std::fabs(shareOf(ErrorPart::Ghost)) > 0.25;
}

/// In how many frames a test threw history away. Where history starts there is none to throw away.
int Judge::rejections() const {
  return static_cast<int>(std::ranges::count_if(evidence_.moments, [](const SurfaceMoment& moment) {
    return rejectReasonOf(moment.record) > RejectReason::NoHistory;
  }));
}

/// Whether single frames alone exceed white, and are to blame: either most of the error is their samples', or
/// truth is brighter than white because of them, and what is shown is what the others make of it.
bool Judge::areHighlightsRare() const {
  const std::vector<SurfaceMoment>& moments = evidence_.moments;
  const int bright = brightFrames(moments).all;
  if (bright == 0 || 2 * bright > static_cast<int>(moments.size())) return false;
  if (largestMagnitude(now_.reference) > 1.0) return true;
  const glm::dvec3 error = origin_.error();
  double made = 0.0;
  for (const ErrorOfFrame& entry : origin_.frames)
    for (const SurfaceMoment& moment : moments)
      if (moment.frame == entry.frame && isBrighterThanWhite(moment))
        made += glm::dot(of(entry.split, ErrorPart::Aliasing), error);
  return made > 0.5 * glm::dot(error, error);
}

// The latest frame that shows the object at least half as far off as any does: all of what a frame is sampled
// of, for the first samples of a history, and what is older than those followed, count many times.
void Judge::findLastOf(int object) {
  const auto offOf = [&](const OutlierSamples& outlier) {
    return outlier.object == object && outlier.weight > 0.0
               ? glm::dot(outlier.pull, origin_.error()) / outlier.weight
               : 0.0;
  };
  double most = 0.0;
  for (const OutlierSamples& outlier : origin_.outliers) most = std::max(most, offOf(outlier));
  for (const OutlierSamples& outlier : origin_.outliers) {
    if (most == 0.0 || offOf(outlier) < 0.5 * most) continue;
    found_.causeFrame = outlier.frame;
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

/// Whether most of the error is samples of the surface's own object that were taken elsewhere on it, because
/// the motion that was used leaves the surface.
bool Judge::isOfOtherPlace() const {
  const std::map<int, double> pulling = pulls();
  const auto own = pulling.find(evidence_.object);
  return own != pulling.end() && own->second > 0.5 && stageOfDrift();
}

void Judge::concludeDrift() {
  found_.kind = VerdictKind::Ghost;
  found_.stage = *stageOfDrift();
  found_.rows.clear();
  for (const RowId id :
       {RowId::historyRaw, RowId::dilatedMotion, RowId::dilatedOffset, RowId::clipAmount, RowId::alpha})
    addRow(id, now_);
}

/// How much rectification changes of today's color in all frames, over what the samples' errors do.
double Judge::rectifiedShare() const {
  double rectified = 0.0, sampled = 0.0;
  for (const ErrorOfFrame& entry : origin_.frames) {
    rectified += glm::length(of(entry.split, ErrorPart::Rectification));
    sampled += glm::length(of(entry.split, ErrorPart::Aliasing));
  }
  return sampled > 0.0 ? rectified / sampled : 0.0;
}

// Rectification that left history as it was in all but a few frames made none of it, unless it took much
// then.
Stage Judge::stageOfFlicker() {
  const BrightFrames bright = brightFrames(evidence_.moments);
  if (found_.kind == VerdictKind::HighlightFlicker && bright.all > 0 && bright.filtered == bright.all) {
    found_.repeated = {bright.all, static_cast<int>(evidence_.moments.size()), 0.0};
    return Stage::FilterCurrent;
  }
  const int frames = static_cast<int>(evidence_.moments.size());
  const RepeatedEvent rejected{rejections(), frames, 0.0};
  RepeatedEvent clipped{0, frames, 0.0};
  for (const SurfaceMoment& moment : evidence_.moments) {
    const double amount = recordValue(moment.record, RowId::clipAmount);
    if (amount > kClippedShare) ++clipped.events;
    clipped.largest = std::max(clipped.largest, amount);
  }
  if (rejected.events > 1) {
    found_.repeated = rejected;
    return Stage::ValidateHistory;
  }
  const bool isClipped =
      8 * clipped.events >= clipped.frames || (clipped.events > 0 && rectifiedShare() > 0.5);
  const bool isHeavy = usualWeight(evidence_.moments) >= kFlickeringAlpha;
  if (!isClipped && !isHeavy && found_.kind == VerdictKind::HighlightFlicker && areHighlightsRare()) {
    found_.repeated = {bright.all, static_cast<int>(evidence_.moments.size()), 0.0};
    return Stage::Blend;
  }
  if (!isClipped || isHeavy) return Stage::BlendWeight;
  found_.repeated = clipped;
  return Stage::RectifyHistory;
}

/// The latest moment in which history was given up; null: none.
const SurfaceMoment* Judge::restart() const {
  const auto at = std::ranges::find_if(evidence_.moments,
                                       [](const SurfaceMoment& moment) { return isRestart(moment.record); });
  return at == evidence_.moments.end() ? nullptr : &*at;
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
  return std::ranges::all_of(evidence_.moments, [&](const SurfaceMoment& moment) {
    return largestMagnitude(shownSample(moment) - shownSample(now_)) < kOneColor;
  });
}

/// Whether the pattern of the jitter is to blame: its few places give the same samples again and again, and
/// their mean is off by more than half as much as what is shown.
bool Judge::isOfFewPlaces() const {
  const std::vector<SurfaceMoment>& moments = evidence_.moments;
  const int period = jitterPeriod(settings_.jitter);
  if (period < 2 || period > kFewJitterPlaces || moments.size() < 2 * kFewJitterPlaces) return false;
  for (std::size_t at = static_cast<std::size_t>(period); at < moments.size(); ++at) {
    const SurfaceMoment& again = moments[at - static_cast<std::size_t>(period)];
    if (largestMagnitude(shownSample(moments[at]) - shownSample(again)) >= kVisibleError) return false;
  }
  return errorOfMean(moments, moments.size(), RowId::color) > 0.5 * found_.error;
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

/// Whether all of four samples or more are off one way, so that no number of them corrects it.
bool Judge::isFiltered() const {
  constexpr double kOneWay = 0.8;
  const auto sampled = std::ranges::count_if(origin_.frames, [](const ErrorOfFrame& entry) {
    return of(entry.split, ErrorPart::Aliasing) != glm::dvec3(0.0);
  });
  const bool isEnough = sampled > 3 && recordValue(now_.record, RowId::historyLength) > 3.5;
  return isEnough && meanBias() > kOneWay && !hasJustAppeared();
}

/// Whether there could be no more samples: the surface came into sight, or history started, a few frames ago,
/// and an even average of all samples since would not be clearly better than what is shown.
bool Judge::hasJustAppeared() const {
  const std::size_t available = availableSamples(evidence_.moments);
  if (available > kYoungFrames) return false;
  // What was there before was kept: more is averaged than frames that showed the surface.
  if (recordValue(now_.record, RowId::historyLength) > static_cast<double>(available) + 0.5) return false;
  const SurfaceMoment& first = evidence_.moments[available - 1];
  const bool isStart = available < evidence_.moments.size() || evidence_.endsHidden ||
                       rejectReasonOf(first.record) == RejectReason::NoHistory;
  if (!isStart || available <= kFewFrames) return isStart;
  const double reached = errorOfMean(evidence_.moments, available, RowId::currentFiltered);
  if (errorOfMean(evidence_.moments, available, RowId::color) < 0.5 * reached) return false; // of the filter
  return reached > 0.5 * found_.error ||
         recordValue(now_.record, RowId::historyLength) > 0.75 * static_cast<double>(available);
}

/// Whether fewer than three frames' samples are averaged, though tests keep history.
bool Judge::averagesTooFew() const {
  if (smallerWeight() < kFewSamplesAlpha) return false;
  return usualWeight(evidence_.moments) >= 1.0 || !hasJustAppeared();
}

/// Of the usual weight of the current frame and today's.
double Judge::smallerWeight() const {
  return std::min(usualWeight(evidence_.moments), recordValue(now_.record, RowId::alpha));
}

void Judge::concludeSamples() {
  const bool isNew = hasJustAppeared();
  const SurfaceMoment* start = isFiltered() ? nullptr : restart();
  // Weighed 1 without a test's word, or where there was no history yet, no test threw good history away.
  if (start && rejectReasonOf(start->record) <= RejectReason::NoHistory) start = nullptr;
  if (isNew && !isFiltered()) start = &evidence_.moments[availableSamples(evidence_.moments) - 1];
  if (start) {
    found_.since = found_.causeFrame = start->frame;
    found_.kind = isNew ? VerdictKind::DisocclusionRestart : VerdictKind::Aliasing;
    found_.stage =
        isNew && areWeighedUnevenly(evidence_.moments) ? Stage::BlendWeight : Stage::ValidateHistory;
    found_.throwsGoodAway = !isNew;
    addRow(RowId::rejectReason, *start, 0.0);
    addRow(RowId::depthMismatch, *start, recordValue(start->record, RowId::depthAllowed));
    addRow(RowId::historyLength, now_);
    addRow(RowId::alpha, now_);
    return;
  }
  if (areHighlightsRare()) {
    concludeFlicker();
    return;
  }
  found_.kind = isFiltered() ? VerdictKind::Blur : VerdictKind::Aliasing;
  found_.stage = isFiltered() ? Stage::FilterCurrent : isOfFewPlaces() ? Stage::Jitter : Stage::BlendWeight;
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
  if (isOfOtherPlace()) {
    concludeDrift();
    return;
  }
  addHistoryRows();
  found_.kind = VerdictKind::Blur;
  found_.throwsGoodAway = found_.part == ErrorPart::Rectification;
  found_.stage = found_.throwsGoodAway ? Stage::RectifyHistory : Stage::SampleHistory;
}

/// Whether something passed by in the frame that brought most: history is a mixture of both there.
bool Judge::isPassed() const {
  return std::ranges::any_of(origin_.frames, [&](const ErrorOfFrame& entry) {
    return entry.frame == found_.causeFrame && entry.passedBy >= 0;
  });
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
  if (found_.part == ErrorPart::Older || wasBlendedOver()) {
    const bool isUnguarded = settings_.rectify.method == RectifyMethod::None;
    found_.isBlended = found_.part != ErrorPart::Older;
    found_.kind = found_.isBlended ? VerdictKind::Ghost : VerdictKind::Lag;
    found_.stage = found_.isBlended && isUnguarded ? Stage::ValidateHistory : Stage::RectifyHistory;
    addHistoryRows();
    return;
  }
  const bool isOwn = hasChanged() && !isPartlyGhost();
  if (!isOwn && (isPassed() || isOfAnother())) {
    concludeGhost();
    return;
  }
  if (!isOwn && stageOfDrift()) {
    concludeDrift();
    return;
  }
  concludeChange();
}

void Judge::addHistoryRows() {
  found_.rows.clear();
  for (const RowId id : {RowId::historyRaw, RowId::historyRectified, RowId::clipAmount, RowId::alpha})
    addRow(id, now_);
}

/// The surface itself looks other than it did.
void Judge::concludeChange() {
  addHistoryRows();
  found_.stage = Stage::RectifyHistory;
  found_.kind = VerdictKind::Lag;
  addRow(RowId::alphaMask, now_);
  const double mask =
      std::max(recordValue(now_.record, RowId::reactive), recordValue(now_.record, RowId::responsive));
  if (mask > 0.0 || evidence_.error.frames.front().isChanging) {
    found_.kind = VerdictKind::MaskSmear;
    found_.stage = mask > 0.0 ? Stage::BlendWeight : Stage::Inputs;
  }
}

void Judge::addRow(RowId id, const SurfaceMoment& moment, std::optional<double> limit) {
  found_.rows.push_back(
      {id, moment.frame, moment.pixel, recordValue(moment.record, id), limit, twin::at(moment.record, id)});
}

void Judge::addGhostRow(RowId id, std::optional<double> limit) {
  for (const ErrorOfFrame& entry : origin_.frames)
    if (entry.frame == evidence_.ghostFrame)
      found_.rows.push_back({id, entry.frame, entry.ghostPixel, recordValue(evidence_.ghostRecord, id), limit,
                             twin::at(evidence_.ghostRecord, id)});
}

} // namespace

glm::dvec3 shownValue(const glm::dvec3& linear) {
  return {shownLight(linear.x), shownLight(linear.y), shownLight(linear.z)};
}

PixelVerdict judge(const VerdictEvidence& evidence, const Settings& settings) {
  return Judge(evidence, settings).verdict();
}

} // namespace taa
