#include "core/render/faults/FaultPass.h"

#include "shaders/shared/FaultBlock.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace taa {

namespace {

constexpr unsigned kFrameBinding = 2, kFaultBinding = 8;
constexpr float kEyeDistance = 0.5f; // m, from a view to the second one

/// Unjittered, of the camera that is taken for the previous one.
glm::mat4 wrongPrevious(const FaultSettings& faults, const shared::FrameBlock& block) {
  const glm::dmat4 clipFromView =
      glm::dmat4(block.clipFromWorld) * glm::inverse(glm::dmat4(block.viewFromWorld));
  const glm::dmat4 view(block.previousViewFromWorld);
  const glm::dmat4 one(1.0);
  switch (faults.previousCamera) {
  case CameraFault::None:
  case CameraFault::Twice: // the previous one is right
    break;
  case CameraFault::OfNow:
    return block.clipFromWorld;
  case CameraFault::Turned:
    return glm::mat4(
        clipFromView *
        glm::rotate(one, glm::radians(static_cast<double>(faults.cameraTurn)), glm::dvec3(0.0, 1.0, 0.0)) *
        view);
  case CameraFault::Mirrored:
    return glm::mat4(clipFromView * view * glm::scale(one, glm::dvec3(1.0, -1.0, 1.0)));
  case CameraFault::SecondView:
    return glm::mat4(clipFromView * glm::translate(one, glm::dvec3(-kEyeDistance, 0.0, 0.0)) * view);
  case CameraFault::Identity:
    return glm::mat4(1.0f);
  }
  return block.previousClipFromWorld;
}

glm::vec2 jitterShares(MotionJitterFault fault) {
  switch (fault) {
  case MotionJitterFault::None:
    break;
  case MotionJitterFault::This:
    return {1.0f, 0.0f};
  case MotionJitterFault::Last:
    return {0.0f, 1.0f};
  case MotionJitterFault::Both:
    return {1.0f, 1.0f};
  case MotionJitterFault::ThisOff:
    return {-1.0f, 0.0f};
  case MotionJitterFault::LastOff:
    return {0.0f, -1.0f};
  case MotionJitterFault::BothOff:
    return {-1.0f, -1.0f};
  }
  return glm::vec2(0.0f);
}

glm::vec4 rectanglePx(const FaultSettings& faults, const glm::vec2& sizePx) {
  return {faults.left * sizePx.x, faults.top * sizePx.y, faults.right * sizePx.x, faults.bottom * sizePx.y};
}

/// The texel that is NaN in the frame; negative: none.
glm::ivec2 nanTexel(const FaultSettings& faults, const FrameInputs& inputs) {
  if (!isOn(faults.nan) || inputs.info.frame != faults.firstFrame) return glm::ivec2(-1);
  const glm::vec4 px = rectanglePx(faults, {inputs.width(), inputs.height()});
  const glm::ivec2 middle(glm::floor(0.5f * (glm::vec2(px) + glm::vec2(px.z, px.w))));
  return glm::clamp(middle, glm::ivec2(0), glm::ivec2(inputs.width() - 1, inputs.height() - 1));
}

shared::FaultBlock faultBlock(const FaultSettings& faults, const FrameInputs& inputs,
                              const DrawnJitter& jitter) {
  shared::FaultBlock block{};
  block.wrongPreviousClipFromWorld = wrongPrevious(faults, inputs.block);
  block.jitter = glm::vec4(jitter.now, jitter.last);
  block.motionTerms = glm::vec4(faults.motionX, faults.motionY, jitterShares(faults.motionJitter));
  block.motionForm = {static_cast<int>(faults.motion), static_cast<int>(faults.motionUnit),
                      isOn(faults.motionSwapped) ? 1 : 0, isOn(faults.zeroIsMissing) ? 1 : 0};
  block.texels = {faults.motionShift, faults.motionCoarse, faults.depthCoarse,
                  faults.previousCamera == CameraFault::Twice ? 1 : 0};
  block.place = glm::ivec4(static_cast<int>(faults.region), faults.object, nanTexel(faults, inputs));
  block.rectangle = rectanglePx(faults, {inputs.width(), inputs.height()});
  block.colorTerms = {std::exp2(faults.exposure), static_cast<float>(faults.interface), faults.nearPlane,
                      static_cast<float>(faults.depth)};
  return block;
}

std::string faultFlag(const char* name, bool value) {
  return std::string("const bool ") + name + " = " + (value ? "true" : "false") + ";\n";
}

gl::Program compileFault(const std::string& file, const std::string& prelude) {
  return {gl::ShaderSource("include/fullscreen.vert"), gl::ShaderSource("scene/faults/" + file, prelude),
          "FaultPass"};
}

glm::ivec2 texturePx(const gl::Texture& texture) {
  return {texture.width(), texture.height()};
}

} // namespace

