#include "core/render/ForwardCount.h"

#include "core/render/FrameInputs.h"

#include <cmath>

namespace taa {

Image forwardCount(const Image& motionPx) {
  Image counts(motionPx.width, motionPx.height, 1);
  for (int y = 0; y < motionPx.height; ++y)
    for (int x = 0; x < motionPx.width; ++x) {
      const float* motion = motionPx.at(x, y);
      const float toX = std::floor(static_cast<float>(x) + 0.5f - motion[0]);
      const float toY = std::floor(static_cast<float>(y) + 0.5f - motion[1]);
      const bool isInside = toX >= 0.0f && toY >= 0.0f && toX < static_cast<float>(counts.width) &&
                            toY < static_cast<float>(counts.height);
      if (isInside && motion[0] != kNoPreviousPosition) *counts.at(int(toX), int(toY)) += 1.0f;
    }
  return counts;
}

} // namespace taa
