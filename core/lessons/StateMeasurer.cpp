#include "core/lessons/StateMeasurer.h"

#include "core/base/Error.h"
#include "core/base/Light.h"
#include "core/base/Say.h"
#include "core/doctor/source/DoctorSource.h"
#include "core/inspect/Inspector.h"
#include "core/taa/TextureFetches.h"
#include "core/taa/twin/Color.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace taa {

namespace {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();
constexpr int kDoctorLessonFrames = 16;

/// A row's value in a pixel as one number: its channel, luma (Rec. 709) of three, length of two.
double rowNumber(const Quantity& quantity, const glm::vec4& value) {
  const int channels = intermediate(quantity.row).channels;
  if (quantity.channel >= 0) return static_cast<double>(value[quantity.channel]);
  if (channels == 3) return luminance(glm::dvec3(value));
  if (channels == 2) return glm::length(glm::dvec2(value));
  return static_cast<double>(value.x);
}

/// Pixels that get none, or several, of the pixels that are put where their motion says they were.
std::int64_t countPushed(const Image& motion, bool isSeveral) {
  std::vector<int> landed(static_cast<std::size_t>(motion.width) * static_cast<std::size_t>(motion.height));
  for (int y = 0; y < motion.height; ++y)
    for (int x = 0; x < motion.width; ++x) {
      const glm::vec4 texel = motion.texel(x, y);
      const glm::ivec2 place(glm::floor(glm::vec2(x, y) + 0.5f - glm::clamp(glm::vec2(texel), -1e6f, 1e6f)));
      if (place.x >= 0 && place.y >= 0 && place.x < motion.width && place.y < motion.height)
        ++landed[static_cast<std::size_t>(place.y) * static_cast<std::size_t>(motion.width) +
                 static_cast<std::size_t>(place.x)];
    }
  return std::ranges::count_if(landed, [&](int count) { return isSeveral ? count > 1 : count == 0; });
}

} // namespace

void StateMeasurer::plan(const std::vector<const Quantity*>& all) {
  for (const Quantity* quantity : all)
    if (quantity->kind == QuantityKind::Metric) metrics_[frameOf(*quantity)].insert(quantity->metric);
}

double StateMeasurer::measure(const Quantity& quantity) {
  const double value = quantity.kind == QuantityKind::Number ? quantity.number : valueOf(quantity);
  return value * quantity.factor + quantity.offset;
}

int StateMeasurer::laneOf(const Quantity& quantity) const {
  if (quantity.lane.empty()) return 0;
  const auto lane = std::ranges::find(state_.lanes, quantity.lane, &LessonLane::name);
  if (lane == state_.lanes.end()) throw Error(say<"the step has no lane \"%1\"">(quantity.lane));
  return static_cast<int>(lane - state_.lanes.begin()) + 1;
}

double StateMeasurer::valueOf(const Quantity& quantity) {
  if (quantity.kind == QuantityKind::Metric) return metricOfLane(quantity);
  if (quantity.kind == QuantityKind::Doctor) return doctorFinds(quantity.fault) ? 1.0 : 0.0;
  if (quantity.kind == QuantityKind::Lineage) return lineage(quantity);
  if (quantity.kind == QuantityKind::Fetches)
    return textureFetches(inspector_.shot().usedSettings(laneOf(quantity))).sum();
  inspector_.shot().seek(frameOf(quantity), progress_);
  return valueInFrame(quantity);
}

double StateMeasurer::valueInFrame(const Quantity& quantity) {
  switch (quantity.kind) {
  case QuantityKind::Value:
    return rowNumber(quantity, at(quantity, laneOf(quantity)));
  case QuantityKind::Difference:
    return difference(quantity);
  case QuantityKind::Share:
    return share(quantity);
  case QuantityKind::Verdict:
    return verdict(quantity);
  case QuantityKind::Volume:
    return volume(quantity);
  case QuantityKind::Levels:
    return levels(quantity);
  case QuantityKind::Pushed:
    return pushed(quantity);
  case QuantityKind::Changed:
    return changed(quantity);
  case QuantityKind::Time:
    return time(quantity);
  default:
    return kNotMeasured;
  }
}

double StateMeasurer::metricOfLane(const Quantity& quantity) {
  const int frame = frameOf(quantity);
  auto found = measured_.find(frame);
  if (found == measured_.end()) {
    const std::set<Metric>& wanted = metrics_[frame];
    found = measured_
                .emplace(frame, measureFrames(inspector_,
                                              {frame, frame, {wanted.begin(), wanted.end()}, state_.samples},
                                              progress_))
                .first;
  }
  const LaneMetrics& lane = found->second.at(static_cast<std::size_t>(laneOf(quantity)));
  return lane.front().at(quantity.metric).value_or(kNotMeasured);
}

glm::ivec2 StateMeasurer::pixelOf(const Quantity& quantity) const {
  if (quantity.pixel) return *quantity.pixel;
  if (state_.probes.empty()) throw Error(say<"no pixel is probed: right-click one">());
  return state_.probes.front();
}

glm::vec4 StateMeasurer::at(const Quantity& quantity, int lane) {
  const glm::ivec2 pixel = pixelOf(quantity);
  if (isOfReference(quantity.row))
    inspector_.reference().makeRows({quantity.row}, state_.samples, progress_, lane);
  return twin::at(inspector_.probes().probe(pixel.x, pixel.y, lane), quantity.row);
}

