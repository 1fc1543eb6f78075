// The rows of the table that compare the output with the reference, or the resolved color with what an engine
// made of the frame.
#pragma once

#include "core/base/Image.h"
#include "core/measure/Metrics.h"
#include "core/measure/PictureComparison.h"
#include "core/measure/References.h"
#include "core/replay/Checkpoints.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace taa {

/// The value of a row of the reference in one pixel, missing channels 0: of the output against it, or of the
/// resolved color against the engine's output. Expects one of that pixel and frame alone.
glm::vec4 referenceValue(IntermediateId id, const glm::vec4& output, const glm::vec4& reference);

/// A row of one channel or three as the Visualizer takes it.
gl::Texture rowTexture(const Image& row, const std::string& label);

/// The rows of one lane of a frame, kept while neither its output nor its reference changes.
class ReferenceRows {
 public:
  /// What they are made of.
  struct Origin {
    HistoryHandle current;
    Settings settings;
    ReferenceKey key;
    int samples = 0;
  };
  bool isOf(const Origin& origin) const;
  void set(const Origin& origin, Image reference, Image output);
  void forget() { *this = {}; }

  int samples() const { return samples_; }
  const Image& reference() const { return compared_.reference(); }
  /// Numbers and maps of the two pictures.
  PictureComparison& compared() { return compared_; }
  Image image(IntermediateId id, const gl::Rect& region);
  /// One layer, for the Visualizer.
  const gl::Texture& texture(IntermediateId id);

 private:
  std::weak_ptr<const History> current_; // whose output it is; it may end meanwhile
  Settings settings_;
  ReferenceKey key_;
  int samples_ = 0;
  PictureComparison compared_;
  std::map<IntermediateId, gl::Texture> textures_; // made when first shown
};

} // namespace taa
