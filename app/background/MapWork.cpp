#include "app/background/MapWork.h"

#include <utility>

namespace taa::app {

MapWork::MapWork(Map map, QObject* parent) : BackgroundWork(parent), map_(std::move(map)) {}

void MapWork::begin(const MapRequest& request) {
  start([this, request, map = map_](const Deliver& deliver, const Progress& progress) {
    const SensitivityMap result = map(request, progress);
    deliver([this, result] { Q_EMIT mapped(result); });
  });
}

} // namespace taa::app
