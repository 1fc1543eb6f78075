// Drawing into textures: a framebuffer, and a pass that is the only place where draw state is set.
#pragma once

#include "core/gl/Buffer.h"
#include "core/gl/Handle.h"
#include "core/gl/Program.h"
#include "core/gl/Texture.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace taa::gl {

struct Attachment {
  const Texture* texture = nullptr; ///< null: what is written there is dropped
  int layer = 0;                    ///< of a 2D array; 0 for a plain texture
};

/// Color targets in order, and perhaps depth. Does not own the textures; they must outlive it.
class Framebuffer {
 public:
  Framebuffer() = default;
  Framebuffer(const std::vector<Attachment>& colors, const Texture* depth, const std::string& label);
  /// No attachments: for passes that write by image stores only.
  Framebuffer(int width, int height, const std::string& label);
  /// `part`: what is cleared; default: all.
  void clearColor(int index, const glm::vec4& value, const std::optional<Rect>& part = {});
  void clearColorUint(int index, std::uint32_t value);
  void clearDepth(float value, const std::optional<Rect>& part = {});
  unsigned id() const { return id_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  Handle<ObjectKind::Framebuffer> id_;
  ResetOnMove<int> width_, height_;
};

struct RenderState {
  bool depthTest = false; ///< passes where the new depth ≥ the old one (reversed depth)
  bool depthWrite = false;
  std::optional<Rect> scissor; ///< default: the whole framebuffer
};

/// What becomes of the color that is there.
enum class Blending : std::uint8_t {
  Replace,
  Over,   ///< c new + (1 − α new)·c old: the new color is premultiplied
  Largest ///< the larger one, channel by channel
};

/// State and draws of one pass, in a debug group with its label. One at a time.
class RenderPass {
 public:
  RenderPass(const Framebuffer& target, const RenderState& state, const std::string& label);
  ~RenderPass();
  RenderPass(const RenderPass&) = delete;
  RenderPass& operator=(const RenderPass&) = delete;

  void program(const Program& program);
  void texture(unsigned unit, const Texture& texture, const Sampler& sampler);
  /// All layers, for imageStore.
  void image(unsigned unit, const Texture& texture);
  /// `bytes` 0: the whole buffer. `offset` is a multiple of uniformAlignment().
  void uniformBlock(unsigned binding, const Buffer& buffer, std::size_t offset = 0, std::size_t bytes = 0);
  void storageBlock(unsigned binding, const Buffer& buffer);
  /// A part of it; `offset` is a multiple of storageAlignment().
  void storageBlock(unsigned binding, const Buffer& buffer, std::size_t offset, std::size_t bytes);
  /// Whether back faces are culled; a mirrored transform turns which ones those are, in gl_FrontFacing too.
  void culling(bool enabled, bool mirrored = false);
  /// Replace until something else is said.
  void blending(unsigned attachment, Blending blending);
  void drawFullscreen(); ///< one triangle that covers the target; no attributes
  void draw(const VertexMesh& mesh, int instances = 1);
  /// With `count` other indices than its own: of 32 bits, those in `indices` from number `first` on.
  void draw(const VertexMesh& mesh, const Buffer& indices, std::size_t first, std::size_t count);
};

/// Texels of the first color target of `from` into that of `to`, which has the same size: numbers stay what
/// they are as far as its format holds them, channels that it has not are dropped.
void copyColor(const Framebuffer& from, const Framebuffer& to);

/// Makes image stores of earlier passes visible to texture fetches and downloads.
void imageBarrier();

/// What uniformBlock's offset must be a multiple of, bytes.
std::size_t uniformAlignment();
/// The same of storageBlock.
std::size_t storageAlignment();

} // namespace taa::gl
