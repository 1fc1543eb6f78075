#include "core/gl/Texture.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/gl/Context.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <vector>

namespace taa::gl {

namespace {

struct FormatInfo {
  GLenum internalFormat, transfer, type;
  int channels;
  std::size_t bytes;
};

FormatInfo info(Format format) {
  switch (format) {
  case Format::RGBA8:
    return {GL_RGBA8, GL_RGBA, GL_FLOAT, 4, 4};
  case Format::SRGBA8:
    return {GL_SRGB8_ALPHA8, GL_RGBA, GL_FLOAT, 4, 4};
  case Format::RG8:
    return {GL_RG8, GL_RG, GL_FLOAT, 2, 2};
  case Format::R16F:
    return {GL_R16F, GL_RED, GL_FLOAT, 1, 2};
  case Format::RG16F:
    return {GL_RG16F, GL_RG, GL_FLOAT, 2, 4};
  case Format::RGBA16F:
    return {GL_RGBA16F, GL_RGBA, GL_FLOAT, 4, 8};
  case Format::R32F:
    return {GL_R32F, GL_RED, GL_FLOAT, 1, 4};
  case Format::RG32F:
    return {GL_RG32F, GL_RG, GL_FLOAT, 2, 8};
  case Format::RGBA32F:
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 4, 16};
  case Format::R32UI:
    return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1, 4};
  case Format::Depth32F:
    return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 4};
  }
  assert(false);
  return {};
}

GLint wrapMode(TextureWrap wrap) {
  switch (wrap) {
  case TextureWrap::ClampToEdge:
    return GL_CLAMP_TO_EDGE;
  case TextureWrap::Repeat:
    return GL_REPEAT;
  case TextureWrap::MirroredRepeat:
    return GL_MIRRORED_REPEAT;
  }
  return GL_CLAMP_TO_EDGE;
}

GLint minifyFilter(const SamplerState& state) {
  if (!state.mipmapped) return state.minifyLinear ? GL_LINEAR : GL_NEAREST;
  if (state.minifyLinear) return state.mipmapLinear ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_NEAREST;
  return state.mipmapLinear ? GL_NEAREST_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST;
}

int levelCount(const TextureSize& size) {
  return size.levels > 0 ? size.levels
                         : std::bit_width(static_cast<unsigned>(std::max(size.width, size.height)));
}

} // namespace

int channels(Format format) {
  return info(format).channels;
}
bool isHalf(Format format) {
  return format == Format::R16F || format == Format::RG16F || format == Format::RGBA16F;
}
std::size_t bytesPerTexel(Format format) {
  return info(format).bytes;
}

std::size_t textureBytes(const TextureSize& size, Format format) {
  std::size_t texels = 0;
  for (int level = 0; level < levelCount(size); ++level)
    texels += static_cast<std::size_t>(std::max(1, size.width >> level)) *
              static_cast<std::size_t>(std::max(1, size.height >> level));
  return bytesPerTexel(format) * texels * static_cast<std::size_t>(std::max(1, size.layers));
}

Texture::Texture(const TextureSize& size, Format format, const std::string& label)
    : size_({size.width, size.height, size.layers, levelCount(size)}), format_(format) {
  assert(size.width > 0 && size.height > 0);
  const std::string texels = std::to_string(size.width) + " x " + std::to_string(size.height) +
                             (size.layers > 0 ? " x " + std::to_string(size.layers) : "");
  const std::string what =
      say<"cannot allocate %1 of %2 texels (%3 MiB)">(label, texels, textureBytes(size_, format) >> 20);
  allocation_ = Allocation(StorageKind::Texture, label, textureBytes(size_, format), what);
  GLuint id = 0;
  glCreateTextures(size.layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &id);
  id_ = Handle<ObjectKind::Texture>(id);
  const GLenum internalFormat = info(format).internalFormat;
  if (size.layers > 0)
    glTextureStorage3D(id_, size_->levels, internalFormat, size.width, size.height, size.layers);
  else
    glTextureStorage2D(id_, size_->levels, internalFormat, size.width, size.height);
  labelObject(ObjectKind::Texture, id_, label);
  checkAllocated(label, what);
}

std::size_t Texture::bytes() const {
  return id_ ? textureBytes(size_, format_) : 0;
}

