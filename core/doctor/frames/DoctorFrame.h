// A frame as the doctor reads it: planes in main memory, in this program's conventions, whoever drew them.
#pragma once

#include "core/base/Image.h"
#include "core/render/FrameRequest.h"
#include "core/render/FrameSource.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace taa::doctor {

/// What frames of a source hold; what they do not is made up by it or 0, and no evidence.
struct KnownPlanes {
  bool motion = true; ///< else it is what the resolve takes it to be: rest, or what depth and matrices make
  bool depth = true, ids = true;
  bool camera = true;         ///< matrices of all frames
  bool depthJittered = true;  ///< depth was drawn with the jitter of its frame
  bool depthDistance = false; ///< depth is examined as a distance that is stored, and no device depth
  bool output = false;        ///< what a TAA made of the frames
  bool maskUsed = false;      ///< the TAA gets the mask; else it says what was drawn, to the doctor alone
  /// Of a capture: the near plane that is stated over that of its matrices, by which depth is decoded.
  float nearFactor = 1.0f;
};

/// Of a frame and of the one before it, without jitter; the projection is that of both.
struct UnjitteredCameras {
  glm::dmat4 clipFromView{1.0}, viewFromWorld{1.0}, previousViewFromWorld{1.0};
};

/// Row 0 is the top. All planes have the size of what was drawn; those that are not known are empty.
struct DoctorFrame {
  int frame = 0;
  bool startsHistory = false;
  glm::vec2 jitterPx{0.0f};  ///< as stated: displacement of image content, x right, y down
  Image luma;                ///< light that is compared, 0 to 1; see comparedLuma()
  std::size_t badColors = 0; ///< pixels whose color is no number; their luma is 0 or 1
  Image motionPx;            ///< two channels, current − previous, without jitter; see kNoPreviousPosition
  Image depth;               ///< reversed, 0: sky
  Image depthView;           ///< m, 0: sky
  Image previousDepthView;   ///< m, of the same surface a frame ago; 0: sky or none
  Image mask;                ///< two channels: reactive, responsive; 0 to 1
  std::vector<std::uint32_t> objectId; ///< 0: nothing
  std::vector<std::uint8_t>
      covered; ///< 1: an interface lies there, no evidence of what is behind; empty: none does
  std::optional<glm::mat4> previousClipFromClip; ///< both without jitter; none: cameras are not known
  std::optional<UnjitteredCameras> cameras;      ///< none: they are not known
  glm::vec2 depthJitterPx{0.0f};                 ///< displacement of what depth shows
  /// View depth as stated over that by the matrices, which is 1; 0: one of them is not known.
  float distanceFactor = 0.0f;
  Image color;  ///< three channels or more, scene-linear; empty: it is not looked at
  Image output; ///< what a TAA made of the frame, likewise; as large as the picture, which may be larger
  glm::vec4 depthTerms{0.0f}; ///< (P33, P32, P23, P22) of the projection

  glm::ivec2 sizePx() const { return {luma.width, luma.height}; }
  glm::vec2 motionAt(int x, int y) const { return {motionPx.at(x, y)[0], motionPx.at(x, y)[1]}; }
  bool isCovered(const glm::ivec2& pixel) const {
    return !covered.empty() && covered[static_cast<std::size_t>(pixel.y) * luma.width + pixel.x] != 0;
  }
  /// `pixel`: y · width + x. False without depth.
  bool isSky(std::size_t pixel) const { return !depth.empty() && depth.pixels[pixel] == 0.0f; }
};

/// Frame n; a function of n alone. Throws Error.
using FrameReader = std::function<DoctorFrame(int frame)>;

class EngineOutput;

/// Draws and downloads a frame. `output`: null: what a TAA makes of it is not looked at. Needs the current
/// context. Throws Error.
DoctorFrame readFrame(FrameSource& source, const FrameRequest& request, const KnownPlanes& known, int frame,
                      EngineOutput* output = nullptr);

/// Whether a place, px from the picture's corner, can be read between pixels. NaN cannot.
bool isInPicture(const glm::vec2& place, const glm::ivec2& sizePx);
/// Whether an interface lies at a pixel, or something is blended in: no evidence of what is behind.
bool isMasked(const DoctorFrame& frame, const glm::ivec2& pixel);

/// Whether a motion is one: not the mark of no previous position, not NaN.
bool isMotion(const glm::vec2& motionPx);

/// What a pixel's surface moves by where it rests in the world, px, current − previous, by the frame's depth
/// and cameras (manual §3.1). Nothing where these are not known or it was behind the previous camera.
std::optional<glm::vec2> cameraMotionPx(const DoctorFrame& frame, const glm::ivec2& pixel);
/// The same if the depth there was another one; 0: infinitely far away.
std::optional<glm::vec2> cameraMotionPx(const DoctorFrame& frame, const glm::ivec2& pixel, float depth);
/// That of both frames' projections with y the other way.
glm::mat4 flippedMatrix(const glm::mat4& previousClipFromClip);
/// The same with other cameras.
std::optional<glm::vec2> motionUnder(const glm::mat4& previousClipFromClip, const DoctorFrame& frame,
                                     const glm::ivec2& pixel, float depth);

} // namespace taa::doctor
