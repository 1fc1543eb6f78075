#include "app/views/ViewCameraJson.h"

#include <QJsonArray>

#include <cmath>

namespace taa::app {

QJsonObject cameraJson(const ViewCamera& camera) {
  return {{QStringLiteral("fit"), camera.fit},
          {QStringLiteral("zoom"), camera.zoom},
          {QStringLiteral("center"), QJsonArray{camera.center.x, camera.center.y}}};
}

ViewCamera cameraFromJson(const QJsonObject& json) {
  ViewCamera camera;
  camera.fit = json.value(QLatin1String("fit")).toBool(true);
  camera.zoom = json.value(QLatin1String("zoom")).toDouble(1.0);
  const QJsonArray center = json.value(QLatin1String("center")).toArray();
  camera.center = {center.at(0).toDouble(), center.at(1).toDouble()};
  const bool isUsable = std::isfinite(camera.zoom) && camera.zoom > 0.0 && std::isfinite(camera.center.x) &&
                        std::isfinite(camera.center.y);
  return isUsable ? camera : ViewCamera{};
}

} // namespace taa::app
