#include "core/gl/RenderPass.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/gl/PassTimer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

namespace taa::gl {

namespace {

GLenum storeFormat(Format format) {
  switch (format) {
  case Format::R32F:
    return GL_R32F;
  case Format::RG32F:
    return GL_RG32F;
  case Format::RGBA32F:
    return GL_RGBA32F;
  case Format::RGBA16F:
    return GL_RGBA16F;
  case Format::R32UI:
    return GL_R32UI;
  default:
    assert(false);
    return GL_NONE;
  }
}

// Passes without attributes still need a vertex array in core profiles; one for each context, found by being
// bound to nothing else.
Handle<ObjectKind::VertexArray> emptyVertexArray() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  return Handle<ObjectKind::VertexArray>(id);
}

GLenum primitiveMode(PrimitiveKind kind) {
  static constexpr GLenum kModes[] = {GL_TRIANGLES, GL_LINES, GL_POINTS};
  return kModes[static_cast<int>(kind)];
}

void setScissor(const std::optional<Rect>& part) {
  if (!part) {
    glDisable(GL_SCISSOR_TEST);
    return;
  }
  glEnable(GL_SCISSOR_TEST);
  glScissor(part->x, part->y, part->width, part->height);
}

Handle<ObjectKind::Framebuffer> newFramebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  return Handle<ObjectKind::Framebuffer>(id);
}

} // namespace

Framebuffer::Framebuffer(const std::vector<Attachment>& colors, const Texture* depth,
                         const std::string& label)
    : id_(newFramebuffer()) {
  std::vector<GLenum> buffers;
  for (const Attachment& color : colors) {
    if (!color.texture) {
      buffers.push_back(GL_NONE);
      continue;
    }
    const auto point = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + buffers.size());
    if (color.texture->size().layers > 0)
      glNamedFramebufferTextureLayer(id_, point, color.texture->id(), 0, color.layer);
    else
      glNamedFramebufferTexture(id_, point, color.texture->id(), 0);
    buffers.push_back(point);
  }
  if (depth) glNamedFramebufferTexture(id_, GL_DEPTH_ATTACHMENT, depth->id(), 0);
  glNamedFramebufferDrawBuffers(id_, static_cast<GLsizei>(buffers.size()), buffers.data());
  const auto attached = std::ranges::find_if(colors, [](const Attachment& color) { return color.texture; });
  assert(attached != colors.end() || depth);
  const Texture& first = attached == colors.end() ? *depth : *attached->texture;
  width_ = first.width();
  height_ = first.height();
  labelObject(ObjectKind::Framebuffer, id_, label);
  const GLenum status = glCheckNamedFramebufferStatus(id_, GL_DRAW_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw Error(say<"cannot draw into %1: GL reports framebuffer status %2">(label, status));
}

Framebuffer::Framebuffer(int width, int height, const std::string& label)
    : id_(newFramebuffer()), width_(width), height_(height) {
  glNamedFramebufferParameteri(id_, GL_FRAMEBUFFER_DEFAULT_WIDTH, width);
  glNamedFramebufferParameteri(id_, GL_FRAMEBUFFER_DEFAULT_HEIGHT, height);
  labelObject(ObjectKind::Framebuffer, id_, label);
}

void Framebuffer::clearColor(int index, const glm::vec4& value, const std::optional<Rect>& part) {
  setScissor(part);
  glClearNamedFramebufferfv(id_, GL_COLOR, index, &value.x);
}

void Framebuffer::clearColorUint(int index, std::uint32_t value) {
  glDisable(GL_SCISSOR_TEST);
  const GLuint values[4] = {value, 0, 0, 0};
  glClearNamedFramebufferuiv(id_, GL_COLOR, index, values);
}

void Framebuffer::clearDepth(float value, const std::optional<Rect>& part) {
  setScissor(part);
  glDepthMask(GL_TRUE);
  glClearNamedFramebufferfv(id_, GL_DEPTH, 0, &value);
}

