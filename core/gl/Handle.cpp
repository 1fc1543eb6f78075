// How each kind of GL object is freed and asked for.
#include "core/gl/Handle.h"

#include <epoxy/gl.h>

namespace taa::gl {

void destroyObject(ObjectKind kind, unsigned id) noexcept {
  if (id == 0) return;
  switch (kind) {
  case ObjectKind::Buffer:
    return glDeleteBuffers(1, &id);
  case ObjectKind::Framebuffer:
    return glDeleteFramebuffers(1, &id);
  case ObjectKind::Program:
    return glDeleteProgram(id);
  case ObjectKind::ProgramPipeline:
    return glDeleteProgramPipelines(1, &id);
  case ObjectKind::Sampler:
    return glDeleteSamplers(1, &id);
  case ObjectKind::Shader:
    return glDeleteShader(id);
  case ObjectKind::Texture:
    return glDeleteTextures(1, &id);
  case ObjectKind::VertexArray:
    return glDeleteVertexArrays(1, &id);
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

} // namespace taa::gl
