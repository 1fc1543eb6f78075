// Follows a number of the settings over a picture in the background.
#pragma once

#include "app/background/BackgroundWork.h"
#include "core/inspect/MappedShot.h"

#include <functional>

namespace taa::app {

class MapWork : public BackgroundWork {
  Q_OBJECT
 public:
  /// As mapShot(); tests put another one in its place.
  using Map = std::function<SensitivityMap(const MapRequest&, const Progress&)>;
  explicit MapWork(Map map = mapShot, QObject* parent = nullptr);

  void begin(const MapRequest& request);

 Q_SIGNALS:
  void mapped(const SensitivityMap& map);

 private:
  Map map_;
};

} // namespace taa::app
