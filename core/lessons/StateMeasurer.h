// Numbers that a lesson's conditions speak of, measured on the state that is open.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/doctor/examination/Doctor.h"
#include "core/lessons/Condition.h"
#include "core/lessons/LessonState.h"
#include "core/sweep/MetricsOfFrames.h"
#include "core/verdict/lineage/Lineage.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace taa {

class Inspector;

class StateMeasurer {
 public:
  /// Of the state that is open in `inspector`, on the frames that it is open on.
  StateMeasurer(Inspector& inspector, const LessonState& state, const Progress& progress)
      : inspector_(inspector), state_(state), progress_(progress) {}

  /// Metrics are measured together: `all` are asked for later.
  void plan(const std::vector<const Quantity*>& all);
  /// NaN: not known in this frame. Throws Error, Cancelled.
  double measure(const Quantity& quantity);

 private:
  int frameOf(const Quantity& quantity) const { return quantity.frame.value_or(state_.shot.frame); }
  int laneOf(const Quantity& quantity) const;
  glm::ivec2 pixelOf(const Quantity& quantity) const;
  double valueOf(const Quantity& quantity);
  double valueInFrame(const Quantity& quantity);
  double metricOfLane(const Quantity& quantity);
  glm::vec4 at(const Quantity& quantity, int lane);
  double difference(const Quantity& quantity);
  double share(const Quantity& quantity);
  double levels(const Quantity& quantity);
  /// A row of the whole picture.
  Image image(const Quantity& quantity);
  double verdict(const Quantity& quantity);
  double lineage(const Quantity& quantity);
  double volume(const Quantity& quantity);
  double pushed(const Quantity& quantity);
  double changed(const Quantity& quantity);
  double time(const Quantity& quantity);
  bool doctorFinds(Fault fault);

  Inspector& inspector_;
  const LessonState& state_;
  const Progress& progress_;
  std::map<int, std::set<Metric>> metrics_; // by frame
  std::map<int, std::vector<LaneMetrics>> measured_;
  std::optional<doctor::Diagnosis> diagnosis_;
};

} // namespace taa
