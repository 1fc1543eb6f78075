#include "app/background/SweepWork.h"

#include <utility>

namespace taa::app {

SweepWork::SweepWork(Sweep sweep, QObject* parent) : BackgroundWork(parent), sweep_(std::move(sweep)) {}

void SweepWork::begin(const ShotSweepRequest& request) {
  start([this, request, sweep = sweep_](const Deliver& deliver, const Progress& progress) {
    sweep(
        request,
        [&](std::size_t index, const LaneMetrics& frames) {
          deliver([this, index, frames] { Q_EMIT measured(index, frames); });
        },
        progress);
  });
}

} // namespace taa::app
