#include "core/render/passes/CameraMotionPass.h"

#include <cassert>
#include <string>

namespace taa {

namespace {

gl::Program compileCameraMotion(MotionSource source) {
  const auto constant = [](const char* name, MotionSource value) {
    return std::string("const int ") + name + " = " + std::to_string(static_cast<int>(value)) + ";\n";
  };
  const std::string prelude =
      constant("kMotionSource", source) + constant("kRawUv", MotionSource::RawUv) +
      constant("kJitterDifference", MotionSource::JitterDifference) +
      constant("kJitterDifferenceAsPrinted", MotionSource::JitterDifferenceAsPrinted) +
      constant("kSingleMatrix", MotionSource::SingleMatrix);
  return {gl::ShaderSource("include/fullscreen.vert"), gl::ShaderSource("scene/camera_motion.frag", prelude),
          "CameraMotionPass"};
}

} // namespace

bool isFromDepth(MotionSource source) {
  return source != MotionSource::Objects && source != MotionSource::ObjectsAsPrinted &&
         source != MotionSource::CurrentProjectionAsPrinted;
}

CameraMotionPass::CameraMotionPass() : nearest_(gl::SamplerState{}) {}

CameraMotionPass CameraMotionPass::reloaded() const {
  CameraMotionPass pass;
  for (const auto& [source, program] : programs_) pass.programs_.emplace(source, compileCameraMotion(source));
  return pass;
}

void CameraMotionPass::draw(MotionSource source, const gl::Buffer& frame, const FrameInputs& out,
                            const std::optional<gl::Rect>& part) {
  assert(isFromDepth(source));
  if (!programs_.contains(source)) programs_.emplace(source, compileCameraMotion(source));
  const gl::Framebuffer target({{&out.motion}, {&out.previousDepth}}, nullptr, "camera motion");
  gl::RenderPass pass(target, {.scissor = part}, "CameraMotionPass");
  pass.program(programs_.at(source));
  pass.uniformBlock(2, frame);
  pass.texture(0, out.depth, nearest_);
  pass.drawFullscreen();
}

} // namespace taa
