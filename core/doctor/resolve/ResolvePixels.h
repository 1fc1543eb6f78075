// Pixels of a frame as the resolve of each model sees them, made by the CPU twin.
#pragma once

#include "core/base/Image.h"
#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/resolve/ResolveModels.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace taa::doctor {

/// A frame, and what its resolve can have read.
struct ResolveFrames {
  const DoctorFrame& now;
  const DoctorFrame& before;
  const Image& outputTwoBefore; ///< of the frame before `before`; empty: not known
  int historyFrames = 1;        ///< from the start of history to `before`, which is one of them
};

/// Pixels of a set, here and there, the same for all models: with detail, in the middle of colors that are
/// numbers, and where nothing is blended over them. `most`: of them, at most.
std::vector<glm::ivec2> resolvePixels(const ResolveFrames& frames, PixelSet set, std::size_t most);

/// How far two colors are from each other: the largest difference of a channel c/(1 + c), at most 0.05, so
/// that few pixels which nothing explains do not count more than all others.
float colorDistance(const glm::vec3& a, const glm::vec3& b);

/// Distances from the output that a model makes: by its own rule of α, then by kTriedAlphas.
using ModelDistances = std::array<float, 1 + kTriedAlphas.size()>;

/// Expects output and color of both frames, all of one size.
class ResolveTwin {
 public:
  explicit ResolveTwin(const ResolveFrames& frames);
  /// Whether the model has all that it reads.
  bool canTry(const ResolveModel& model) const;
  /// Sums over the pixels.
  ModelDistances distances(const ResolveModel& model, const std::vector<glm::ivec2>& pixels);

 private:
  void takeHistory(const ResolveModel& model);

  const ResolveFrames& frames_;
  twin::Inputs inputs_;       ///< of now
  twin::Inputs inputsBefore_; ///< depth and motion of the frame before
  /// What a model is given in place of what inputs_ hold.
  twin::Texels opposite_, output_, outputTwoBefore_;
};

} // namespace taa::doctor
