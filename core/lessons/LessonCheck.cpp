#include "core/lessons/LessonCheck.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/doctor/Doctor.h"
#include "core/doctor/frames/DoctorSource.h"
#include "core/inspect/Inspector.h"
#include "core/scene/SceneSource.h"
#include "core/sweep/MetricsOfFrames.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace taa {

namespace {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();
constexpr int kDoctorLessonFrames = 16;

/// A row's value in a pixel as one number: its channel, luma (Rec. 709) of three, length of two.
double rowNumber(const Quantity& quantity, const glm::vec4& value) {
  const int channels = intermediate(quantity.row).channels;
  if (quantity.channel >= 0) return static_cast<double>(value[quantity.channel]);
  if (channels == 3) return glm::dot(glm::dvec3(value), glm::dvec3(0.2126, 0.7152, 0.0722));
  if (channels == 2) return glm::length(glm::dvec2(value));
  return static_cast<double>(value.x);
}

/// Measures quantities of one state.
class StateMeasurer {
 public:
  StateMeasurer(Inspector& inspector, const LessonState& state, const Progress& progress)
      : inspector_(inspector), state_(state), progress_(progress) {}

  /// Metrics are measured together: `all` are asked for later.
  void plan(const std::vector<const Quantity*>& all) {
    for (const Quantity* quantity : all)
      if (quantity->kind == QuantityKind::Metric) metrics_[frameOf(*quantity)].insert(quantity->metric);
  }

  double measure(const Quantity& quantity) {
    const double value = quantity.kind == QuantityKind::Number ? quantity.number : valueOf(quantity);
    return value * quantity.factor + quantity.offset;
  }

 private:
  int frameOf(const Quantity& quantity) const { return quantity.frame.value_or(state_.shot.frame); }

  int laneOf(const Quantity& quantity) const {
    if (quantity.lane.empty()) return 0;
    const auto lane = std::ranges::find(state_.lanes, quantity.lane, &LessonLane::name);
    if (lane == state_.lanes.end()) throw Error(say<"the step has no lane \"%1\"">(quantity.lane));
    return static_cast<int>(lane - state_.lanes.begin()) + 1;
  }

  double valueOf(const Quantity& quantity) {
    switch (quantity.kind) {
    case QuantityKind::Metric:
      return metricOfLane(quantity);
    case QuantityKind::Doctor:
      return doctorFinds(quantity.fault) ? 1.0 : 0.0;
    default:
      break;
    }
    inspector_.shot().seek(frameOf(quantity), progress_);
    switch (quantity.kind) {
    case QuantityKind::Value:
      return rowNumber(quantity, at(quantity, laneOf(quantity)));
    case QuantityKind::Difference:
      return difference(quantity);
    case QuantityKind::Share:
      return share(quantity);
    case QuantityKind::Verdict:
      return verdict(quantity);
    default:
      return kNotMeasured;
    }
  }

  double metricOfLane(const Quantity& quantity) {
    const int frame = frameOf(quantity);
    auto found = measured_.find(frame);
    if (found == measured_.end()) {
      const std::set<Metric>& wanted = metrics_[frame];
      found =
          measured_
              .emplace(frame, measureFrames(inspector_,
                                            {frame, frame, {wanted.begin(), wanted.end()}, state_.samples},
                                            progress_))
              .first;
    }
    const LaneMetrics& lane = found->second.at(static_cast<std::size_t>(laneOf(quantity)));
    return lane.front().at(quantity.metric).value_or(kNotMeasured);
  }

  glm::ivec2 pixelOf(const Quantity& quantity) const {
    if (quantity.pixel) return *quantity.pixel;
    if (state_.probes.empty()) throw Error(say<"no pixel is probed: right-click one">());
    return state_.probes.front();
  }

  glm::vec4 at(const Quantity& quantity, int lane) {
    const glm::ivec2 pixel = pixelOf(quantity);
    if (isOfReference(quantity.row))
      inspector_.reference().makeRows({quantity.row}, state_.samples, progress_, lane);
    return twin::at(inspector_.probes().probe(pixel.x, pixel.y, lane), quantity.row);
  }

