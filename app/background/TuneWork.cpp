#include "app/background/TuneWork.h"

#include <utility>

namespace taa::app {

TuneWork::TuneWork(Tune tune, QObject* parent) : BackgroundWork(parent), tune_(std::move(tune)) {}

void TuneWork::begin(const ShotTuneRequest& request) {
  start([this, request, tune = tune_](const Deliver& deliver, const Progress& progress) {
    tune(
        request, [&](const TuneWay& way) { deliver([this, way] { Q_EMIT told(way); }); }, progress);
  });
}

} // namespace taa::app
