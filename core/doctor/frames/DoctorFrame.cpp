#include "core/doctor/frames/DoctorFrame.h"

#include "core/capture/import/FrameSamples.h"
#include "core/doctor/frames/EngineOutput.h"
#include "core/taa/twin/SampleStages.h"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::doctor {

namespace {

UnjitteredCameras camerasOf(const shared::FrameBlock& block) {
  const glm::dmat4 viewFromWorld(block.viewFromWorld);
  return {glm::dmat4(block.clipFromWorld) * glm::inverse(viewFromWorld), viewFromWorld,
          glm::dmat4(block.previousViewFromWorld)};
}

std::size_t badPixels(const Image& color) {
  std::size_t count = 0;
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      const float* at = color.at(x, y);
      if (!std::isfinite(at[0] + at[1] + at[2])) ++count;
    }
  return count;
}

/// Of something 10 m away, in the middle of the picture.
float distanceFactor(const shared::FrameBlock& block) {
  constexpr double kDistance = 10.0;
  const glm::dvec4 clip = camerasOf(block).clipFromView * glm::dvec4(0.0, 0.0, -kDistance, 1.0);
  if (!(clip.w > 0.0) || !(clip.z > 0.0)) return 0.0f;
  const auto depth = static_cast<float>(clip.z / clip.w);
  return twin::viewDepth(depth, block.depthTerms) / static_cast<float>(kDistance);
}

} // namespace

bool isInPicture(const glm::vec2& place, const glm::ivec2& sizePx) {
  // Comparisons are written so that NaN fails them.
  return place.x >= 0.5f && place.y >= 0.5f && place.x <= static_cast<float>(sizePx.x) - 0.5f &&
         place.y <= static_cast<float>(sizePx.y) - 0.5f;
}

bool isMasked(const DoctorFrame& frame, const glm::ivec2& pixel) {
  if (frame.isCovered(pixel)) return true;
  if (frame.mask.empty()) return false;
  const float* mask = frame.mask.at(pixel.x, pixel.y);
  return mask[0] > 0.0f || mask[1] > 0.0f;
}

bool isMotion(const glm::vec2& motionPx) {
  // Comparisons are written so that NaN fails them.
  return std::abs(motionPx.x) < kNoPreviousPosition && std::abs(motionPx.y) < kNoPreviousPosition;
}

DoctorFrame readFrame(FrameSource& source, const FrameRequest& request, const KnownPlanes& known, int frame,
                      EngineOutput* output) {
  FrameInputs drawn;
  source.draw(request, frame, drawn);
  DoctorFrame out;
  out.frame = frame;
  out.startsHistory = drawn.info.startsHistory;
  out.jitterPx = drawn.info.jitterPx;
  Image color = drawn.color.download();
  out.luma = capture::comparedLuma(color);
  out.badColors = badPixels(color);
  if (output) {
    out.output = output->read(source, request, drawn, frame);
    out.color = std::move(color);
  }
  out.depthTerms = drawn.block.depthTerms;
  out.motionPx = drawn.motion.download();
  if (known.depth) {
    out.depth = drawn.depth.download();
    out.depthView = out.depth;
    for (float& depth : out.depthView.pixels)
      depth = depth > 0.0f ? twin::viewDepth(depth, drawn.block.depthTerms) : 0.0f;
    out.previousDepthView = drawn.previousDepth.download();
  }
  if (drawn.mask) out.mask = drawn.mask.download();
  if (known.ids) out.objectId = drawn.objectId.downloadIntegers();
  if (known.camera && known.depth) out.previousClipFromClip = drawn.block.previousClipFromClip;
  if (known.depthJittered) out.depthJitterPx = out.jitterPx;
  if (known.camera && known.depth) out.cameras = camerasOf(drawn.block);
  if (known.camera && known.depth) out.distanceFactor = known.nearFactor * distanceFactor(drawn.block);
  return out;
}

std::optional<glm::vec2> cameraMotionPx(const DoctorFrame& frame, const glm::ivec2& pixel) {
  if (frame.depth.empty()) return {};
  return cameraMotionPx(frame, pixel, *frame.depth.at(pixel.x, pixel.y));
}

std::optional<glm::vec2> cameraMotionPx(const DoctorFrame& frame, const glm::ivec2& pixel, float depth) {
  if (!frame.previousClipFromClip) return {};
  return motionUnder(*frame.previousClipFromClip, frame, pixel, depth);
}

glm::mat4 flippedMatrix(const glm::mat4& previousClipFromClip) {
  glm::mat4 flip(1.0f);
  flip[1][1] = -1.0f;
  return flip * previousClipFromClip * flip;
}

std::optional<glm::vec2> motionUnder(const glm::mat4& previousClipFromClip, const DoctorFrame& frame,
                                     const glm::ivec2& pixel, float depth) {
  const glm::vec2 pxPerNdc = glm::vec2(0.5f, -0.5f) * glm::vec2(frame.sizePx());
  const glm::vec2 ndc = (glm::vec2(pixel) + 0.5f - frame.depthJitterPx) / pxPerNdc + glm::vec2(-1.0f, 1.0f);
  const glm::vec4 previous = previousClipFromClip * glm::vec4(ndc, depth, 1.0f);
  if (!(previous.w > 0.0f)) return {};
  const glm::vec2 motionPx = (ndc - glm::vec2(previous) / previous.w) * pxPerNdc;
  if (!isMotion(motionPx)) return {};
  return motionPx;
}

} // namespace taa::doctor
