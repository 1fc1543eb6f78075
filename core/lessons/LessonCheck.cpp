#include "core/lessons/LessonCheck.h"

#include "core/base/Error.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/inspect/Inspector.h"
#include "core/lessons/RecordedFrames.h"
#include "core/lessons/StateMeasurer.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Lanes.h"
#include "core/settings/Presets.h"
#include "core/sweep/MetricsOfFrames.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace taa {

namespace {

/// Source, size and camera; what is open already stays.
void openLessonShot(InspectedShot& shot, const LessonState& state, const Progress& progress) {
  const bool isOpen = shot.source() == state.shot.source && shot.choice() == state.shot.choice;
  if (shot.source().empty()) shot.setSize(state.shot.size.x, state.shot.size.y);
  if (!isOpen) shot.open(state.shot.source, progress, state.shot.choice);
  if (shot.capture()) return;
  if (glm::ivec2(shot.width(), shot.height()) != state.shot.size)
    shot.setSize(state.shot.size.x, state.shot.size.y);
  if (state.shot.track) {
    shot.setCameraTrack(*state.shot.track);
    return;
  }
  const std::string& own = shot.scene().shot.camera;
  const std::string& camera = state.shot.camera.empty() ? own : state.shot.camera;
  if (shot.camera() != camera) shot.setCamera(camera);
}

/// Whether it can be evaluated at the start: a pixel that the reader shall find is not there yet.
bool canBeAsked(const LessonState& state, const Condition& condition) {
  return !state.probes.empty() ||
         std::ranges::none_of(quantitiesOf({condition}), [](const Quantity* quantity) {
           return isOfPixel(quantity->kind) && !quantity->pixel;
         });
}

/// Checks one lesson, step by step.
class LessonChecker {
 public:
  LessonChecker(Inspector& inspector, const Lesson& lesson, const Progress& progress)
      : inspector_(inspector), lesson_(lesson), progress_(progress) {}

  std::vector<LessonFinding> check() {
    for (const LessonStep& step : lesson_.steps) try {
        openState(inspector_, step.state, progress_);
        for (const CheckedCondition& claim : checkConditions(inspector_, step.state, step.claims, progress_))
          tell(claim.condition.line,
               claim.holds ? say<"the claim holds: %1">(checkedText(claim))
                           : say<"the claim does not hold: %1">(checkedText(claim)),
               !claim.holds);
        checkLadder(step);
        if (step.task) checkTask(step, *step.task);
      } catch (const Error& error) {
        tell(step.line, error.what(), true);
      }
    return std::move(findings_);
  }

 private:
  /// As many at once as there are lanes.
  void checkLadder(const LessonStep& step) {
    for (std::size_t first = 0; first < step.ladder.size(); first += kMaxLanes) {
      const std::size_t count = std::min<std::size_t>(step.ladder.size() - first, kMaxLanes);
      checkRungs(step.state, std::span(step.ladder).subspan(first, count));
    }
  }

  void checkRungs(const LessonState& step, std::span<const Rung> rungs) {
    LessonState state = step;
    state.lanes.clear();
    state.shot.settings.settings = preset(rungs.front().preset).settings;
    for (const Rung& rung : rungs.subspan(1)) state.lanes.push_back({"", preset(rung.preset).settings});
    openState(inspector_, state, progress_);
    const int frame = state.shot.frame;
    const auto measured =
        measureFrames(inspector_, {frame, frame, {Metric::Psnr, Metric::Flicker}, state.samples}, progress_);
    for (std::size_t lane = 0; lane < rungs.size(); ++lane) tellRung(rungs[lane], measured.at(lane).front());
  }

