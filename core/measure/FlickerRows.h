// The rows of the table that are over time, of one lane: the frames they are made of, and their pictures.
#pragma once

#include "core/gl/Texture.h"
#include "core/measure/Flicker.h"
#include "core/probe/SurfaceSteps.h"
#include "core/render/FrameRequest.h"
#include "core/replay/TraceCursor.h"
#include "core/settings/Settings.h"
#include "core/taa/rows/Intermediates.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace taa {

/// All that these rows are a function of, besides the frame's number and how many frames there are.
struct FlickerKey {
  FrameRequest request; ///< of the lane
  Settings settings;
  bool operator==(const FlickerKey&) const = default;
};

/// Frames in a row that flicker is taken over, as far as they are made. The next frame needs one more.
struct FlickerWindow {
  std::map<int, FlickerFrame> frames;
  TraceCursor cursor;                               ///< where what is shown has come to
  std::optional<std::pair<int, SeenSurfaces>> seen; ///< what was drawn last for a way
};

/// Gives up frames that are not among `first` to `last`.
void keepOnly(FlickerWindow& window, int first, int last);

/// Of frame `last`, of whose frames from `first` on all is made; reference: that of so many samples is.
FlickerMaps flickerMaps(const FlickerWindow& window, int first, int last, const Progress& progress);

/// Bytes of main memory that the frames of one lane take.
std::size_t flickerBytes(const glm::ivec2& picturePx, int frames);

class FlickerRows {
 public:
  /// Forgets what is of another key, or of a scene or shaders that are gone (`forget`).
  FlickerWindow& windowOf(const FlickerKey& key);
  void forget() { *this = {}; }

  void set(int frame, int frames, int samples, FlickerMaps maps);
  /// Samples of the reference that went into the maps of the frame, 0: none; nothing: there are no maps.
  std::optional<int> samples(const FlickerKey& key, int frame, int frames) const;
  const FlickerMaps& maps() const { return maps_; }

  /// Expects that it is there: isOverTime(id), and a reference where that is needed.
  const Image& map(IntermediateId id) const;
  Image image(IntermediateId id, const gl::Rect& region) const;
  /// One layer, for the Visualizer.
  const gl::Texture& texture(IntermediateId id);

 private:
  FlickerKey key_;
  FlickerWindow window_;
  int frame_ = -1, frames_ = 0, samples_ = 0; // of the maps; −1: there are none
  FlickerMaps maps_;
  std::map<IntermediateId, gl::Texture> textures_; // made when first shown
};

} // namespace taa
