// Makes motion, depth and color of a frame faulty (manual, faults): the planes are replaced by themselves
// with what is wrong.
#pragma once

#include "core/gl/Buffer.h"
#include "core/gl/Program.h"
#include "core/gl/RenderPass.h"
#include "core/gl/Texture.h"
#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <map>
#include <string>
#include <utility>

namespace taa {

/// Jitter that two frames are drawn with, px.
struct DrawnJitter {
  glm::vec2 now{0.0f}, last{0.0f};
};

/// Whether it has anything to do with motion, depth or color.
bool changesMotion(const FaultSettings& faults);
bool changesDepth(const FaultSettings& faults);
bool changesColor(const FaultSettings& faults);

/// One frame at a time: begin(), then what of the rest is wanted, depth last, because regions are found by
/// it.
class FaultPass {
 public:
  FaultPass();
  /// Reads what of the frame has no faults: `inputs.block` as its source filled it.
  void begin(const FaultSettings& faults, const FrameInputs& inputs, const DrawnJitter& jitter);
  /// Adds the motion of an earlier frame where this frame's leads.
  void follow(const gl::Texture& older, FrameInputs& out);
  /// Motion, made of `from` in place of the frame's own.
  void drawMotion(const gl::Texture& from, FrameInputs& out);
  /// Color, with the sky of another picture of the frame; of `out` itself: with its own.
  void drawColor(const FrameInputs& sky, FrameInputs& out);
  void drawDepth(FrameInputs& out);
  /// One with the programs of this one, compiled again.
  FaultPass reloaded() const;

 private:
  /// A file below shaders/scene/faults, and its constant.
  using Variant = std::pair<std::string, std::string>;
  const gl::Program& program(const std::string& file, const std::string& prelude = "");
  void draw(const gl::Program& with, const gl::Framebuffer& target, const FrameInputs& regions,
            const gl::Texture& plane, const gl::Texture& other, const gl::Texture& otherDepth);

  std::map<Variant, gl::Program> programs_; ///< made when they are first asked for
  FaultSettings faults_;
  gl::Texture motion_, depth_, previousDepth_, color_; ///< what is drawn into, then exchanged
  gl::Buffer frame_, fault_;
  gl::Sampler nearest_;
};

} // namespace taa
