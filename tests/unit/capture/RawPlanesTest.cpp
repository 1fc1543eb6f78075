// Raw planes: bits that IEEE 754 and Direct3D define, predicted by hand, and files that lie.
#include "core/base/Files.h"
#include "core/base/Half.h"
#include "core/capture/planes/Planes.h"
#include "core/capture/planes/SmallFloats.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace taa::capture {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

fs::path emptyFolder(const std::string& name) {
  const fs::path folder = test::temporaryFolder() / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

template <typename T>
std::string bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A capture of one frame whose only plane is "plane.raw".
struct Raw {
  fs::path folder = emptyFolder("raw");
  Manifest manifest;
  PlaneKind kind = PlaneKind::Color;

  Raw(PlaneKind kind_, RawFormat format, glm::ivec2 size) : kind(kind_) {
    manifest.sizePx = size;
    PlaneSource source;
    source.file = "plane.raw";
    source.raw = format;
    manifest.planes[kind] = source;
    manifest.frames.emplace_back();
  }
  PlaneSource& source() { return manifest.planes.at(kind); }
  void write(const std::string& bytes) const { writeFile(folder / "plane.raw", bytes); }
  PlaneData read() const { return readPlane(folder, manifest, manifest.frames[0], kind); }
  std::string message() const {
    return test::errorOf([&] { read(); });
  }
};

template <typename T>
std::vector<float> valuesOf(PlaneKind kind, RawFormat format, int width, const std::vector<T>& stored) {
  Raw raw(kind, format, {width, 1});
  raw.write(bytesOf(stored));
  return raw.read().image.pixels;
}

} // namespace

TEST(SmallFloats, Floats11And10AreDirect3Ds) {
  EXPECT_EQ(floatOf11Bits(0x3c0), 1.0f); // exponent 15, fraction 0
  EXPECT_EQ(floatOf11Bits(0x3e0), 1.5f);
  EXPECT_EQ(floatOf11Bits(0x7bf), 65024.0f); // the largest: (2 − 1/64) · 2¹⁵
  EXPECT_EQ(floatOf11Bits(0x001), std::ldexp(1.0f, -20));
  EXPECT_EQ(floatOf11Bits(0x7c0), kInfinity);
  EXPECT_TRUE(std::isnan(floatOf11Bits(0x7c1)));
  EXPECT_EQ(floatOf10Bits(0x1e0), 1.0f);
  EXPECT_EQ(floatOf10Bits(0x3df), 64512.0f); // (2 − 1/32) · 2¹⁵
  EXPECT_EQ(floatOf10Bits(0x001), std::ldexp(1.0f, -19));
  EXPECT_EQ(floatOf10Bits(0x3e0), kInfinity);
}

TEST(SmallFloats, Floats11And10AreWrittenAsTheyAreRead) {
  for (std::uint32_t bits = 0; bits <= 0x7c0; ++bits)
    ASSERT_EQ(unsignedFloatOf(floatOf11Bits(bits), 6), bits);
  for (std::uint32_t bits = 0; bits <= 0x3e0; ++bits)
    ASSERT_EQ(unsignedFloatOf(floatOf10Bits(bits), 5), bits);
  EXPECT_EQ(unsignedFloatOf(-1.0f, 6), 0u);
  EXPECT_EQ(unsignedFloatOf(1e9f, 6), 0x7bfu);                 // too large: the largest there is
  EXPECT_EQ(unsignedFloatOf(1.0f + 1.0f / 128.0f, 6), 0x3c0u); // halfway, to the even one
  EXPECT_EQ(unsignedFloatOf(1.0f + 3.0f / 128.0f, 6), 0x3c2u);
  EXPECT_TRUE(std::isnan(floatOf11Bits(unsignedFloatOf(std::nanf(""), 6))));
}

