#include "core/inspect/FrameWindow.h"

#include <algorithm>

namespace taa {

void FrameWindow::keepOnly(int first, int last) {
  const auto isOutside = [&](const auto& entry) { return entry.first < first || entry.first > last; };
  std::erase_if(frames, isOutside);
  std::erase_if(references, isOutside);
}

std::size_t windowBytes(const glm::ivec2& picturePx, int frames, std::span<const OverTime> kinds) {
  if (kinds.empty()) return 0;
  std::size_t floats = kStepChannels;
  for (const OverTime kind : kinds)
    floats += kind == OverTime::Flicker ? 3 + 3          // what is shown, of the reference too
                                        : 3 * 4 + 3 + 4; // four errors, what is kept, where it was read
  return floats * sizeof(float) * static_cast<std::size_t>(picturePx.x) *
         static_cast<std::size_t>(picturePx.y) * static_cast<std::size_t>(frames);
}

} // namespace taa
