// Pairs of consecutive frames of a capture as far as its conventions are asked of them: pixels here and there
// with what is stored for them, and the pictures they are looked for in.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/capture/decode/Motion.h"
#include "core/capture/format/Manifest.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace taa::capture {

/// A frame and the one before it.
struct FramePair {
  std::size_t index = 0;          ///< of the later frame
  std::vector<glm::ivec2> places; ///< pixels of the sample
  std::vector<float> luma;        ///< there, of this frame
  Image motion, depth;            ///< as stored, places.size() × 1; empty where the capture has none
  Image previousLuma;             ///< the whole picture
  Image previousDepth;            ///< likewise, as stored; empty where cameras or jitter are not known
};

/// Conventions that are looked at, and whether colors hold the jitter that frames state.
struct TestState {
  Conventions conventions;
  bool isJittered = true;
};

/// What a pair's pixels do under some conventions.
struct PairMotion {
  std::vector<glm::vec2> stored; ///< decoded motion, px; NaN: not known
  std::vector<glm::vec2> camera; ///< that of the camera; empty: not known
  std::vector<float> depth;      ///< this program's; empty: not known
  /// That of the surfaces in the frame before, if they rest in the world: this program's, 0: none. As camera.
  std::vector<float> previousDepth;
  glm::vec2 jitterStep{0.0f}; ///< jitter of the earlier frame minus that of the later one
};

class FrameSamples {
 public:
  /// Reads up to `maxPairs` pairs. Throws Error, Cancelled.
  FrameSamples(const std::filesystem::path& folder, Manifest manifest, int maxPairs,
               const Progress& progress);

  const Manifest& manifest() const { return manifest_; }
  const std::vector<FramePair>& pairs() const { return pairs_; }
  bool hasMotion() const { return hasMotion_; } ///< of some frames at least; so of depth
  bool hasDepth() const { return hasDepth_; }
  bool hasMatrices() const { return hasMatrices_; }
  bool hasJitter() const { return hasJitter_; } ///< one that is not the same in all frames
  /// Whether there is all that tells a depth with jitter from one without.
  bool asksDepthJitter() const { return hasDepth_ && hasMatrices_ && hasJitter_; }

  /// Nothing where conventions contradict the capture: its matrices cannot be such. `withCamera`: also what
  /// the camera's motion is.
  std::optional<PairMotion> motionOf(const FramePair& pair, const TestState& state, bool withCamera);
  /// The whole depth of the frame before, this program's. Nothing where conventions contradict the capture;
  /// empty where it is not known.
  std::optional<Image> previousDepthOf(const FramePair& pair, const TestState& state);

 private:
  FramePair read(const std::filesystem::path& folder, std::size_t index);
  bool takeGeometry(const FramePair& pair, const glm::dvec2& jitterPx, PairMotion& out);
  void takeStored(const FramePair& pair, const MotionInputs& inputs, PairMotion& out);

  Manifest manifest_; ///< its conventions are those looked at last
  std::vector<FramePair> pairs_;
  bool hasMotion_ = false, hasDepth_ = false, hasMatrices_ = false, hasJitter_ = false;
};

/// Light that is compared: luminance l as l / (1 + l), smoothed over 3×3 pixels so that what aliases weighs
/// less.
Image comparedLuma(const Image& color);
/// Of one channel, between pixels; `place` counts from the corner of the picture, outside is the nearest
/// pixel.
float betweenPixels(const Image& plane, const glm::vec2& place);
/// By so much of itself reading between pixels pulls a length that is fitted so, in all pairs alike.
inline constexpr double kReadingError = 0.004;

} // namespace taa::capture
