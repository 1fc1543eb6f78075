#include "core/inspect/verdicts/VerdictOfShot.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/inspect/MemoryNeed.h"
#include "core/inspect/verdicts/EvidenceFrames.h"
#include "core/inspect/verdicts/RemedyTrial.h"
#include "core/scene/SceneOutline.h"
#include "core/verdict/pixel/OlderError.h"
#include "core/verdict/pixel/VerdictText.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace taa {

namespace {

constexpr std::size_t kToldRemedies = 3;

/// The frame in which most of today's ghost came in, by what of it points the error's way.
const ErrorOfFrame* mostOfGhost(const PixelError& error) {
  const ErrorOfFrame* most = nullptr;
  double brought = 0.0;
  for (const ErrorOfFrame& entry : error.frames) {
    const double share = glm::dot(of(entry.split, ErrorPart::Ghost), error.error());
    if (entry.ghostObject < 0 || share <= brought) continue;
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

std::string nameOf(const Scene& scene, int object) {
  const SceneOutline outline = outlineOf(scene, {});
  const int node = outline.nodeOf(object);
  return node < 0 ? std::string() : scene.nodes[static_cast<std::size_t>(node)].name;
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
  const Progress goesOn = withoutSteps(progress);
  EvidenceFrames frames(player_, references_, question.lane, question.samples, goesOn);
  VerdictEvidence evidence;
  LineageOptions options;
  options.frames = kVerdictFrames;
  evidence.moments = frames.moments(question.frame, question.pixel, kVerdictFrames);
  evidence.error = pixelError(frames, question.frame, question.pixel, options, progress);
  evidence.older = olderError(frames, evidence.error, goesOn);
  const SurfaceMoment& oldest = evidence.moments.back();
  evidence.endsHidden = static_cast<int>(evidence.moments.size()) < kVerdictFrames &&
                        !startsHistory(frames.state(), oldest.frame);
  frames.fill(evidence.moments);
  addGhost(evidence, frames);
  VerdictAnswer answer{judge(evidence, frames.settings()), std::move(evidence.error), {}, {}};
  if (answer.verdict.causeObject) answer.object = nameOf(*player_.state().scene, *answer.verdict.causeObject);
  answer.sentence = verdictSentence(answer.verdict, question.frame, answer.object, frames.settings());
  return answer;
}

RemedyAnswer VerdictOfShot::remedies(const VerdictQuestion& question, const PixelVerdict& verdict,
                                     const Progress& progress) {
  RemedySearch search;
  RemedyAnswer answer = triedRemedies(question, verdict, search, progress);
  measurePictures(question, answer, search, progress);
  return answer;
}

RemedyAnswer VerdictOfShot::triedRemedies(const VerdictQuestion& question, const PixelVerdict& verdict,
                                          RemedySearch& search, const Progress& progress) {
  require(question);
  const Progress goesOn = withoutSteps(progress);
  EvidenceFrames frames(player_, references_, question.lane, question.samples, goesOn);
  RemedyAnswer answer;
  answer.first = firstTried(frames.state(), question.frame, verdict);
  RemedyTrial trial(player_, frames, question.frame, answer.first, goesOn);
  trial.follow(question.pixel);
  if (!search.before) search.before = trial.ofPixel(frames.settings());
  const RemedyCase of{verdict.kind, frames.settings(), frames.state().frames->capture() == nullptr,
                      *search.before};
  while (!search.waiting.empty() || search.rounds < kRemedyRounds) {
    if (search.waiting.empty()) search.waiting = remedyRound(search.rounds++, of, search.tried);
    for (; !search.waiting.empty(); search.waiting.erase(search.waiting.begin())) {
      const auto tried = static_cast<int>(search.tried.size());
      report(progress, say<"Trying remedies">(), tried, tried + static_cast<int>(search.waiting.size()));
      const Remedy& next = search.waiting.front();
      search.tried.push_back({next, trial.ofPixel(next.settings)});
    }
  }
  answer.pixel = *search.before;
  answer.tried = static_cast<int>(search.tried.size());
  answer.best = bestRemedies(search.tried, answer.pixel, kToldRemedies);
  return answer;
}

void VerdictOfShot::measurePictures(const VerdictQuestion& question, RemedyAnswer& answer,
                                    RemedySearch& search, const Progress& progress) {
  const Progress tells = measuring(progress);
  EvidenceFrames frames(player_, references_, question.lane, question.samples, tells);
  RemedyTrial trial(player_, frames, question.frame, answer.first, tells);
  trial.follow(question.pixel);
  std::vector<Settings> lanes{frames.settings()};
  for (const TriedRemedy& tried : answer.best) lanes.push_back(tried.remedy.settings);
  const std::vector<WholeMeasure> measures = trial.ofWhole(lanes, search.histories);
  search.histories.clear();
  answer.pixel = measures.front().pixel;
  answer.picture = measures.front().picture;
  for (std::size_t best = 0; best < answer.best.size(); ++best) {
    answer.best[best].pixel = measures[best + 1].pixel;
    answer.best[best].picture = measures[best + 1].picture;
  }
  answer.best = bestRemedies(answer.best, answer.pixel, kToldRemedies);
}

} // namespace taa
