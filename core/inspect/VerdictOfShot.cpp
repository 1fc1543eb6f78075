#include "core/inspect/VerdictOfShot.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/inspect/EvidenceFrames.h"
#include "core/inspect/MemoryNeed.h"
#include "core/inspect/RemedyTrial.h"
#include "core/scene/SceneOutline.h"
#include "core/settings/Parameters.h"
#include "core/verdict/pixel/Cures.h"
#include "core/verdict/pixel/OlderError.h"
#include "core/verdict/pixel/VerdictText.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <ranges>
#include <string_view>
#include <utility>

namespace taa {

namespace {

constexpr std::size_t kToldRemedies = 3;

/// The frame in which most of today's ghost came in, by what of it points the error's way: where something
/// passes by, history is of that as well, whatever of it truth or reading between pixels explains.
const ErrorOfFrame* mostOfGhost(const PixelError& error) {
  const ErrorOfFrame* most = nullptr;
  double brought = 0.0;
  for (const ErrorOfFrame& entry : error.frames) {
    glm::dvec3 mixed = of(entry.split, ErrorPart::Ghost);
    if (entry.passedBy >= 0) mixed += of(entry.split, ErrorPart::Lag) + of(entry.split, ErrorPart::Blur);
    const double share = glm::dot(mixed, error.error());
    if ((entry.ghostObject < 0 && entry.passedBy < 0) || share <= brought) continue;
    brought = share;
    most = &entry;
  }
  return most;
}

void addGhost(VerdictEvidence& evidence, EvidenceFrames& frames) {
  const ErrorOfFrame* most = mostOfGhost(evidence.older ? *evidence.older : evidence.error);
  if (!most) return;
  evidence.ghostFrame = most->frame;
  evidence.ghostRecord = frames.record(most->frame, most->ghostPixel);
  const glm::vec4 step = frames.steps(most->frame).texel(most->ghostPixel.x, most->ghostPixel.y);
  if (step.x == step.x) evidence.ghostMotion = glm::dvec2(step.x, step.y);
}

/// Share of the error by which the part that is most of it leads the next one.
double leadOfPart(const PixelError& origin) {
  const glm::dvec3 error = origin.error();
  const double square = glm::dot(error, error);
  if (square == 0.0) return 1.0;
  std::array<double, kErrorParts> shares{};
  for (std::size_t part = 0; part < kErrorParts; ++part)
    shares[part] = glm::dot(origin.sum[part], error) / square;
  std::ranges::sort(shares, std::greater<double>());
  return shares[0] - shares[1];
}

bool isSameTruth(const std::vector<SurfaceMoment>& moments) {
  return std::ranges::all_of(
      moments, [&](const SurfaceMoment& moment) { return moment.reference == moments.front().reference; });
}

/// "blade 2", or "blade (object 6)" where several objects bear the name.
std::string nameOf(const Scene& scene, int object) {
  const SceneOutline outline = outlineOf(scene, {});
  const int node = outline.nodeOf(object);
  if (node < 0) return {};
  const std::string& name = scene.nodes[static_cast<std::size_t>(node)].name;
  const auto isOther = [&](int other) {
    return outline.nodes[static_cast<std::size_t>(other)].objectCount > 0 &&
           scene.nodes[static_cast<std::size_t>(other)].name == name && other != node;
  };
  const bool isShared =
      outline.nodes[static_cast<std::size_t>(node)].objectCount > 1 ||
      std::ranges::any_of(std::views::iota(0, static_cast<int>(scene.nodes.size())), isOther);
  return isShared && !name.empty() ? say<"%1 (object %2)">(name, object) : name;
}

/// Asks whether work goes on, and tells nothing of it: who waits is told of larger steps.
Progress withoutSteps(const Progress& progress) {
  if (!progress) return {};
  return [&progress](std::string_view what, int, int) { return progress(what, 0, 0); };
}

/// Tells of whatever is done as measuring.
Progress measuring(const Progress& progress) {
  if (!progress) return {};
  return [&progress](std::string_view, int done, int total) {
    return progress(say<"Measuring what remedies cost">(), done, total);
  };
}

/// Where the trouble began, but frames enough for it to settle, and few enough to try many.
int firstTried(const ShotState& state, int frame, const PixelVerdict& verdict) {
  constexpr int kMinFrames = 8, kMaxFrames = 16;
  const int wanted = std::clamp(frame - verdict.since + 3, kMinFrames, kMaxFrames);
  int first = frame;
  while (first > 0 && frame - first + 1 < wanted && !startsHistory(state, first)) --first;
  return first;
}

} // namespace

bool isInDoubt(const ReferenceDoubt& doubt, const PixelVerdict& verdict, const PixelError& origin) {
  const double range = 2.0 * doubt.error;
  if (range == 0.0) return false;
  if (std::abs(verdict.error - kVisibleError) < range) return true;
  if (doubt.isMoving && std::abs(verdict.flicker - kVisibleFlicker) < range) return true;
  // References of this frame and of one before are in both parts, with opposite signs.
  const double rangeOfLead = std::sqrt(2.0) * range;
  return verdict.kind != VerdictKind::None && leadOfPart(origin) * verdict.error < rangeOfLead;
}

VerdictOfShot::VerdictOfShot(ShotPlayer& player, References& references, const gl::Driver& driver)
    : player_(player), references_(references), driver_(driver) {}

void VerdictOfShot::require(const VerdictQuestion& question) const {
  const glm::ivec2 size = player_.picturePx(), pixel = question.pixel;
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y)
    throw Error(
        say<"pixel (%1, %2) lies outside the picture of %3 × %4 pixels">(pixel.x, pixel.y, size.x, size.y));
  const int count = player_.state().scene->shot.frames;
  if (question.frame < 0 || question.frame >= count)
    throw Error(say<"there is no frame %1: the shot has frames 0 to %2">(question.frame, count - 1));
  requireReference(driver_, referenceBytes(player_.settings(question.lane), size, player_.scene()), size);
}