  /// Of the channel that differs most.
  double difference(const Quantity& quantity) {
    const glm::vec4 one = at(quantity, 0), other = at(quantity, laneOf(quantity));
    double most = 0.0;
    for (int channel = 0; channel < intermediate(quantity.row).channels; ++channel)
      if (quantity.channel < 0 || quantity.channel == channel)
        most =
            std::max(most, std::abs(static_cast<double>(one[channel]) - static_cast<double>(other[channel])));
    return most;
  }

  double share(const Quantity& quantity) {
    const int lane = laneOf(quantity);
    if (isOfReference(quantity.row))
      inspector_.reference().makeRows({quantity.row}, state_.samples, progress_, lane);
    const Image image = inspector_.views().image(quantity.row, lane);
    std::int64_t count = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const double value = rowNumber(quantity, image.texel(x, y));
        if (quantity.isBelow ? value < quantity.number : value > quantity.number) ++count;
      }
    return 100.0 * static_cast<double>(count) / (static_cast<double>(image.width) * image.height);
  }

  double verdict(const Quantity& quantity) {
    const VerdictQuestion question{.frame = frameOf(quantity),
                                   .pixel = pixelOf(quantity),
                                   .lane = laneOf(quantity),
                                   .samples = state_.samples};
    return inspector_.verdicts().of(question, progress_).verdict.kind == quantity.verdict ? 1.0 : 0.0;
  }

  /// All of its findings are made once.
  bool doctorFinds(Fault fault) {
    if (!diagnosis_) {
      const doctor::DoctorSource source =
          doctor::openForDoctor({state_.shot.source, state_.shot.camera, state_.shot.size,
                                 state_.shot.settings.settings, state_.shot.choice},
                                progress_);
      diagnosis_ = doctor::examine(doctor::examinationOf(source, kDoctorLessonFrames), progress_);
    }
    return std::ranges::any_of(diagnosis_->findings, [&](const doctor::Finding& finding) {
      return finding.id == faultInfo(fault).id;
    });
  }

  Inspector& inspector_;
  const LessonState& state_;
  const Progress& progress_;
  std::map<int, std::set<Metric>> metrics_; // by frame
  std::map<int, std::vector<LaneMetrics>> measured_;
  std::optional<doctor::Diagnosis> diagnosis_;
};

/// Source, size and camera; what is open already stays.
void openLessonShot(InspectedShot& shot, const LessonState& state, const Progress& progress) {
  const bool isOpen = shot.source() == state.shot.source && shot.choice() == state.shot.choice;
  if (shot.source().empty()) shot.setSize(state.shot.size.x, state.shot.size.y);
  if (!isOpen) shot.open(state.shot.source, progress, state.shot.choice);
  if (shot.capture()) return;
  if (glm::ivec2(shot.width(), shot.height()) != state.shot.size)
    shot.setSize(state.shot.size.x, state.shot.size.y);
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
        if (step.task) checkTask(step, *step.task);
      } catch (const Error& error) {
        tell(step.line, error.what(), true);
      }
    return std::move(findings_);
  }

 private:
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

std::string measuredText(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.5g", value);
  return text;
}

} // namespace

void openState(Inspector& inspector, const LessonState& state, const Progress& progress) {
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
}

std::string checkedText(const CheckedCondition& checked) {
  return say<"%1, measured %2 and %3">(checked.condition.text, measuredText(checked.left),
                                       measuredText(checked.right));
}

std::vector<CheckedCondition> checkConditions(Inspector& inspector, const LessonState& state,
                                              const std::vector<Condition>& conditions,
                                              const Progress& progress) {
  std::vector<CheckedCondition> checked;
  if (conditions.empty()) return checked;
  openState(inspector, state, progress);
  StateMeasurer measurer(inspector, state, progress);
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
