#include "core/inspect/MappedShot.h"

#include "core/base/Light.h"
#include "core/base/Median.h"
#include "core/gl/ContextLock.h"
#include "core/inspect/Inspector.h"
#include "core/inspect/OpenedShot.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace taa {

namespace {

float lumaChangeAt(const SensitivityMap& map, int x, int y) {
  return static_cast<float>(luminance(glm::dvec3(glm::vec3(map.change.texel(x, y)))));
}

} // namespace

SensitivityMap mapShot(const MapRequest& request, const Progress& progress) {
  gl::ContextLock lock;
  const Progress passing = lock.passing(progress);
  Inspector inspector;
  inspector.shot().setSettings(request.shot.settings.settings);
  openShotOf(inspector, request.shot, passing);
  inspector.shot().seek(request.shot.frame, passing);
  return inspector.probes().sensitivityMap(request.path, passing);
}

float mappedRange(const SensitivityMap& map) {
  std::vector<float> changes;
  for (int y = 0; y < map.change.height; ++y)
    for (int x = 0; x < map.change.width; ++x)
      if (const float change = std::fabs(lumaChangeAt(map, x, y)); change > 0.0f && std::isfinite(change))
        changes.push_back(change);
  return changes.empty() ? 0.0f : percentile(changes, 99);
}

Picture mapPicture(const SensitivityMap& map, float range) {
  Picture picture{map.change.width, map.change.height, {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float share = range > 0.0f ? lumaChangeAt(map, x, y) / range : 0.0f;
      const float place = std::isfinite(share) ? 0.5f + 0.5f * std::clamp(share, -1.0f, 1.0f) : 0.5f;
      for (const float channel : mapColor(ColorMap::Diverging, place))
        picture.rgba.push_back(srgbByte(channel));
      picture.rgba.push_back(255);
    }
  return picture;
}

} // namespace taa
