// How each kind of GL object is freed, asked for and named.
#include "core/gl/Handle.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

namespace taa::gl {

namespace {

GLenum identifierOf(ObjectKind kind) {
  switch (kind) {
  case ObjectKind::Buffer:
    return GL_BUFFER;
  case ObjectKind::Framebuffer:
    return GL_FRAMEBUFFER;
  case ObjectKind::Program:
    return GL_PROGRAM;
  case ObjectKind::ProgramPipeline:
    return GL_PROGRAM_PIPELINE;
  case ObjectKind::Sampler:
    return GL_SAMPLER;
  case ObjectKind::Shader:
    return GL_SHADER;
  case ObjectKind::Texture:
    return GL_TEXTURE;
  case ObjectKind::VertexArray:
    return GL_VERTEX_ARRAY;
  }
  return GL_NONE;
}

} // namespace

void destroyObject(ObjectKind kind, unsigned id) noexcept {
  if (id == 0) return;
  switch (kind) {
  case ObjectKind::Buffer:
    glDeleteBuffers(1, &id);
    return;
  case ObjectKind::Framebuffer:
    glDeleteFramebuffers(1, &id);
    return;
  case ObjectKind::Program:
    glDeleteProgram(id);
    return;
  case ObjectKind::ProgramPipeline:
    glDeleteProgramPipelines(1, &id);
    return;
  case ObjectKind::Sampler:
    glDeleteSamplers(1, &id);
    return;
  case ObjectKind::Shader:
    glDeleteShader(id);
    return;
  case ObjectKind::Texture:
    glDeleteTextures(1, &id);
    return;
  case ObjectKind::VertexArray:
    glDeleteVertexArrays(1, &id);
    return;
  }
}

bool isObject(ObjectKind kind, unsigned id) {
  switch (kind) {
  case ObjectKind::Buffer:
    return glIsBuffer(id);
  case ObjectKind::Framebuffer:
    return glIsFramebuffer(id);
  case ObjectKind::Program:
    return glIsProgram(id);
  case ObjectKind::ProgramPipeline:
    return glIsProgramPipeline(id);
  case ObjectKind::Sampler:
    return glIsSampler(id);
  case ObjectKind::Shader:
    return glIsShader(id);
  case ObjectKind::Texture:
    return glIsTexture(id);
  case ObjectKind::VertexArray:
    return glIsVertexArray(id);
  }
  return false;
}

void labelObject(ObjectKind kind, unsigned id, const std::string& label) {
  constexpr std::size_t kMaxBytes = 255; // GL_MAX_LABEL_LENGTH, which labels are shorter than, is 256 or more
  glObjectLabel(identifierOf(kind), id, static_cast<GLsizei>(std::min(label.size(), kMaxBytes)),
                label.data());
}

} // namespace taa::gl
