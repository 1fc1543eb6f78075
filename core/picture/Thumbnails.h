// Small pictures of rows: only the pixels they show are computed, each exactly as in the full picture.
#pragma once

#include "core/picture/Visualizer.h"
#include "core/replay/Checkpoints.h"

#include <memory>

namespace taa {

/// Keeps the values of one frame, of all rows: the probe's program gives them all, so there is none more to
/// compile, and one small draw serves the thumbnails of every stage.
class Thumbnails {
 public:
  /// The values of `texels` pixels, each in the middle of its share of the picture.
  const ExposedRows& exposed(TaaPass& pass, const ResolvedFrame& frame, const glm::ivec2& texels);
  /// `id` in the style it opens with.
  Picture draw(TaaPass& pass, Visualizer& visualizer, const ResolvedFrame& frame, IntermediateId id,
               const glm::ivec2& texels);
  void forget();

 private:
  ExposedRows exposedRows_;
  std::weak_ptr<const History> shownHistory_; // whose values they are; it may end meanwhile
};

} // namespace taa