TEST(RawPlanes, DecodeColors) {
  using Values = std::vector<float>;
  using Bytes = std::vector<std::uint8_t>;
  using Shorts = std::vector<std::uint16_t>;
  using Words = std::vector<std::uint32_t>;
  // Red in the lowest bits: 1, 1.5 and 2 (10 bits: exponent 16).
  EXPECT_EQ(
      valuesOf(PlaneKind::Color, RawFormat::R11G11B10F, 1, Words{0x3c0u | 0x3e0u << 11u | 0x200u << 22u}),
      (Values{1.0f, 1.5f, 2.0f}));
  EXPECT_EQ(valuesOf(PlaneKind::Color, RawFormat::RGBA16F, 1, Shorts{0x3c00, 0xc000, 0x7bff, 0x3800}),
            (Values{1.0f, -2.0f, 65504.0f, 0.5f}));
  EXPECT_EQ(valuesOf(PlaneKind::Color, RawFormat::RGBA32F, 1, Values{1e-30f, 2.0f, -3.0f, 0.25f}),
            (Values{1e-30f, 2.0f, -3.0f, 0.25f}));
  EXPECT_EQ(valuesOf(PlaneKind::Color, RawFormat::RGBA8_UNORM, 1, Bytes{0, 255, 51, 128}),
            (Values{0.0f, 1.0f, 51.0f / 255.0f, 128.0f / 255.0f}));
  // Of sRGB: 0.04045 · 255 is 10.3, so 10 is on the line; alpha is not encoded.
  EXPECT_EQ(valuesOf(PlaneKind::Color, RawFormat::RGBA8_SRGB, 1, Bytes{10, 255, 128, 128}),
            (Values{static_cast<float>(10.0 / 255.0 / 12.92), 1.0f,
                    static_cast<float>(std::pow((128.0 / 255.0 + 0.055) / 1.055, 2.4)), 128.0f / 255.0f}));
}

TEST(RawPlanes, DecodeMotionAndMasks) {
  using Values = std::vector<float>;
  using Shorts = std::vector<std::uint16_t>;
  using Bytes = std::vector<std::uint8_t>;
  EXPECT_EQ(valuesOf(PlaneKind::Motion, RawFormat::RG16F, 1, Shorts{0xb800, 0x4900}), (Values{-0.5f, 10.0f}));
  EXPECT_EQ(valuesOf(PlaneKind::Motion, RawFormat::RG32F, 1, Values{-7.25f, 3.0f}), (Values{-7.25f, 3.0f}));
  EXPECT_EQ(valuesOf(PlaneKind::Motion, RawFormat::RG16_UNORM, 1, Shorts{32767, 65535}),
            (Values{32767.0f / 65535.0f, 1.0f}));
  EXPECT_EQ(valuesOf(PlaneKind::Motion, RawFormat::RG8_UNORM, 1, Bytes{0, 51}), (Values{0.0f, 0.2f}));
  // Of four channels the first two are motion's.
  EXPECT_EQ(valuesOf(PlaneKind::Motion, RawFormat::RGBA16F, 2,
                     Shorts{0x3c00, 0x4000, 0x4200, 0x4400, 0xbc00, 0xc000, 0, 0}),
            (Values{1.0f, 2.0f, -1.0f, -2.0f}));
  EXPECT_EQ(valuesOf(PlaneKind::Mask, RawFormat::R8_UNORM, 2, Bytes{255, 0}), (Values{1.0f, 0.0f}));
  EXPECT_EQ(valuesOf(PlaneKind::Mask, RawFormat::RG8_UNORM, 2, Bytes{255, 51, 0, 255}),
            (Values{1.0f, 0.2f, 0.0f, 1.0f}));
  EXPECT_EQ(valuesOf(PlaneKind::Mask, RawFormat::R16_UNORM, 1, Shorts{13107}), (Values{0.2f}));
  EXPECT_EQ(valuesOf(PlaneKind::Mask, RawFormat::R8_UINT, 1, Bytes{7}), (Values{7.0f}));
}

TEST(RawPlanes, DecodeDepth) {
  using Values = std::vector<float>;
  using Words = std::vector<std::uint32_t>;
  const std::uint32_t half = std::bit_cast<std::uint32_t>(0.5f);
  EXPECT_EQ(valuesOf(PlaneKind::Depth, RawFormat::R16F, 1, std::vector<std::uint16_t>{0x3800}),
            (Values{0.5f}));
  EXPECT_EQ(valuesOf(PlaneKind::Depth, RawFormat::R32F, 1, Words{half}), (Values{0.5f}));
  EXPECT_EQ(valuesOf(PlaneKind::Depth, RawFormat::D32F, 1, Words{half}), (Values{0.5f}));
  // Stencil 0xab does not matter, wherever it is.
  EXPECT_EQ(valuesOf(PlaneKind::Depth, RawFormat::D24S8, 3, Words{0xabffffffu, 0xab000000u, 0xab800000u}),
            (Values{1.0f, 0.0f, 8388608.0f / 16777215.0f}));
  EXPECT_EQ(valuesOf(PlaneKind::Depth, RawFormat::D24S8_GL, 3, Words{0xffffffabu, 0x000000abu, 0x800000abu}),
            (Values{1.0f, 0.0f, 8388608.0f / 16777215.0f}));
  EXPECT_EQ(valuesOf(PlaneKind::Depth, RawFormat::D32F_S8, 2, Words{half, 0xabu, 0u, 0xffffffffu}),
            (Values{0.5f, 0.0f}));
}