void Texture::upload(const Image& image, int layer) {
  const FormatInfo format = info(format_);
  assert(image.width == width() && image.height == height() && image.channels == format.channels);
  std::vector<std::uint32_t> integers;
  const void* data = image.pixels.data();
  if (format.type == GL_UNSIGNED_INT) {
    for (float value : image.pixels) integers.push_back(static_cast<std::uint32_t>(value));
    data = integers.data();
  }
  if (size_->layers > 0)
    glTextureSubImage3D(id_, 0, 0, 0, layer, width(), height(), 1, format.transfer, format.type, data);
  else
    glTextureSubImage2D(id_, 0, 0, 0, width(), height(), format.transfer, format.type, data);
}

void Texture::uploadHalves(std::span<const std::uint16_t> halves) {
  assert(isHalf(format_) && halves.size_bytes() == textureBytes({width(), height()}, format_));
  assert(size_->layers == 0);
  // Rows of one channel need not be multiples of the four bytes that GL expects at first.
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  glTextureSubImage2D(id_, 0, 0, 0, width(), height(), info(format_).transfer, GL_HALF_FLOAT, halves.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void Texture::uploadIntegers(std::span<const std::uint32_t> integers) {
  assert(format_ == Format::R32UI && integers.size_bytes() == textureBytes({width(), height()}, format_));
  assert(size_->layers == 0);
  glTextureSubImage2D(id_, 0, 0, 0, width(), height(), GL_RED_INTEGER, GL_UNSIGNED_INT, integers.data());
}

void Texture::uploadBytes(std::span<const std::uint8_t> bytes) {
  assert(format_ == Format::RGBA8 || format_ == Format::SRGBA8);
  assert(bytes.size() == textureBytes({width(), height()}, format_) && size_->layers == 0);
  glTextureSubImage2D(id_, 0, 0, 0, width(), height(), GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
}

void Texture::generateMipmaps() {
  glGenerateTextureMipmap(id_);
}

void Texture::copyFrom(const Texture& source) {
  assert(size() == source.size() && format_ == source.format() && size_->layers == 0);
  glCopyImageSubData(source.id(), GL_TEXTURE_2D, 0, 0, 0, 0, id_, GL_TEXTURE_2D, 0, 0, 0, 0, width(),
                     height(), 1);
}

void Texture::clear(float r, float g, float b, float a) {
  const FormatInfo format = info(format_);
  const float values[4] = {r, g, b, a};
  const auto integer = static_cast<std::uint32_t>(r);
  glClearTexImage(id_, 0, format.transfer, format.type,
                  format.type == GL_UNSIGNED_INT ? static_cast<const void*>(&integer) : values);
}

Image Texture::download(const Rect& rect, int layer) const {
  const FormatInfo format = info(format_);
  Image image(rect.width, rect.height, format.channels);
  const auto bytes = static_cast<GLsizei>(image.pixels.size() * sizeof(float));
  glGetTextureSubImage(id_, 0, rect.x, rect.y, layer, rect.width, rect.height, 1, format.transfer,
                       format.type, bytes, image.pixels.data());
  if (format.type == GL_UNSIGNED_INT)
    for (float& value : image.pixels) value = static_cast<float>(std::bit_cast<std::uint32_t>(value));
  return image;
}

std::vector<std::uint32_t> Texture::downloadIntegers() const {
  assert(format_ == Format::R32UI && size_->layers == 0);
  std::vector<std::uint32_t> integers(static_cast<std::size_t>(width()) * height());
  const auto bytes = static_cast<GLsizei>(integers.size() * sizeof(std::uint32_t));
  glGetTextureImage(id_, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, bytes, integers.data());
  return integers;
}

void Texture::downloadBytes(std::span<std::uint8_t> bytes) const {
  assert(format_ == Format::RGBA8 && bytes.size() == textureBytes({width(), height()}, format_) &&
         size_->layers == 0);
  glGetTextureImage(id_, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes.size()), bytes.data());
}

Sampler::Sampler(const SamplerState& state) {
  GLuint id = 0;
  glCreateSamplers(1, &id);
  id_ = Handle<ObjectKind::Sampler>(id);
  glSamplerParameteri(id_, GL_TEXTURE_MAG_FILTER, state.magnifyLinear ? GL_LINEAR : GL_NEAREST);
  glSamplerParameteri(id_, GL_TEXTURE_MIN_FILTER, minifyFilter(state));
  glSamplerParameteri(id_, GL_TEXTURE_WRAP_S, wrapMode(state.wrapU));
  glSamplerParameteri(id_, GL_TEXTURE_WRAP_T, wrapMode(state.wrapV));
  glSamplerParameterf(id_, GL_TEXTURE_LOD_BIAS, state.lodBias);
  if (state.anisotropy > 1.0f && epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic"))
    glSamplerParameterf(id_, GL_TEXTURE_MAX_ANISOTROPY, state.anisotropy);
}

} // namespace taa::gl
