// A few frames of the CPU twin, resolved one after another, as a source of lineages and to put impulses into.
#pragma once

#include "core/verdict/lineage/Lineage.h"
#include "core/verdict/lineage/TwinStep.h"
#include "tests/support/frames/TwinInputs.h"

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace taa::test {

/// What a frame leaves.
struct LeftHistory {
  Image color, surface;
};

class LineageShot : public LineageSource {
 public:
  using Resolve = std::function<LeftHistory(const twin::Inputs& frame, const Settings& settings)>;

  /// `frames` without histories, which `resolve` makes.
  LineageShot(std::vector<twin::Inputs> frames, const Settings& settings, Resolve resolve = resolveByTwin);

  PixelStep step(int frame, const glm::ivec2& pixel) override;

  /// What a pixel of the last frame became.
  glm::vec3 resolved(const glm::ivec2& pixel) const;
  /// The same frames where `change` is added to the current color of every texel of one.
  using Change = std::function<glm::vec3(const glm::ivec2& texel)>;
  LineageShot with(int frame, const Change& change) const;
  glm::vec3 resolvedWith(int frame, const Change& change, const glm::ivec2& pixel) const {
    return with(frame, change).resolved(pixel);
  }

  static LeftHistory resolveByTwin(const twin::Inputs& frame, const Settings& settings);

 private:
  std::vector<twin::Inputs> frames_;
  Settings settings_;
  Resolve resolve_;
  Image last_; // color of what the last one left
};

/// Σ weight · change over the samples of a frame: what a lineage predicts of the response to that.
glm::dvec3 predictedResponse(const Lineage& lineage, int frame, const LineageShot::Change& change);

/// Gray levels between 0.4 and 0.6 that differ from texel to texel and from frame to frame: no filter leaves
/// what can be stored.
twin::Inputs mottledFrame(int width, int height, int frame);

/// Moves all that is seen by `motionPx` a frame.
void setMotion(twin::Inputs& inputs, const glm::vec2& motionPx);

} // namespace taa::test
