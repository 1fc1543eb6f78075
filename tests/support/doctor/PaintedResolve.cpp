#include "tests/support/doctor/PaintedResolve.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace taa::test {

namespace {

/// Of three channels that differ, so that colors are no shades of gray.
Image paintedColor(const Image& luma) {
  Image out(luma.width, luma.height, 4);
  for (std::size_t i = 0; i < luma.pixels.size(); ++i) {
    const float value = luma.pixels[i];
    const float color[4] = {value, 0.8f * value * value + 0.05f, 0.6f - 0.5f * value, 1.0f};
    for (std::size_t channel = 0; channel < 4; ++channel) out.pixels[4 * i + channel] = color[channel];
  }
  return out;
}

/// Another picture with the same motion.
void turnOver(Image& luma) {
  for (float& value : luma.pixels) value = 1.0f - value;
}

/// `history`: null: none.
Image resolved(const doctor::DoctorFrame& frame, const Image* history, const PaintedResolve& resolve) {
  Image out = frame.color;
  for (int y = 0; y < out.height && history; ++y)
    for (int x = 0; x < out.width; ++x) {
      const glm::vec2 motion = resolve.motionFactor * frame.motionAt(x, y);
      const int u = x - static_cast<int>(std::lround(motion.x)),
                v = y - static_cast<int>(std::lround(motion.y));
      if (u < 0 || v < 0 || u >= out.width || v >= out.height) continue;
      for (int channel = 0; channel < 3; ++channel) {
        const float before = history->at(u, v)[channel];
        out.at(x, y)[channel] = before + resolve.alpha * (out.at(x, y)[channel] - before);
      }
    }
  return out;
}

} // namespace

std::vector<doctor::DoctorFrame> resolvedFrames(const PaintedShot& shot, int frames,
                                                const PaintedResolve& resolve) {
  std::vector<doctor::DoctorFrame> out;
  for (int number = 0; number < frames; ++number) {
    doctor::DoctorFrame frame = paintedFrame(shot, number);
    if (number == resolve.cut) frame.startsHistory = true;
    if (resolve.cut >= 0 && number >= resolve.cut) turnOver(frame.luma);
    frame.color = paintedColor(frame.luma);
    const bool isReset = number == 0 || (frame.startsHistory && resolve.resetsAtCuts);
    PaintedResolve now = resolve;
    if (number < resolve.wrongFrom) {
      now.alpha = resolve.alphaBefore;
      now.motionFactor = 1.0f;
      now.isSwapped = true;
    }
    const std::size_t last = out.size() - (now.isSwapped || number < 2 ? 1 : 2);
    frame.output = resolved(frame, isReset ? nullptr : &out[last].output, now);
    if (resolve.nanFrame >= 0 && number >= resolve.nanFrame)
      frame.output.at(40, 40)[1] = std::numeric_limits<float>::quiet_NaN();
    out.push_back(std::move(frame));
  }
  return out;
}

} // namespace taa::test