/// Of the channel that differs most.
double StateMeasurer::difference(const Quantity& quantity) {
  const glm::vec4 one = at(quantity, 0), other = at(quantity, laneOf(quantity));
  double most = 0.0;
  for (int channel = 0; channel < intermediate(quantity.row).channels; ++channel)
    if (quantity.channel < 0 || quantity.channel == channel)
      most =
          std::max(most, std::abs(static_cast<double>(one[channel]) - static_cast<double>(other[channel])));
  return most;
}

Image StateMeasurer::image(const Quantity& quantity) {
  const int lane = laneOf(quantity);
  if (isOfReference(quantity.row))
    inspector_.reference().makeRows({quantity.row}, state_.samples, progress_, lane);
  return inspector_.views().image(quantity.row, lane);
}

double StateMeasurer::share(const Quantity& quantity) {
  const Image shown = image(quantity);
  std::int64_t count = 0;
  for (int y = 0; y < shown.height; ++y)
    for (int x = 0; x < shown.width; ++x) {
      const double value = rowNumber(quantity, shown.texel(x, y));
      if (quantity.isBelow ? value < quantity.number : value > quantity.number) ++count;
    }
  return 100.0 * static_cast<double>(count) / (static_cast<double>(shown.width) * shown.height);
}

/// What is no number has no level.
double StateMeasurer::levels(const Quantity& quantity) {
  constexpr double kSteps = 255.0; // of 8 bits, between 0 and 1
  const Image shown = image(quantity);
  std::set<double> found;
  for (int y = 0; y < shown.height; ++y)
    for (int x = 0; x < shown.width; ++x)
      if (const double value = rowNumber(quantity, shown.texel(x, y)); std::isfinite(value))
        found.insert(std::round(value * kSteps));
  return static_cast<double>(found.size());
}

double StateMeasurer::verdict(const Quantity& quantity) {
  const VerdictQuestion question{.frame = frameOf(quantity),
                                 .pixel = pixelOf(quantity),
                                 .lane = laneOf(quantity),
                                 .samples = state_.samples};
  return inspector_.verdicts().of(question, progress_).verdict.kind == quantity.verdict ? 1.0 : 0.0;
}

/// All of its findings are made once.
bool StateMeasurer::doctorFinds(Fault fault) {
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

double StateMeasurer::lineage(const Quantity& quantity) {
  const Lineage made =
      inspector_.lineage().of(frameOf(quantity), pixelOf(quantity), laneOf(quantity), {}, progress_);
  switch (quantity.figure) {
  case LineageFigure::Samples:
    return made.effectiveSamples;
  case LineageFigure::Frames:
    return made.effectiveFrames;
  case LineageFigure::Radius:
    return made.radiusPx;
  case LineageFigure::Spread:
    return made.frames.empty() ? kNotMeasured : made.frames.back().spreadPx;
  case LineageFigure::Older:
    return made.older;
  }
  return kNotMeasured;
}

/// The axes of the box's space, in RGB, span what a unit of it is worth there.
double StateMeasurer::volume(const Quantity& quantity) {
  const int lane = laneOf(quantity);
  const glm::ivec2 pixel = pixelOf(quantity);
  const twin::PixelRecord record = inspector_.probes().probe(pixel.x, pixel.y, lane);
  const glm::vec4 low = twin::at(record, IntermediateId::boxMin);
  const glm::vec4 high = twin::at(record, IntermediateId::boxMax);
  SpaceSettings axes = inspector_.shot().usedSettings(lane).space;
  axes.tone = ToneSpace::Linear;
  const glm::vec3 origin = twin::toBox(glm::vec3(0.0f), axes);
  const glm::mat3 toBox(twin::toBox({1.0f, 0.0f, 0.0f}, axes) - origin,
                        twin::toBox({0.0f, 1.0f, 0.0f}, axes) - origin,
                        twin::toBox({0.0f, 0.0f, 1.0f}, axes) - origin);
  const glm::dvec3 extent(high - low);
  return extent.x * extent.y * extent.z / std::abs(static_cast<double>(glm::determinant(toBox)));
}

double StateMeasurer::changed(const Quantity& quantity) {
  const Image own = inspector_.views().image(IntermediateId::resolved, 0);
  const Image other = inspector_.views().image(IntermediateId::resolved, laneOf(quantity));
  std::int64_t count = 0;
  for (int y = 0; y < own.height; ++y)
    for (int x = 0; x < own.width; ++x)
      if (own.texel(x, y) != other.texel(x, y)) ++count;
  return 100.0 * static_cast<double>(count) / (static_cast<double>(own.width) * own.height);
}

double StateMeasurer::time(const Quantity& quantity) {
  const int lane = laneOf(quantity);
  return lane == 0 ? 1.0 : inspector_.profiler().measureRatio(lane, 0, progress_).median;
}

double StateMeasurer::pushed(const Quantity& quantity) {
  const Image motion = inspector_.views().image(IntermediateId::motion, laneOf(quantity));
  return 100.0 * static_cast<double>(countPushed(motion, quantity.isSeveral)) /
         (static_cast<double>(motion.width) * motion.height);
}

} // namespace taa