TEST(RawPlanes, DecodeIdsToTheirLastBit) {
  const auto ids = [](RawFormat format, int width, const std::string& bytes) {
    Raw raw(PlaneKind::ObjectId, format, {width, 1});
    raw.write(bytes);
    const PlaneData plane = raw.read();
    EXPECT_TRUE(plane.image.empty());
    EXPECT_EQ(plane.width, width);
    return plane.integers;
  };
  using Ids = std::vector<std::uint32_t>;
  EXPECT_EQ(ids(RawFormat::R8_UINT, 2, bytesOf(std::vector<std::uint8_t>{0, 255})), (Ids{0, 255}));
  EXPECT_EQ(ids(RawFormat::R16_UINT, 2, bytesOf(std::vector<std::uint16_t>{1, 65535})), (Ids{1, 65535}));
  EXPECT_EQ(ids(RawFormat::R32_UINT, 2, bytesOf(Ids{16777217, 4294967295})), (Ids{16777217, 4294967295}));
  EXPECT_EQ(ids(RawFormat::R32F, 2, bytesOf(std::vector<float>{0.0f, 42.0f})), (Ids{0, 42}));

  Raw fraction(PlaneKind::ObjectId, RawFormat::R32F, {1, 1});
  fraction.write(bytesOf(std::vector<float>{1.5f}));
  EXPECT_NE(fraction.message().find("whole numbers"), std::string::npos) << fraction.message();
}

// Rows from the bottom: the place is that in the picture, whatever the order in the file.
TEST(RawPlanes, MayBeAPartOfTheirFile) {
  Raw raw(PlaneKind::Mask, RawFormat::R8_UNORM, {2, 1});
  raw.source().sizePx = {4, 3};
  raw.source().atPx = {1, 2};
  raw.write(std::string("\x00\x33\x66\x00\x00\x00\x00\x00\x00\x99\xcc\x00", 12));
  EXPECT_EQ(raw.read().image.pixels, (std::vector<float>{0.6f, 0.8f}));
  raw.source().rows = RowOrder::BottomFirst;
  EXPECT_EQ(raw.read().image.pixels, (std::vector<float>{0.2f, 0.4f}));
  EXPECT_EQ(raw.read().width, 2);
  raw.source().atPx = {3, 2};
  EXPECT_NE(raw.message().find("it has 4 × 3 px; the part of 2 × 1 px that begins at 3, 2 goes beyond it"),
            std::string::npos)
      << raw.message();
}

TEST(RawPlanes, FollowRowPitchAndOrder) {
  Raw raw(PlaneKind::Mask, RawFormat::R8_UNORM, {2, 3});
  raw.source().rowPitch = 5;
  raw.source().rows = RowOrder::BottomFirst;
  // The gap behind the last row may be there or not.
  for (const std::string& end : {std::string(), std::string("\x7f\x7f\x7f")}) {
    raw.write(std::string("\x00\xff\x7f\x7f\x7f\xff\x00\x7f\x7f\x7f\x33\x66", 12) + end);
    EXPECT_EQ(raw.read().image.pixels, (std::vector<float>{0.2f, 0.4f, 1.0f, 0.0f, 0.0f, 1.0f}));
  }
  raw.source().rows.reset();
  raw.manifest.conventions.rows = RowOrder::TopFirst;
  EXPECT_EQ(raw.read().image.pixels, (std::vector<float>{0.0f, 1.0f, 1.0f, 0.0f, 0.2f, 0.4f}));
  raw.manifest.conventions.rows = RowOrder::BottomFirst;
  EXPECT_EQ(raw.read().image.pixels[0], 0.2f);
}

TEST(RawPlanes, RefuseFilesThatAreNotWhatIsSaid) {
  const auto has = [](const Raw& raw, const std::string& text) {
    EXPECT_NE(raw.message().find(text), std::string::npos) << raw.message();
  };
  Raw raw(PlaneKind::Color, RawFormat::RGBA16F, {4, 4});
  has(raw, "frame 0, color: plane.raw cannot be opened: No such file");
  raw.write(std::string(127, 'x'));
  has(raw, "plane.raw has 127 bytes; 4 × 4 RGBA16F at a row pitch of 32 takes 128");
  raw.write(std::string(129, 'x'));
  has(raw, "more than the 128");
  raw.write(std::string(128, 'x'));
  raw.source().rowPitch = 31;
  has(raw, "less than the 32");
  raw.source().rowPitch = std::numeric_limits<std::size_t>::max();
  has(raw, "is not one");
  raw.source().rowPitch = 0;
  raw.source().sizePx = {2, 8};
  has(raw, "it has 2 × 8 px; the capture says 4 × 4 px");
  raw.source().sizePx = {0, 0};
  raw.source().file = "../plane.raw";
  has(raw, "cannot be opened");
  writeFile(raw.folder.parent_path() / "plane.raw", "x");
  has(raw, "leads out of the folder");
  Raw narrow(PlaneKind::Color, RawFormat::RG16F, {4, 4});
  has(narrow, "RG16F has 2 channels; 3 are needed");
  Raw large(PlaneKind::Motion, RawFormat::RG16F, {4, 4});
  large.source().sizePx = {16, 1};
  has(large, "at most 4 × 4 px");
}

