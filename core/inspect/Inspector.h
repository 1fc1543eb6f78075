// The façade: open a source, choose settings, go to a frame, look. Everything the app and taa-batch do goes
// through its parts.
#pragma once

#include "core/gl/Context.h"
#include "core/inspect/InspectedShot.h"
#include "core/inspect/LineageOfShot.h"
#include "core/inspect/MetricsOfShot.h"
#include "core/inspect/OverTimeOfShot.h"
#include "core/inspect/Probes.h"
#include "core/inspect/ReferenceOfShot.h"
#include "core/inspect/ShotProfiler.h"
#include "core/inspect/UsedShaders.h"
#include "core/inspect/VerdictOfShot.h"
#include "core/inspect/Views.h"
#include "core/inspect/WorstOfShot.h"
#include "core/measure/References.h"
#include "core/picture/Visualizer.h"
#include "core/replay/ShotPlayer.h"

namespace taa {

/// A shot that can be looked into. Lives on the thread that made it, one at a time there, with its own GL
/// context.
class Inspector {
 public:
  Inspector();
  Inspector(const Inspector&) = delete;
  Inspector& operator=(const Inspector&) = delete;

  /// What is looked at. The only part that changes it; the others look.
  InspectedShot& shot() { return shot_; }
  const InspectedShot& shot() const { return shot_; }
  Views& views() { return views_; }
  const Views& views() const { return views_; }
  Probes& probes() { return probes_; }
  LineageOfShot& lineage() { return lineage_; }
  VerdictOfShot& verdicts() { return verdicts_; }
  WorstOfShot& worst() { return worst_; }
  ReferenceOfShot& reference() { return reference_; }
  const ReferenceOfShot& reference() const { return reference_; }
  OverTimeOfShot& overTime() { return overTime_; }
  const OverTimeOfShot& overTime() const { return overTime_; }
  MetricsOfShot& metrics() { return metrics_; }
  ShotProfiler& profiler() { return profiler_; }

 private:
  UsedShaders shaders_; // first: everything else is compiled from them
  gl::Context context_; // before all that has GL objects
  ShotPlayer player_;
  Visualizer visualizer_;
  References references_; // of all frames
  ShotProfiler profiler_;
  OverTimeOfShot overTime_;
  ReferenceOfShot reference_;
  Views views_;
  Probes probes_;
  LineageOfShot lineage_;
  VerdictOfShot verdicts_;
  WorstOfShot worst_;
  MetricsOfShot metrics_;
  InspectedShot shot_;
};

} // namespace taa