VerdictAnswer VerdictOfShot::of(const VerdictQuestion& question, const Progress& progress) {
  require(question);
  constexpr int kMoreSamples = 4; // halves the error at least
  for (int samples = question.samples;; samples = std::min(kMoreSamples * samples, kMaxVerdictSamples)) {
    bool isUncertain = false;
    VerdictAnswer answer = concluded(question, samples, isUncertain, progress);
    if (!isUncertain || samples >= kMaxVerdictSamples) return answer;
  }
}

VerdictAnswer VerdictOfShot::concluded(const VerdictQuestion& question, int samples, bool& isUncertain,
                                       const Progress& progress) {
  const Progress goesOn = withoutSteps(progress);
  EvidenceFrames frames(player_, references_, question.lane, {samples, question.samples}, goesOn);
  VerdictEvidence evidence;
  LineageOptions options;
  options.frames = kVerdictFrames;
  evidence.moments = frames.moments(question.frame, question.pixel, kVerdictFrames);
  evidence.error = pixelError(frames, question.frame, question.pixel, options, progress);
  evidence.older = olderError(frames, evidence.error, goesOn);
  evidence.object = frames.object(question.frame, question.pixel);
  const SurfaceMoment& oldest = evidence.moments.back();
  evidence.endsHidden = static_cast<int>(evidence.moments.size()) < kVerdictFrames &&
                        !startsHistory(frames.state(), oldest.frame);
  frames.fill(evidence.moments);
  addGhost(evidence, frames);
  VerdictAnswer answer{judge(evidence, frames.settings()), std::move(evidence.error), {}, {}, samples, {}};
  answer.referenceError = frames.referenceError(question.frame, question.pixel);
  if (answer.referenceError) {
    const ReferenceDoubt doubt{*answer.referenceError, !isSameTruth(evidence.moments)};
    isUncertain = isInDoubt(doubt, answer.verdict, evidence.older ? *evidence.older : answer.error);
  }
  if (answer.verdict.causeObject) answer.object = nameOf(*player_.state().scene, *answer.verdict.causeObject);
  answer.sentence = verdictSentence(answer.verdict, question.frame, answer.object, frames.settings());
  return answer;
}