TEST(RawPlanes, RefuseHugeSizesAndPipesAtOnce) {
  const auto begin = std::chrono::steady_clock::now();
  Raw huge(PlaneKind::Color, RawFormat::RGBA32F, {kMaxCaptureSide, kMaxCaptureSide});
  huge.write("small");
  EXPECT_NE(huge.message().find("million pixels"), std::string::npos) << huge.message();
  huge.manifest.sizePx = {8192, 8192};
  EXPECT_NE(huge.message().find("plane.raw has 5 bytes"), std::string::npos) << huge.message();
  fs::remove(huge.folder / "plane.raw");
  ASSERT_EQ(::mkfifo((huge.folder / "plane.raw").c_str(), 0600), 0);
  EXPECT_NE(huge.message().find("not a regular file"), std::string::npos) << huge.message();
  fs::remove(huge.folder / "plane.raw");
  fs::create_symlink("/dev/zero", huge.folder / "plane.raw");
  EXPECT_NE(huge.message().find("out of the folder"), std::string::npos) << huge.message();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(RawPlanes, NameTheFirstPlaneThatFails) {
  Raw raw(PlaneKind::Color, RawFormat::RGBA16F, {4, 4});
  raw.manifest.planes[PlaneKind::Depth] = raw.source();
  raw.manifest.planes[PlaneKind::Depth].file = "depth.raw";
  raw.manifest.planes[PlaneKind::Depth].raw = RawFormat::D32F;
  const auto message = [&] {
    return test::errorOf([&] { readPlanes(raw.folder, raw.manifest, raw.manifest.frames[0]); });
  };
  for (int i = 0; i < 20; ++i) EXPECT_NE(message().find("frame 0, color:"), std::string::npos) << message();
  raw.write(std::string(128, '\0'));
  EXPECT_NE(message().find("frame 0, depth: depth.raw"), std::string::npos) << message();
  writeFile(raw.folder / "depth.raw", std::string(64, '\0'));
  EXPECT_EQ(readPlanes(raw.folder, raw.manifest, raw.manifest.frames[0]).size(), 2u);
}

TEST(RawPlanes, AreWrittenAsTheyAreRead) {
  for (std::size_t i = 0; i < kRawFormats; ++i) {
    const auto format = static_cast<RawFormat>(i);
    const int channels = rawChannels(format);
    const PlaneKind kind = channels >= 3   ? PlaneKind::Color
                           : channels == 2 ? PlaneKind::Motion
                                           : PlaneKind::Depth;
    Raw raw(kind, format, {37, 3});
    PlaneData plane{Image(37, 3, channels), {}, 37, 3};
    for (std::size_t k = 0; k < plane.image.pixels.size(); ++k)
      plane.image.pixels[k] = static_cast<float>(k % 5) * 0.25f;
    writeRawPlane(raw.folder / "plane.raw", plane, format);
    EXPECT_EQ(fs::file_size(raw.folder / "plane.raw"), 37u * 3u * bytesPerPixel(format));
    const PlaneData first = raw.read();
    writeRawPlane(raw.folder / "plane.raw", first, format);
    EXPECT_EQ(raw.read().image.pixels, first.image.pixels) << rawFormatName(format);
    for (std::size_t k = 0; k < first.image.pixels.size();
         ++k) // half of a step of 8 bits of sRGB, or of integers
      EXPECT_NEAR(first.image.pixels[k], plane.image.pixels[k],
                  rawFormatName(format).ends_with("UINT") ? 0.5 : 0.005);
  }
}

TEST(RawPlanes, WriteIdsThatFit) {
  Raw raw(PlaneKind::ObjectId, RawFormat::R16_UINT, {2, 1});
  PlaneData plane{Image(), {7, 65535}, 2, 1};
  writeRawPlane(raw.folder / "plane.raw", plane, RawFormat::R16_UINT);
  EXPECT_EQ(raw.read().integers, plane.integers);
  plane.integers[0] = 65536;
  EXPECT_NE(test::errorOf([&] {
              writeRawPlane(raw.folder / "plane.raw", plane, RawFormat::R16_UINT);
            }).find("65536 does not fit into R16_UINT"),
            std::string::npos);
  EXPECT_EQ(raw.read().integers[0], 7u);
}

} // namespace taa::capture
