#include "core/sweep/PointMeasurer.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/source/Capture.h"
#include "core/inspect/Inspector.h"
#include "core/render/CaptureFacts.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/sweep/MetricsOfFrames.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace taa {

using nlohmann::ordered_json;

namespace {

/// Throws Error where the sweep asks for something that would have no effect on a capture.
void requireVariable(const SweepSpec& spec, const CaptureFacts& captured) {
  if (spec.size && *spec.size != captured.outputPx) throw Error(whyOneSize(captured));
  for (const SweepRange& range : spec.ranges)
    if (isFixedBy(captured, *range.row))
      throw Error(say<"cannot go over %1: %2">(range.row->path, whyFixed(*range.row)));
}

} // namespace

PointMeasurer::PointMeasurer(const SweepSpec& spec, const SceneBudget& budget)
    : spec_(spec), budget_(budget) {}
PointMeasurer::~PointMeasurer() = default;

void PointMeasurer::open(const SweepPoint& point, const Progress& progress) {
  const std::pair shot(point.source, point.camera);
  if (shot_ == shot) return;
  if (!shot_ || shot_->first != point.source) {
    shot_.reset();
    inspector_.reset(); // a thread has one at a time
    inspector_ = std::make_unique<Inspector>();
    inspector_->shot().setSceneBudget(budget_);
    inspector_->overTime().setFrames(spec_.flickerFrames);
    const std::string source = spec_.sources[point.source].path.string();
    const glm::ivec2 size = spec_.size.value_or(kSweepSize);
    if (isBuiltinScene(source) || !capture::isCapture(source)) inspector_->shot().setSize(size.x, size.y);
    inspector_->shot().open(source, progress);
  }
  shot_.reset(); // until it is as wanted
  const std::string& camera = spec_.cameras[point.camera];
  inspector_->shot().setCamera(camera.empty() ? inspector_->shot().scene().shot.camera : camera);
  shot_ = shot;
}

ordered_json PointMeasurer::measure(const SweepPoint& point, const Progress& progress) {
  open(point, progress);
  InspectedShot& shot = inspector_->shot();
  if (const auto captured = shot.capture()) requireVariable(spec_, *captured);
  if (spec_.last >= shot.frameCount())
    throw Error(say<"there is no frame %1: the shot has frames 0 to %2">(spec_.last, shot.frameCount() - 1));
  requireMeasurable(*inspector_, spec_.referenceSamples);
  shot.setSettings(settingsOfPoint(spec_, point));
  const MetricsRequest request{spec_.first, spec_.last, spec_.metrics, spec_.referenceSamples};
  keepReferences(*inspector_, request);
  const LaneMetrics lane = measureFrames(*inspector_, request, progress).front();
  return {{"driver", shot.driver().renderer + ", " + shot.driver().version},
          {"frames", framesJson(lane, spec_.metrics)},
          {"mean", meansJson(lane, spec_.metrics)}};
}

} // namespace taa
