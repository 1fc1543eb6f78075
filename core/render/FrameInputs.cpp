#include "core/render/FrameInputs.h"

#include "core/render/FogCones.h"
#include "core/render/FrameRequest.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace taa {

namespace {

/// One of the textures as settings ask for it.
struct InputTexture {
  gl::Texture FrameInputs::*texture;
  gl::Format format;
  const char* label;
  bool isNeeded = true;
};

std::array<InputTexture, 9> inputTextures(const InputSettings& settings) {
  const bool isHalf = settings.precision == Precision::Half;
  return {{{&FrameInputs::color, colorFormat(settings), "color"},
           {&FrameInputs::motion, isHalf ? gl::Format::RG16F : gl::Format::RG32F, "motion"},
           {&FrameInputs::normal, gl::Format::RGBA16F, "normal"},
           {&FrameInputs::objectId, gl::Format::R32UI, "object id"},
           {&FrameInputs::previousDepth, gl::Format::R32F, "previous depth"},
           {&FrameInputs::depth, gl::Format::Depth32F, "depth"},
           {&FrameInputs::mask, gl::Format::RG8, "mask", settings.mask != MaskSource::None},
           {&FrameInputs::overlay, gl::Format::RGBA16F, "overlay", settings.blended == BlendedAs::After},
           {&FrameInputs::forwardCount, gl::Format::R32F, "forward count", isOn(settings.forward)}}};
}

} // namespace

glm::ivec2 drawnSize(const glm::ivec2& picturePx, float renderScale) {
  // A thousandth is let go: r is a float, and 0.67 of 100 shall be 67.
  const auto scaled = [r = static_cast<double>(renderScale)](int side) {
    return static_cast<int>(std::ceil(r * side - 1e-3));
  };
  return {scaled(picturePx.x), scaled(picturePx.y)};
}

gl::Format colorFormat(const InputSettings& settings) {
  return settings.precision == Precision::Half ? gl::Format::RGBA16F : gl::Format::RGBA32F;
}

void fitTexture(gl::Texture& texture, const glm::ivec2& sizePx, gl::Format format, const char* label) {
  const gl::TextureSize size{sizePx.x, sizePx.y};
  if (texture && texture.size() == size && texture.format() == format) return;
  texture = gl::Texture();
  texture = gl::Texture(size, format, label);
}

void fitInputs(const InputSettings& settings, const glm::ivec2& drawnPx, const glm::ivec2& picturePx,
               FrameInputs& out) {
  out.outputPx = picturePx;
  for (const InputTexture& row : inputTextures(settings))
    if (row.isNeeded)
      fitTexture(out.*row.texture, drawnPx, row.format, row.label);
    else
      out.*row.texture = gl::Texture();
}

void fitInputs(const FrameRequest& request, FrameInputs& out) {
  const glm::ivec2 picturePx{request.width, request.height};
  fitInputs(request.inputs, drawnSize(picturePx, request.inputs.renderScale), picturePx, out);
}

std::size_t inputBytes(const InputSettings& settings, const glm::ivec2& picturePx, const Scene* scene) {
  const glm::ivec2 size = drawnSize(picturePx, settings.renderScale);
  std::size_t sum = 0;
  for (const InputTexture& row : inputTextures(settings))
    if (row.isNeeded) sum += gl::textureBytes({size.x, size.y}, row.format);
  if (scene && drawsFog(*scene, settings)) sum += gl::textureBytes({size.x, size.y}, colorFormat(settings));
  return sum;
}

} // namespace taa
