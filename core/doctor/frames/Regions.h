// Connected parts of the picture that are examined each by itself: a wrong sky or one wrong object hides in
// any mean over the whole.
#pragma once

#include "core/doctor/Outline.h"
#include "core/doctor/frames/DoctorFrame.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace taa::doctor {

/// Index of a region in RegionTracker::regions().
using RegionIndex = std::int32_t;
inline constexpr RegionIndex kNoRegion = -1;

/// A region over all frames in which it was seen.
struct Region {
  bool isSky = false;
  std::uint32_t objectId = 0; ///< 0: the sky, or a part that no number says
  int frames = 0;             ///< in which it was seen
  double pixels = 0.0;        ///< of all those frames
  int frame = 0;              ///< the last in which it was nearly as large as ever …
  std::size_t size = 0;       ///< … its pixels where it was largest …
  glm::ivec4 box{0};          ///< … and what they lie in: left, top, first beyond right and bottom
  glm::ivec2 pixel{0};        ///< one of its pixels there, well inside
  std::vector<PixelRun> runs; ///< all of its pixels there, row by row
};

/// Which region a pixel belongs to, frame after frame.
class RegionTracker {
 public:
  /// The region of each pixel of `frame`, row by row. By object id where there is one. Else connected pixels
  /// whose depth and motion go on from one to the next are one region, which is the one of the frame before
  /// that it covers most of; parts smaller than kLeastPart are none. The sky is one region.
  std::vector<RegionIndex> label(const DoctorFrame& frame);

  const std::vector<Region>& regions() const { return regions_; }

 private:
  RegionIndex ofId(std::uint32_t id);
  RegionIndex ofSky();
  void labelConnected(const DoctorFrame& frame, std::vector<RegionIndex>& labels);
  void measure(const DoctorFrame& frame, const std::vector<RegionIndex>& labels);
  RegionIndex add(const Region& region);

  std::vector<Region> regions_;
  std::map<std::uint32_t, RegionIndex> ofIds_;
  RegionIndex sky_ = kNoRegion;
  std::vector<RegionIndex> before_; ///< of the frame labelled last
};

/// Pixels.
inline constexpr std::size_t kLeastPart = 48;

/// Whether all pixels around one, too, are of its region. False at the border of the picture.
bool isInside(const std::vector<RegionIndex>& labels, const glm::ivec2& sizePx, int x, int y);
/// Whether four pixels in a square, of which one is this, are all of its region. Where it lay a frame ago, a
/// pixel of its surface is one of the four around it then; thinner things may lie between pixels.
bool isWide(const std::vector<RegionIndex>& labels, const glm::ivec2& sizePx, int x, int y);
/// The four pixels that a place in px lies between, by their indices; nothing where one of them is beyond the
/// picture, or the place is none.
std::optional<std::array<std::size_t, 4>> pixelsAround(const glm::vec2& place, const glm::ivec2& sizePx);
/// Labels of the pixels that are inside; of all others none.
std::vector<RegionIndex> insideOf(const std::vector<RegionIndex>& labels, const glm::ivec2& sizePx);

} // namespace taa::doctor