RenderPass::RenderPass(const Framebuffer& target, const RenderState& state, const std::string& label) {
  PassTimer::begin(label);
  glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, label.c_str());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.id());
  glViewport(0, 0, target.width(), target.height());
  setScissor(state.scissor);
  // Depth writes need the depth test enabled.
  if (state.depthTest || state.depthWrite) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(state.depthTest ? GL_GEQUAL : GL_ALWAYS);
  } else {
    glDisable(GL_DEPTH_TEST);
  }
  glDepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
}

RenderPass::~RenderPass() {
  glPopDebugGroup();
  PassTimer::end();
}

void RenderPass::program(const Program& program) {
  program.use();
}

void RenderPass::texture(unsigned unit, const Texture& texture, const Sampler& sampler) {
  glBindTextureUnit(unit, texture.id());
  glBindSampler(unit, sampler.id());
}

void RenderPass::image(unsigned unit, const Texture& texture) {
  glBindImageTexture(unit, texture.id(), 0, texture.size().layers > 0 ? GL_TRUE : GL_FALSE, 0, GL_WRITE_ONLY,
                     storeFormat(texture.format()));
}

void RenderPass::uniformBlock(unsigned binding, const Buffer& buffer, std::size_t offset, std::size_t bytes) {
  assert(offset % uniformAlignment() == 0);
  glBindBufferRange(GL_UNIFORM_BUFFER, binding, buffer.id(), static_cast<GLintptr>(offset),
                    static_cast<GLsizeiptr>(bytes ? bytes : buffer.bytes() - offset));
}

void RenderPass::storageBlock(unsigned binding, const Buffer& buffer) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.id());
}

void RenderPass::storageBlock(unsigned binding, const Buffer& buffer, std::size_t offset, std::size_t bytes) {
  assert(offset % storageAlignment() == 0 && offset + bytes <= buffer.bytes());
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, buffer.id(), static_cast<GLintptr>(offset),
                    static_cast<GLsizeiptr>(bytes));
}

void RenderPass::culling(bool enabled, bool mirrored) {
  glFrontFace(mirrored ? GL_CW : GL_CCW); // gl_FrontFacing needs it too
  if (!enabled) {
    glDisable(GL_CULL_FACE);
    return;
  }
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
}

void RenderPass::blending(unsigned attachment, Blending blending) {
  if (blending == Blending::Replace) {
    glDisablei(GL_BLEND, attachment);
    return;
  }
  glEnablei(GL_BLEND, attachment);
  glBlendEquationi(attachment, blending == Blending::Largest ? GL_MAX : GL_FUNC_ADD);
  glBlendFunci(attachment, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void RenderPass::drawFullscreen() {
  const Handle<ObjectKind::VertexArray> empty = emptyVertexArray();
  glBindVertexArray(empty);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void RenderPass::draw(const VertexMesh& mesh, int instances) {
  glBindVertexArray(mesh.vertexArray());
  glDrawElementsInstanced(primitiveMode(mesh.kind()), mesh.indexCount(), GL_UNSIGNED_INT, nullptr, instances);
}

void RenderPass::draw(const VertexMesh& mesh, const Buffer& indices, std::size_t first, std::size_t count) {
  assert((first + count) * sizeof(std::uint32_t) <= indices.bytes());
  glVertexArrayElementBuffer(mesh.vertexArray(), indices.id());
  glBindVertexArray(mesh.vertexArray());
  glDrawElements(primitiveMode(mesh.kind()), static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                 std::bit_cast<const void*>(first * sizeof(std::uint32_t)));
  glVertexArrayElementBuffer(mesh.vertexArray(), mesh.indices().id());
}

void copyColor(const Framebuffer& from, const Framebuffer& to) {
  assert(from.width() == to.width() && from.height() == to.height());
  glDisable(GL_SCISSOR_TEST);
  glBlitNamedFramebuffer(from.id(), to.id(), 0, 0, from.width(), from.height(), 0, 0, to.width(), to.height(),
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void imageBarrier() {
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                  GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

std::size_t uniformAlignment() {
  GLint alignment = 256;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  return static_cast<std::size_t>(alignment);
}

std::size_t storageAlignment() {
  GLint alignment = 256;
  glGetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &alignment);
  return static_cast<std::size_t>(alignment);
}

} // namespace taa::gl
