// The rows of the table that one measurement over time gives of a frame, and their pictures.
#pragma once

#include "core/base/Image.h"
#include "core/gl/Texture.h"
#include "core/measure/Metrics.h"
#include "core/render/FrameRequest.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <map>
#include <optional>

namespace taa {

/// Whole pictures of rows.
using RowImages = std::map<IntermediateId, Image>;

/// All that rows over time are a function of, besides the frame's number and how many frames there are.
struct OverTimeKey {
  FrameRequest request; ///< of the lane
  Settings settings;
  bool operator==(const OverTimeKey&) const = default;
};

/// A metric over time from the rows it is measured with, its own among them; nothing where nothing of the
/// frame was seen before. Parts of the error: the mean of their amounts; ghosts: the root of their mean
/// square.
std::optional<double> metricOverTime(Metric metric, const RowImages& rows);

class RowsOverTime {
 public:
  /// What they are made of, besides references.
  struct Origin {
    OverTimeKey key;
    int frame = -1, frames = 0;
    bool operator==(const Origin&) const = default;
  };
  void set(const Origin& origin, int samples, RowImages maps);
  void forget() { *this = {}; }

  /// Samples of the references that went into those of the frame, 0: none; nothing: they are not made.
  std::optional<int> samples(const Origin& origin) const;
  const RowImages& maps() const { return maps_; }

  /// Expects that it is there: that it is measured, against references where that is needed.
  const Image& map(IntermediateId id) const;
  Image image(IntermediateId id, const gl::Rect& region) const;
  /// One layer, for the Visualizer.
  const gl::Texture& texture(IntermediateId id);

 private:
  Origin origin_;
  int samples_ = 0;
  RowImages maps_;
  std::map<IntermediateId, gl::Texture> textures_; // made when first shown
};

} // namespace taa
