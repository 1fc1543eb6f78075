// A source of frames whose planes are made by hand, so that what faults make of them can be said.
#pragma once

#include "core/base/Image.h"
#include "core/render/Cameras.h"
#include "core/render/CaptureFacts.h"
#include "core/render/FrameRequest.h"
#include "core/render/FrameSource.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec2.hpp>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace taa::test {

/// Numbers are multiples of powers of two, kept in 32 bits: what is computed of them is exact.
class HandMadeSource : public FrameSource {
 public:
  static constexpr int kWidth = 16, kHeight = 64;
  static constexpr float kDepth = 0.125f; ///< of surfaces: 8 m, the near plane being at 1 m
  static glm::vec2 sizePx() { return {kWidth, kHeight}; }

  /// `isCaptured`: as a capture, whose pictures are there already.
  explicit HandMadeSource(bool isCaptured = false) : isCaptured_(isCaptured) {}

  static glm::vec2 jitterPx(int frame) {
    return {0.25f - 0.0625f * static_cast<float>(frame), -0.125f * static_cast<float>(frame % 3)};
  }
  /// Of a texel in a frame, px; 0 in column 0.
  static glm::vec2 motionPx(int x, int y, int frame) {
    if (x == 0) return glm::vec2(0.0f);
    return {0.5f * static_cast<float>(x % 4) + static_cast<float>(frame % 2),
            -0.25f * static_cast<float>(y % 8)};
  }
  /// The upper half is sky; below a still object 1, a moving one 2 and a deforming one 3 stand side by side.
  static std::uint32_t objectAt(int x, int y) {
    return y < kHeight / 2 ? 0 : static_cast<std::uint32_t>(1 + x * 3 / kWidth);
  }
  static float depthAt(int x, int y) { return objectAt(x, y) == 0 ? 0.0f : kDepth; }
  /// Of color: the texel, the frame and how far it was displaced.
  static glm::vec4 colorAt(int x, int y, int frame, const glm::vec2& jitter) {
    return {static_cast<float>(x), static_cast<float>(y + frame), 1.0f + jitter.x, 1.0f};
  }
  /// Cameras of a frame: on its way to the right and turning.
  static CameraState cameraOf(int frame) {
    CameraState camera;
    const auto n = static_cast<float>(frame);
    camera.viewFromWorld = glm::rotate(glm::mat4(1.0f), 0.02f * n, glm::vec3(0, 1, 0)) *
                           glm::translate(glm::mat4(1.0f), glm::vec3(-0.1f * n, -1.0f, 0.0f));
    camera.clipFromView = glm::mat4(0.0f);
    camera.clipFromView[0][0] = 4.0f;
    camera.clipFromView[1][1] = 1.0f;
    camera.clipFromView[2][3] = -1.0f;
    camera.clipFromView[3][2] = 1.0f;
    camera.nearPlane = 1.0f;
    return camera;
  }

  std::vector<std::pair<int, FrameRequest>> asked; ///< frames that were drawn, and how

  void draw(const FrameRequest& request, int frame, FrameInputs& out) override {
    asked.emplace_back(frame, request);
    out.info = info(request, frame);
    fillCameras({cameraOf(frame), cameraOf(out.info.startsHistory ? frame : frame - 1), sizePx(),
                 out.info.jitterPx, jitterPx(frame > 0 ? frame - 1 : 0), JitterProjection::Translation},
                out.block);
    fillStorage(Precision::Full, 0.0f, frame, out.block);
    fill(frame, out.info.jitterPx, out);
  }
  FrameInfo info(const FrameRequest& request, int frame) const override {
    FrameInfo info;
    info.frame = frame;
    info.jitterPx = isCaptured_ ? jitterPx(frame) : request.jitterPx.value_or(jitterPx(frame));
    info.startsHistory = frame == 0 || frame == kCut;
    return info;
  }
  CameraState camera(const FrameRequest& /*request*/, int frame) const override { return cameraOf(frame); }
  void warmUp(const FrameRequest& /*request*/, const Progress& /*progress*/) override {}
  const DrawCounts& counts() const override { return counts_; }
  void reloadShaders() override {}
  std::shared_ptr<const CaptureFacts> capture() const override {
    if (!isCaptured_) return nullptr;
    auto facts = std::make_shared<CaptureFacts>();
    for (int frame = 0; frame < kFrames; ++frame) facts->jitterPx.push_back(jitterPx(frame));
    facts->hasCameraMotion = true;
    return facts;
  }

  static constexpr int kFrames = 12, kCut = 8;

 private:
  static void fill(int frame, const glm::vec2& jitter, FrameInputs& out) {
    Image color(kWidth, kHeight, 4), motion(kWidth, kHeight, 2), normal(kWidth, kHeight, 4),
        depth(kWidth, kHeight, 1), previousDepth(kWidth, kHeight, 1);
    std::vector<std::uint32_t> ids;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        for (int channel = 0; channel < 4; ++channel)
          color.at(x, y)[channel] = colorAt(x, y, frame, jitter)[channel];
        motion.at(x, y)[0] = motionPx(x, y, frame).x;
        motion.at(x, y)[1] = motionPx(x, y, frame).y;
        depth.at(x, y)[0] = depthAt(x, y);
        previousDepth.at(x, y)[0] = 2.0f;
        normal.at(x, y)[3] = static_cast<float>(objectAt(x, y)); // classes are numbered as they are
        ids.push_back(objectAt(x, y));
      }
    const auto put = [](gl::Texture& texture, gl::Format format, const Image& image) {
      texture = gl::Texture({kWidth, kHeight}, format, "by hand");
      texture.upload(image);
    };
    put(out.color, gl::Format::RGBA32F, color);
    put(out.motion, gl::Format::RG32F, motion);
    put(out.normal, gl::Format::RGBA32F, normal);
    put(out.depth, gl::Format::Depth32F, depth);
    put(out.previousDepth, gl::Format::R32F, previousDepth);
    out.objectId = gl::Texture({kWidth, kHeight}, gl::Format::R32UI, "by hand");
    out.objectId.uploadIntegers(ids);
  }

  bool isCaptured_;
  DrawCounts counts_;
};

} // namespace taa::test