bool changesMotion(const FaultSettings& faults) {
  const FaultSettings none;
  return faults.motion != none.motion || faults.previousCamera != none.previousCamera ||
         faults.previousAge > 1 || faults.motionLag != 0 || faults.motionJitter != none.motionJitter ||
         isOn(faults.motionSwapped) || faults.motionX != 1.0f || faults.motionY != 1.0f ||
         faults.motionUnit != none.motionUnit || isOn(faults.zeroIsMissing) || faults.motionShift != 0 ||
         faults.motionCoarse > 1 || isOn(faults.motionUntested);
}

bool changesDepth(const FaultSettings& faults) {
  return faults.depth != DepthFault::None || faults.nearPlane != 1.0f || faults.depthCoarse > 1;
}

bool changesColor(const FaultSettings& faults) {
  return faults.exposure != 0.0f || faults.interface != InterfaceFault::None || isOn(faults.nan) ||
         faults.skyJitter != 1.0f;
}

FaultPass::FaultPass()
    : frame_(sizeof(shared::FrameBlock), nullptr, "frame"),
      fault_(sizeof(shared::FaultBlock), nullptr, "fault"), nearest_(gl::SamplerState{}) {}

FaultPass FaultPass::reloaded() const {
  FaultPass pass;
  for (const auto& [variant, old] : programs_)
    pass.programs_.emplace(variant, compileFault(variant.first, variant.second));
  return pass;
}

const gl::Program& FaultPass::program(const std::string& file, const std::string& prelude) {
  const Variant variant{file, prelude};
  if (!programs_.contains(variant)) programs_.emplace(variant, compileFault(file, prelude));
  return programs_.at(variant);
}

void FaultPass::begin(const FaultSettings& faults, const FrameInputs& inputs, const DrawnJitter& jitter) {
  faults_ = faults;
  const shared::FaultBlock block = faultBlock(faults, inputs, jitter);
  frame_.update(0, &inputs.block, sizeof(inputs.block));
  fault_.update(0, &block, sizeof(block));
}

void FaultPass::draw(const gl::Program& with, const gl::Framebuffer& target, const FrameInputs& regions,
                     const gl::Texture& plane, const gl::Texture& other, const gl::Texture& otherDepth) {
  gl::RenderPass pass(target, {.depthWrite = true, .scissor = {}}, "FaultPass"); // where there is depth
  pass.program(with);
  pass.uniformBlock(kFrameBinding, frame_);
  pass.uniformBlock(kFaultBinding, fault_);
  pass.texture(0, plane, nearest_);
  pass.texture(1, regions.depth, nearest_);
  pass.texture(2, regions.normal, nearest_);
  pass.texture(3, regions.objectId, nearest_);
  pass.texture(4, other, nearest_);
  pass.texture(5, otherDepth, nearest_);
  pass.drawFullscreen();
}

void FaultPass::follow(const gl::Texture& older, FrameInputs& out) {
  fitTexture(motion_, texturePx(out.motion), out.motion.format(), "motion");
  draw(program("follow_motion.frag"), gl::Framebuffer({{&motion_}}, nullptr, "older transforms"), out,
       out.motion, older, out.depth);
  std::swap(out.motion, motion_);
}

void FaultPass::drawMotion(const gl::Texture& from, FrameInputs& out) {
  fitTexture(motion_, texturePx(out.motion), out.motion.format(), "motion");
  const bool isWrong = faults_.previousCamera != CameraFault::None;
  draw(program("faulty_motion.frag", faultFlag("kWrongCamera", isWrong)),
       gl::Framebuffer({{&motion_}}, nullptr, "faulty motion"), out, out.motion, from, out.depth);
  std::swap(out.motion, motion_);
}

void FaultPass::drawColor(const FrameInputs& sky, FrameInputs& out) {
  fitTexture(color_, texturePx(out.color), out.color.format(), "color");
  draw(program("faulty_color.frag", faultFlag("kSkyAlone", faults_.skyJitter != 1.0f)),
       gl::Framebuffer({{&color_}}, nullptr, "faulty color"), out, out.color, sky.color, sky.depth);
  std::swap(out.color, color_);
}

void FaultPass::drawDepth(FrameInputs& out) {
  fitTexture(depth_, texturePx(out.depth), out.depth.format(), "depth");
  fitTexture(previousDepth_, texturePx(out.previousDepth), out.previousDepth.format(), "previous depth");
  const gl::Framebuffer target({{&previousDepth_}}, &depth_, "faulty depth");
  draw(program("faulty_depth.frag"), target, out, out.previousDepth, out.previousDepth, out.depth);
  std::swap(out.depth, depth_);
  std::swap(out.previousDepth, previousDepth_);
}

} // namespace taa