  void tellRung(const Rung& rung, const FrameMetrics& measured) {
    const double psnr = measured.at(Metric::Psnr).value_or(std::numeric_limits<double>::quiet_NaN());
    const double flicker = measured.at(Metric::Flicker).value_or(std::numeric_limits<double>::quiet_NaN());
    // Not a number is none of both.
    const bool holds = std::abs(psnr - rung.psnr) <= kRungPsnrTolerance &&
                       std::abs(flicker - rung.flicker) <= kRungFlickerTolerance * rung.flicker;
    const std::string line =
        "rung: " + rung.preset + " psnr=" + fixedText(psnr, 2) + " flicker=" + fixedText(flicker, 5);
    tell(rung.line,
         holds ? say<"the rung holds; measured: %1">(line)
               : say<"the rung does not hold; measured: %1">(line),
         !holds);
  }

  void checkTask(const LessonStep& step, const Task& task) {
    const bool isAskable = std::ranges::all_of(
        task.conditions, [&](const Condition& condition) { return canBeAsked(step.state, condition); });
    if (isAskable && allHold(checkConditions(inspector_, step.state, task.conditions, progress_)))
      tell(task.conditions.front().line, say<"the task is solved at the start">(), true);
    for (const CheckedCondition& checked :
         checkConditions(inspector_, task.solution, task.conditions, progress_))
      tell(checked.condition.line,
           checked.holds ? say<"the solution solves the task: %1">(checkedText(checked))
                         : say<"the solution does not solve the task: %1">(checkedText(checked)),
           !checked.holds);
  }

  void tell(int line, const std::string& sentence, bool isMistake) {
    findings_.push_back({lesson_.place + ":" + std::to_string(line) + ": " + sentence, isMistake});
  }

  Inspector& inspector_;
  const Lesson& lesson_;
  const Progress& progress_;
  std::vector<LessonFinding> findings_;
};

} // namespace

LessonState openState(Inspector& inspector, const LessonState& asked, const Progress& progress) {
  const LessonState state = onItsFrames(inspector, asked, progress);
  InspectedShot& shot = inspector.shot();
  std::vector<Settings> settings{state.shot.settings.settings};
  for (const LessonLane& lane : state.lanes) settings.push_back(lane.settings);
  openLessonShot(shot, state, progress);
  shot.setLanes(settings);
  if (!shot.capture()) shot.setMotionModes(state.shot.motionModes);
  shot.setObjectFilter(state.shot.filter);
  shot.setObjectClasses(state.shot.objectClasses);
  shot.setRestarts(state.shot.restarts);
  if (state.shot.frame >= shot.frameCount())
    throw Error(say<"there is no frame %1: %2 has frames 0 to %3">(state.shot.frame, state.shot.source,
                                                                   shot.frameCount() - 1));
  shot.seek(state.shot.frame, progress);
  return state;
}

std::string checkedText(const CheckedCondition& checked) {
  return say<"%1, measured %2 and %3">(checked.condition.text, significantText(checked.left, 5),
                                       significantText(checked.right, 5));
}

std::vector<CheckedCondition> checkConditions(Inspector& inspector, const LessonState& state,
                                              const std::vector<Condition>& conditions,
                                              const Progress& progress) {
  std::vector<CheckedCondition> checked;
  if (conditions.empty()) return checked;
  const LessonState opened = openState(inspector, state, progress);
  StateMeasurer measurer(inspector, opened, progress);
  measurer.plan(quantitiesOf(conditions));
  for (const Condition& condition : conditions) {
    CheckedCondition one{condition, measurer.measure(condition.left), measurer.measure(condition.right)};
    one.holds = holds(condition, one.left, one.right);
    checked.push_back(std::move(one));
  }
  return checked;
}

bool allHold(const std::vector<CheckedCondition>& checked) {
  return std::ranges::all_of(checked, &CheckedCondition::holds);
}

std::vector<LessonFinding> checkLesson(Inspector& inspector, const Lesson& lesson, const Progress& progress) {
  return LessonChecker(inspector, lesson, progress).check();
}

std::vector<std::string> mistakesOf(const std::vector<LessonFinding>& findings) {
  std::vector<std::string> mistakes;
  for (const LessonFinding& finding : findings)
    if (finding.isMistake) mistakes.push_back(finding.sentence);
  return mistakes;
}

} // namespace taa
