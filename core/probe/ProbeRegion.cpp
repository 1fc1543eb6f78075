#include "core/probe/ProbeRegion.h"

#include <limits>

namespace taa {

namespace {

// Rows that no resolve gives have no value.
twin::PixelRecord noValues() {
  twin::PixelRecord record;
  record.fill(glm::vec4(std::numeric_limits<float>::quiet_NaN()));
  return record;
}

} // namespace

std::vector<twin::PixelRecord> probeRegion(TaaPass& pass, const FrameInputs& inputs, const History* previous,
                                           const History& resolved, const Settings& settings,
                                           const gl::Rect& region) {
  const std::vector<IntermediateId> ids = allRows();
  ExposedRows exposedRows(ids, region);
  pass.expose(inputs, previous, resolved, settings, exposedRows);
  std::vector<twin::PixelRecord> records(static_cast<std::size_t>(region.width) * region.height, noValues());
  for (IntermediateId id : ids) {
    const Image image = exposedRows.image(id);
    for (int y = 0; y < region.height; ++y)
      for (int x = 0; x < region.width; ++x)
        twin::at(records[static_cast<std::size_t>(y) * region.width + x], id) = image.texel(x, y);
  }
  return records;
}

} // namespace taa
