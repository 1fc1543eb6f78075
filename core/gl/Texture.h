// Immutable-size GL textures and samplers, owned by value (move-only, see Handle.h).
#pragma once

#include "core/base/Image.h"
#include "core/gl/Handle.h"
#include "core/gl/Memory.h"
#include "core/gl/Rect.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace taa::gl {

enum class Format : std::uint8_t {
  RGBA8,
  SRGBA8,
  RG8,
  R16F,
  RG16F,
  RGBA16F,
  R32F,
  RG32F,
  RGBA32F,
  R32UI,
  Depth32F
};

int channels(Format format);
bool isHalf(Format format); ///< 16-bit floats
std::size_t bytesPerTexel(Format format);

struct TextureSize {
  int width = 0, height = 0;
  int layers = 0; ///< 0: a plain 2D texture; more: a 2D array
  int levels = 1; ///< mip levels; 0: as many as there are
  bool operator==(const TextureSize&) const = default;
};

/// What a texture takes, bytes; `size.levels` as there.
std::size_t textureBytes(const TextureSize& size, Format format);

class Texture {
 public:
  Texture() = default;
  /// Storage with undefined contents. Throws Error when the driver has not the memory, saying what was asked
  /// for.
  Texture(const TextureSize& size, Format format, const std::string& label);

  explicit operator bool() const { return id_ != 0; }
  unsigned id() const { return id_; }
  const TextureSize& size() const { return size_; }
  int width() const { return size_->width; }
  int height() const { return size_->height; }
  Format format() const { return format_; }
  std::size_t bytes() const; ///< of all levels and layers

  /// Level 0 of `layer` from 32-bit floats with as many channels as the format has.
  void upload(const Image& image, int layer = 0);
  /// Level 0 of a plain texture of a 16-bit float format, from half floats as they are:
  /// width·height·channels of them.
  void uploadHalves(std::span<const std::uint16_t> halves);
  /// Level 0 of a plain R32UI texture, every bit: width·height values.
  void uploadIntegers(std::span<const std::uint32_t> integers);
  /// Level 0 from bytes, RGBA8 and SRGBA8 only; `bytes` is width·height·4 long.
  void uploadBytes(std::span<const std::uint8_t> bytes);
  void generateMipmaps();
  /// Level 0 of a plain texture of the same size and format.
  void copyFrom(const Texture& source);
  /// All of level 0. Integer formats take the first value converted.
  void clear(float r, float g, float b, float a);

  /// Texels of level 0 as floats, as many channels as the format has (unsigned integers are exact up to
  /// 2^24).
  Image download(const Rect& rect, int layer = 0) const;
  Image download(int layer = 0) const { return download({0, 0, width(), height()}, layer); }
  /// Level 0 of a plain R32UI texture, every bit: width·height values, row 0 the top.
  std::vector<std::uint32_t> downloadIntegers() const;
  /// RGBA8 only: width·height·4 bytes, row 0 the top.
  void downloadBytes(std::span<std::uint8_t> bytes) const;

 private:
  Handle<ObjectKind::Texture> id_;
  ResetOnMove<TextureSize> size_;
  Format format_ = Format::RGBA8;
  Allocation allocation_;
};

enum class TextureWrap : std::uint8_t { ClampToEdge, Repeat, MirroredRepeat };

struct SamplerState {
  bool magnifyLinear = false, minifyLinear = false;
  bool mipmapped = false, mipmapLinear = false;
  TextureWrap wrapU = TextureWrap::ClampToEdge, wrapV = TextureWrap::ClampToEdge;
  float lodBias = 0.0f;
  float anisotropy = 1.0f;
  bool operator==(const SamplerState&) const = default;
};

class Sampler {
 public:
  Sampler() = default;
  explicit Sampler(const SamplerState& state);
  unsigned id() const { return id_; }

 private:
  Handle<ObjectKind::Sampler> id_;
};

} // namespace taa::gl
