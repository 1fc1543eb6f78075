// Where a view looks, as session files keep it.
#pragma once

#include "app/views/ViewportMath.h"

#include <QJsonObject>

namespace taa::app {

QJsonObject cameraJson(const ViewCamera& camera);
/// What makes no sense fits the whole picture.
ViewCamera cameraFromJson(const QJsonObject& json);

} // namespace taa::app