RemedyAnswer VerdictOfShot::remedies(const VerdictQuestion& question, const VerdictAnswer& answer,
                                     const Progress& progress) {
  RemedySearch search;
  RemedyAnswer remedies = triedRemedies(question, answer, search, progress);
  measurePictures(question, answer, remedies, search, progress);
  return remedies;
}

RemedyCase VerdictOfShot::caseOf(const VerdictAnswer& answer, const Settings& settings) const {
  const bool drawsInputs = player_.state().frames->capture() == nullptr;
  return {answer.verdict.kind, settings, drawsInputs, namedSettings(answer.verdict, settings)};
}

RemedyAnswer VerdictOfShot::triedRemedies(const VerdictQuestion& question, const VerdictAnswer& answer,
                                          RemedySearch& search, const Progress& progress) {
  require(question);
  const Progress goesOn = withoutSteps(progress);
  RemedyAnswer remedies;
  remedies.samples = std::max(question.samples, answer.samples);
  EvidenceFrames frames(player_, references_, question.lane, {remedies.samples, question.samples}, goesOn);
  remedies.first = firstTried(frames.state(), question.frame, answer.verdict);
  RemedyTrial trial(player_, frames, question.frame, remedies.first, goesOn);
  trial.follow(question.pixel);
  if (!search.before) search.before = trial.ofPixel(frames.settings());
  RemedyCase of = caseOf(answer, frames.settings());
  of.before = *search.before;
  while (!search.waiting.empty() || search.rounds < kRemedyRounds) {
    if (search.waiting.empty()) search.waiting = remedyRound(search.rounds++, of, search.tried);
    for (; !search.waiting.empty(); search.waiting.erase(search.waiting.begin())) {
      const auto tried = static_cast<int>(search.tried.size());
      report(progress, say<"Trying remedies">(), tried, tried + static_cast<int>(search.waiting.size()));
      const Remedy& next = search.waiting.front();
      search.tried.push_back({next, trial.ofPixel(next.settings)});
    }
  }
  remedies.pixel = *search.before;
  remedies.tried = static_cast<int>(search.tried.size());
  remedies.best = bestRemedies(search.tried, of, kToldRemedies);
  return remedies;
}

// Measured are those that would be told, until all that are told were measured: what costs the picture makes
// room for the next best.
void VerdictOfShot::measurePictures(const VerdictQuestion& question, const VerdictAnswer& answer,
                                    RemedyAnswer& remedies, RemedySearch& search, const Progress& progress) {
  constexpr std::size_t kMaxPictures = 9; // each takes as long as showing the shot from its start
  const Progress tells = measuring(progress);
  EvidenceFrames frames(player_, references_, question.lane, {remedies.samples, question.samples}, tells);
  RemedyTrial trial(player_, frames, question.frame, remedies.first, tells);
  trial.follow(question.pixel);
  RemedyCase of = caseOf(answer, frames.settings());
  of.before = remedies.pixel;
  of.picture = remedies.picture;
  const auto isMeasured = [](const TriedRemedy& one) { return one.picture.has_value(); };
  while (!of.picture || !std::ranges::all_of(remedies.best, isMeasured)) {
    std::vector<Settings> lanes{of.settings};
    for (const TriedRemedy& best : remedies.best)
      if (!isMeasured(best)) lanes.push_back(best.remedy.settings);
    const std::vector<WholeMeasure> measures = trial.ofWhole(lanes, search.histories);
    search.histories.clear();
    of.before = remedies.pixel = measures.front().pixel;
    of.picture = remedies.picture = measures.front().picture;
    for (TriedRemedy& one : search.tried)
      if (const auto lane = std::ranges::find(lanes, one.remedy.settings); lane != lanes.end()) {
        const WholeMeasure& measure = measures[static_cast<std::size_t>(lane - lanes.begin())];
        one.pixel = measure.pixel;
        one.picture = measure.picture;
      }
    if (std::ranges::count_if(search.tried, isMeasured) >= static_cast<std::ptrdiff_t>(kMaxPictures))
      std::erase_if(search.tried, [&](const TriedRemedy& one) { return !isMeasured(one); });
    remedies.best = bestRemedies(search.tried, of, kToldRemedies);
  }
}

} // namespace taa
