#include "core/jobs/shown/ShownObjects.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace taa {

namespace {

/// Where pixels of `ids` that hold one of `objects` are.
ObjectArea areaOf(const Image& ids, const std::vector<int>& objects) {
  const std::unordered_set<int> subscriptions(objects.begin(), objects.end());
  ObjectArea area;
  area.objects = objects;
  glm::dvec2 sum(0.0);
  glm::ivec2 low(ids.width, ids.height), high(-1);
  std::vector<glm::ivec2> found;
  for (int y = 0; y < ids.height; ++y)
    for (int x = 0; x < ids.width; ++x) {
      if (!subscriptions.contains(static_cast<int>(*ids.at(x, y)))) continue;
      found.emplace_back(x, y);
      sum += glm::dvec2(x, y);
      low = glm::min(low, glm::ivec2(x, y));
      high = glm::max(high, glm::ivec2(x, y));
    }
  if (found.empty()) return area;
  area.pixels = static_cast<int>(found.size());
  area.box = {low.x, low.y, high.x - low.x + 1, high.y - low.y + 1};
  const glm::dvec2 middle = sum / static_cast<double>(found.size());
  area.pixel = *std::ranges::min_element(found, {}, [&](const glm::ivec2& pixel) {
    const glm::dvec2 away = glm::dvec2(pixel) - middle;
    return away.x * away.x + away.y * away.y;
  });
  return area;
}

} // namespace

void ShownObjects::take(const request::Locate& subscriptions) {
  objects_ = subscriptions.objects;
  delivered_ = 0;
}

// Reading a whole picture back takes longer than a frame that plays may.
void ShownObjects::deliver() {
  if (objects_.empty() || delivered_ == jobContext_.version() || transport_.isPlaying() || seekTarget_.frame)
    return;
  delivered_ = jobContext_.version();
  jobContext_.attempt(RequestKind::Objects, [&] {
    ObjectArea area = areaOf(jobContext_.inspector.views().image(IntermediateId::objectId), objects_);
    area.frame = jobContext_.inspector.shot().frame();
    jobContext_.tell(RequestKind::Objects, std::move(area));
  });
}

} // namespace taa
