// Frames of a few pixels that verdicts are made from, each pixel made up by hand.
#pragma once

#include "core/probe/SurfaceSteps.h"
#include "core/verdict/pixel/Evidence.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace taa::test {

inline constexpr int kMadeWidth = 8, kMadeHeight = 4;

/// Frames of 8×4 pixels: what each was resolved from is made up, what it resolved to follows.
class MadeEvidence : public EvidenceSource {
 public:
  struct Pixel {
    glm::dvec3 alpha{0.25}, current{0.0}, added{0.0}; ///< added: what the resolve made of it besides
    glm::dvec2 read{0.0};                             ///< px, where history was read
    std::vector<std::pair<glm::ivec2, double>> taps;
    double rectified = 0.0; ///< share of history that `added` took the place of
  };
  struct Frame {
    std::array<Pixel, kMadeWidth * kMadeHeight> pixels{};
    std::array<glm::dvec3, kMadeWidth * kMadeHeight> resolved{};
    twin::Texels reference{Image(kMadeWidth, kMadeHeight, 3)},
        steps{Image(kMadeWidth, kMadeHeight, kStepChannels)};
    bool starts = false;
  };

  static std::size_t indexOf(const glm::ivec2& pixel) {
    return static_cast<std::size_t>(pixel.y * kMadeWidth + pixel.x);
  }
  /// Resolves a frame on the one before.
  void add(int number, Frame frame) {
    for (int y = 0; y < kMadeHeight; ++y)
      for (int x = 0; x < kMadeWidth; ++x) {
        Pixel& pixel = frame.pixels[indexOf({x, y})];
        if (frame.starts) pixel.alpha = glm::dvec3(1.0);
        glm::dvec3 history(0.0);
        if (!frame.starts)
          for (const auto& [at, weight] : pixel.taps)
            history += weight * frames_.at(number - 1).resolved[indexOf(at)];
        frame.resolved[indexOf({x, y})] =
            pixel.alpha * pixel.current + (1.0 - pixel.alpha) * history + pixel.added;
      }
    frames_[number] = std::move(frame);
  }
  const Frame& at(int number) const { return frames_.at(number); }

  PixelStep step(int frame, const glm::ivec2& pixel) override {
    const Frame& made = frames_.at(frame);
    const Pixel& of = made.pixels[indexOf(pixel)];
    PixelStep step;
    step.alpha = of.alpha;
    step.current = of.current;
    step.rectified = of.rectified;
    step.resolved = made.resolved[indexOf(pixel)];
    step.sampled = static_cast<int>(made.steps.texel(pixel.x, pixel.y).z);
    step.historyPosition = of.read;
    if (!made.starts)
      for (const auto& [at, weight] : of.taps)
        step.history.push_back({at, weight, frames_.at(frame - 1).resolved[indexOf(at)]});
    return step;
  }
  twin::PixelRecord record(int, const glm::ivec2&) override { return {}; }
  const twin::Texels& reference(int frame) override { return frames_.at(frame).reference; }
  const twin::Texels& steps(int frame) override { return frames_.at(frame).steps; }

 private:
  std::map<int, Frame> frames_;
};

/// Nothing moves, all of history is the pixel's own; object 1 everywhere, reference and samples of one value.
inline MadeEvidence::Frame stillFrame(double value) {
  MadeEvidence::Frame frame;
  for (int y = 0; y < kMadeHeight; ++y)
    for (int x = 0; x < kMadeWidth; ++x) {
      MadeEvidence::Pixel& pixel = frame.pixels[MadeEvidence::indexOf({x, y})];
      pixel.current = glm::dvec3(value);
      pixel.read = glm::dvec2(x + 0.5, y + 0.5);
      pixel.taps = {{{x, y}, 1.0}};
      for (int channel = 0; channel < 3; ++channel)
        frame.reference.at(x, y)[channel] = static_cast<float>(value);
      frame.steps.at(x, y)[2] = 1.0f;
    }
  return frame;
}

/// A still frame that shows `object` alone, which was not seen before.
inline MadeEvidence::Frame coveredFrame(double value, int object) {
  MadeEvidence::Frame frame = stillFrame(value);
  for (int y = 0; y < kMadeHeight; ++y)
    for (int x = 0; x < kMadeWidth; ++x) {
      frame.steps.at(x, y)[0] = frame.steps.at(x, y)[1] = std::numeric_limits<float>::quiet_NaN();
      frame.steps.at(x, y)[2] = static_cast<float>(object);
    }
  return frame;
}

} // namespace taa::test
