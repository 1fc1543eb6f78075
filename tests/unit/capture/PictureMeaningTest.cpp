// What stored channels and bits are taken for: classes in normals, and light in 256 steps.
#include "core/base/Image.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/import/Guess.h"
#include "core/capture/planes/Planes.h"
#include "tests/support/Paths.h"
#include "tests/unit/capture/CaptureFixtures.h"

#include <OpenImageIO/imageio.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace taa::capture {

namespace {

namespace fs = std::filesystem;

constexpr glm::ivec2 kSize(2, 1);

bool saysIt(const std::vector<std::string>& sentences, const std::string& words) {
  return std::ranges::any_of(
      sentences, [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

class PictureMeaning : public testing::Test {
 protected:
  PictureMeaning() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  /// A picture of four channels, the same in both pixels.
  void write(const std::string& file, OIIO::TypeDesc type, const std::vector<float>& pixel) const {
    const OIIO::ImageSpec spec(kSize.x, kSize.y, static_cast<int>(pixel.size()), type);
    const std::string path = (folder_ / file).string();
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(output && output->open(path, spec));
    std::vector<float> values = pixel;
    values.insert(values.end(), pixel.begin(), pixel.end());
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, values.data()) && output->close());
  }

  DecodedFrame frameOf(const Manifest& manifest) const {
    return decode(manifest, 0, readPlanes(folder_, manifest, manifest.frames[0]));
  }

  fs::path folder_ = test::temporaryFolder() / "meaning";
};

DecodedFrame withNormals(const std::vector<float>& stored, int channels) {
  const Manifest manifest = manifestOf({}, kSize);
  FramePlanes planes = planesOf(manifest);
  planes[PlaneKind::Normal] = planeFrom(kSize.x, kSize.y, channels, stored);
  return decode(manifest, 0, std::move(planes));
}

} // namespace

// Engines keep roughness, a mask or nothing at all in the fourth channel of their normals.
TEST_F(PictureMeaning, AFourthChannelOfNormalsIsTheirClassOnlyWhereItIsNamed) {
  write("color.exr", OIIO::TypeHalf, {0.5f, 0.5f, 0.5f});
  write("normal.exr", OIIO::TypeHalf, {0.0f, 0.0f, 1.0f, 2.0f});
  Manifest manifest = manifestOf({}, kSize, 1);
  manifest.planes[PlaneKind::Color].file = "color.exr";
  manifest.planes[PlaneKind::Normal].file = "normal.exr";
  EXPECT_EQ(frameOf(manifest).normal.texel(1, 0), glm::vec4(0.0f, 0.0f, 1.0f, 0.0f));
  manifest.planes[PlaneKind::Normal].channels = {"R", "G", "B", "A"};
  EXPECT_EQ(frameOf(manifest).normal.texel(1, 0), glm::vec4(0.0f, 0.0f, 1.0f, 2.0f));
}

TEST(NormalClasses, AreNumbersOfClasses) {
  const DecodedFrame frame = withNormals({0, 0, 1, 4, 0, 1, 0, 0}, 4);
  EXPECT_EQ(frame.normal.pixels, (std::vector<float>{0, 0, 1, 4, 0, 1, 0, 0}));
  EXPECT_TRUE(frame.notes.empty());
  EXPECT_TRUE(withNormals({0, 0, 1}, 3).notes.empty());
}

TEST(NormalClasses, AreNotTakenFromWhatIsSomethingElse) {
  for (const float other : {0.5f, 5.0f, -1.0f, std::nanf("")}) {
    const DecodedFrame frame = withNormals({0, 0, 1, 2, 0, 1, 0, other}, 4);
    EXPECT_EQ(frame.normal.pixels, (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0})) << other;
    EXPECT_TRUE(saysIt(frame.notes, "the fourth channel of normal is")) << other;
  }
}

TEST_F(PictureMeaning, EightBitsThatAreStatedAsLightArePointedOut) {
  const auto isNoted = [&](const char* file, ColorEncoding encoding) {
    Manifest manifest = manifestOf({}, kSize, 1);
    manifest.conventions.color.encoding = encoding;
    manifest.planes[PlaneKind::Color].file = file;
    return saysIt(frameOf(manifest).notes, "color is stored in 8 bits and stated as linear");
  };
  write("8.png", OIIO::TypeUInt8, {0.5f, 0.5f, 0.5f});
  write("16.png", OIIO::TypeUInt16, {0.5f, 0.5f, 0.5f});
  EXPECT_TRUE(isNoted("8.png", ColorEncoding::Linear));
  EXPECT_FALSE(isNoted("8.png", ColorEncoding::Srgb));
  EXPECT_FALSE(isNoted("16.png", ColorEncoding::Linear));
}

TEST(MissingInputs, SayThatLightIsInSteps) {
  Manifest manifest = manifestOf({}, kSize);
  manifest.planes[PlaneKind::Color].raw = RawFormat::RGBA8_UNORM;
  EXPECT_TRUE(saysIt(missingInputs(manifest), "color is stored in 8 bits and stated as linear"));
  manifest.planes[PlaneKind::Color].raw = RawFormat::RGBA8_SRGB;
  EXPECT_FALSE(saysIt(missingInputs(manifest), "color is stored in 8 bits"));
  manifest.planes[PlaneKind::Color].raw = RawFormat::RGBA8_UNORM;
  manifest.conventions.color.encoding = ColorEncoding::Srgb;
  EXPECT_FALSE(saysIt(missingInputs(manifest), "color is stored in 8 bits"));
}

// Without a word of the caller it is taken as encoded, which is said, too.
TEST_F(PictureMeaning, TheImportPointsOutEightBitsThatTheCallerCallsLight) {
  for (const char* file : {"a.0001.png", "a.0002.png"}) write(file, OIIO::TypeUInt8, {0.5f, 0.25f, 0.5f});
  const std::string words = "color is stored in 8 bits and stated as linear";
  EXPECT_FALSE(saysIt(guessCapture(folder_, "", {}).unsure, words));
  EXPECT_TRUE(saysIt(guessCapture(folder_, "", {"color.encoding=linear"}).unsure, words));
}

} // namespace taa::capture
