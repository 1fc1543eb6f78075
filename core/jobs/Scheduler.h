// What the render thread does: requests are taken up, jobs are done in the order of their importance, and
// what has changed is delivered.
#pragma once

#include "core/jobs/desk/Desk.h"
#include "core/jobs/desk/Job.h"
#include "core/jobs/desk/Transport.h"
#include "core/jobs/desk/Wanted.h"
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
#include "core/jobs/shot/Goal.h"
#include "core/jobs/shot/Play.h"
#include "core/jobs/shot/Previews.h"
#include "core/jobs/shot/Replay.h"
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
  Scheduler(const Listener& listener, const WaitingRequests& waiting, Desk::ClockNow now);

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

  Desk desk_;
  Transport transport_{desk_};
  Goal goal_;
  Wanted wanted_;
  CameraFlight flight_{desk_, transport_, goal_};
  Previews previews_{desk_, wanted_};
  ShotChanges changes_{desk_, flight_, goal_, previews_};
  Replay replay_{desk_, transport_, goal_, flight_};
  Play play_{desk_, transport_, goal_, flight_};
  Shaders shaders_{desk_};
  Exporting exporting_{desk_};
  StageCosting costing_{desk_};
  CompilingAhead compiling_{desk_, transport_};
  ThumbnailDrawing thumbnails_{desk_, transport_};
  Traces traces_{desk_, transport_, wanted_};
  TracesInIdleTime idleTraces_{traces_};
  FollowingSamples lineage_{desk_, transport_, wanted_};
  ReferenceDrawing reference_{desk_, transport_, wanted_};
  MeasuringOverTime overTime_{desk_, transport_, wanted_};
  PixelJudging judging_{desk_, transport_};
  MetricMeasuring metrics_{desk_, transport_, wanted_, thumbnails_};
  ShownViews views_{desk_, wanted_};
  Comparing comparing_{desk_, transport_, wanted_};
  ShownProbes probes_{desk_, wanted_, traces_, judging_};
  ShownObjects objects_{desk_, transport_, goal_};
  ShownWorst worst_{desk_, wanted_};
  ShownStatus status_{desk_, transport_, goal_, flight_, changes_, wanted_};
};

} // namespace taa
