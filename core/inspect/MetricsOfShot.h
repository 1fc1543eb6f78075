// Metrics of the frame on show, and of others beside it.
#pragma once

#include "core/base/Progress.h"
#include "core/measure/Metrics.h"

#include <vector>

namespace taa {

class OverTimeOfShot;
struct MetricCursor;
class ReferenceOfShot;
class References;
class ShotPlayer;
class Views;

class MetricsOfShot {
 public:
  /// Of rows that views show, against the reference, and over time. `references`: those of all frames.
  MetricsOfShot(ShotPlayer& player, Views& views, ReferenceOfShot& reference, OverTimeOfShot& overTime,
                const References& references);

  /// Metrics of the frame on show; those against a reference and over time stay empty where there is none.
  FrameMetrics measure(const std::vector<Metric>& wanted, int lane = 0);
  /// The same of any frame, exactly, of the first lane, against a reference of so many samples; what is on
  /// show stays. Frame after frame costs one frame each, and its reference. Cancelled: goes on from there
  /// when it is asked again.
  FrameMetrics measureFrame(int frame, const std::vector<Metric>& wanted, int samples, MetricCursor& cursor,
                            const Progress& progress = {});

 private:
  ShotPlayer& player_;
  Views& views_;
  ReferenceOfShot& reference_;
  OverTimeOfShot& overTime_;
  const References& references_;
};

} // namespace taa
