// What the render thread does: requests are taken up, jobs are done in the order of their importance, and
// what has changed is delivered.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/JobContext.h"
#include "core/jobs/context/Subscriptions.h"
#include "core/jobs/context/Transport.h"
#include "core/jobs/idle/Comparing.h"
#include "core/jobs/idle/CompilingAhead.h"
#include "core/jobs/idle/FollowingSamples.h"
#include "core/jobs/idle/MeasuringOverTime.h"
#include "core/jobs/idle/MetricMeasuring.h"
#include "core/jobs/idle/PixelJudging.h"
#include "core/jobs/idle/ReferenceDrawing.h"
#include "core/jobs/idle/StageCosting.h"
#include "core/jobs/idle/ThumbnailDrawing.h"
#include "core/jobs/idle/Traces.h"
#include "core/jobs/shot/CameraFlight.h"
#include "core/jobs/shot/Exporting.h"
#include "core/jobs/shot/Play.h"
#include "core/jobs/shot/Previews.h"
#include "core/jobs/shot/Replay.h"
#include "core/jobs/shot/SeekTarget.h"
#include "core/jobs/shot/Shaders.h"
#include "core/jobs/shot/ShotChanges.h"
#include "core/jobs/shown/ShownObjects.h"
#include "core/jobs/shown/ShownProbes.h"
#include "core/jobs/shown/ShownStatus.h"
#include "core/jobs/shown/ShownViews.h"
#include "core/jobs/shown/ShownWorst.h"
#include "core/requests/RequestQueue.h"

#include <array>
#include <chrono>
#include <optional>
#include <tuple>

namespace taa {

/// Lives on the render thread.
class Scheduler {
 public:
  using Clock = std::chrono::steady_clock;

  /// What is to be done next, as far as nothing is asked for.
  struct Agenda {
    Job* next = nullptr;                      ///< that is due
    bool isAwaited = false;                   ///< one is due that whoever waits until all is done waits for
    std::optional<Clock::time_point> wakesAt; ///< when something will be due; nothing: never
  };

  /// `now` is the clock of whoever flies the camera. Throws Error when there is no GL.
  Scheduler(const Listener& listener, const WaitingRequests& waiting, JobContext::ClockNow now);

  void takeUp(RequestQueue requests);
  Agenda agenda();
  /// Tells what has changed since it was last called.
  void deliver();

 private:
  void takeTurn(RequestQueue& requests, Turn turn);

  // Everything a request may concern; a request is heard by each that has a member take() for its type.
  auto parts() {
    return std::tie(previews_, changes_, play_, flight_, replay_, shaders_, views_, probes_, objects_, worst_,
                    exporting_, comparing_, costing_, traces_, lineage_, compiling_, thumbnails_, reference_,
                    overTime_, judging_, metrics_);
  }
  // The first one that is due comes first.
  auto jobs() {
    return std::to_array<Job*>({&exporting_, &replay_, &comparing_, &costing_, &play_, &traces_, &lineage_,
                                &compiling_, &thumbnails_, &reference_, &overTime_, &judging_, &metrics_,
                                &idleTraces_});
  }

  JobContext jobContext_;
  Transport transport_{jobContext_};
  SeekTarget seekTarget_;
  Subscriptions subscriptions_;
  CameraFlight flight_{jobContext_, transport_, seekTarget_};
  Previews previews_{jobContext_, subscriptions_};
  ShotChanges changes_{jobContext_, flight_, seekTarget_, previews_};
  Replay replay_{jobContext_, transport_, seekTarget_, flight_};
  Play play_{jobContext_, transport_, seekTarget_, flight_};
  Shaders shaders_{jobContext_};
  Exporting exporting_{jobContext_};
  StageCosting costing_{jobContext_};
  CompilingAhead compiling_{jobContext_, transport_};
  ThumbnailDrawing thumbnails_{jobContext_, transport_};
  Traces traces_{jobContext_, transport_, subscriptions_};
  TracesInIdleTime idleTraces_{traces_};
  FollowingSamples lineage_{jobContext_, transport_, subscriptions_};
  ReferenceDrawing reference_{jobContext_, transport_, subscriptions_};
  MeasuringOverTime overTime_{jobContext_, transport_, subscriptions_};
  PixelJudging judging_{jobContext_, transport_};
  MetricMeasuring metrics_{jobContext_, transport_, subscriptions_, thumbnails_};
  ShownViews views_{jobContext_, subscriptions_};
  Comparing comparing_{jobContext_, transport_, subscriptions_};
  ShownProbes probes_{jobContext_, subscriptions_, traces_, judging_};
  ShownObjects objects_{jobContext_, transport_, seekTarget_};
  ShownWorst worst_{jobContext_, subscriptions_};
  ShownStatus status_{jobContext_, transport_, seekTarget_, flight_, changes_, subscriptions_};
};

} // namespace taa
