// taa_capture.h as an engine misuses it: what it takes is a capture that opens, and what would not open is an
// error of the call that said it.
#define TAA_CAPTURE_IMPLEMENTATION
#include "resources/capture/taa_capture.h"

#include "core/base/Error.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/planes/Planes.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace taa::capture {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 4, kHeight = 2;

class CaptureHeader : public testing::Test {
 protected:
  CaptureHeader() {
    fs::remove_all(folder_);
    desc_.folder = path_.c_str();
    desc_.width = kWidth;
    desc_.height = kHeight;
  }
  ~CaptureHeader() override { taa_capture_close(capture_); }

  int open() {
    taa_capture_close(capture_);
    desc_.replace = 1;
    return taa_capture_open(&capture_, &desc_);
  }
  int begin(int number) {
    frame_.number = number;
    return taa_capture_begin(capture_, &frame_);
  }
  int plane(const char* name, taa_format format, int width = kWidth, int height = kHeight) {
    return taa_capture_plane(capture_, name, format, width, height, 0, TAA_ROWS_AS_CONVENTIONS,
                             pixels_.data());
  }
  /// A frame of color.
  int frame(int number) {
    if (const int status = begin(number)) return status;
    if (const int status = plane("color", TAA_RGBA16F)) return status;
    return taa_capture_end(capture_);
  }
  /// Closes it; what was taken opens, and its frames can be read.
  Manifest closed() {
    EXPECT_EQ(taa_capture_close(capture_), TAA_OK);
    capture_ = nullptr;
    Manifest manifest = readManifest(folder_);
    for (const CapturedFrame& stated : manifest.frames) readPlanes(folder_, manifest, stated);
    return manifest;
  }

  fs::path folder_ = test::temporaryFolder() / "header";
  std::string path_ = folder_.string();
  std::vector<std::uint64_t> pixels_ = std::vector<std::uint64_t>(1024);
  taa_capture_desc desc_{};
  taa_capture_frame frame_{};
  taa_capture* capture_ = nullptr;
};

constexpr std::array<float, 16> kMatrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0.5f, 0, 0, -1, 0};

} // namespace

TEST_F(CaptureHeader, OpensWhatCanBeOpenedAgain) {
  for (const double rate : {-1.0, 1e-4, 1e6, std::nan(""), std::numeric_limits<double>::infinity()}) {
    desc_.frames_per_second = rate;
    EXPECT_NE(open(), TAA_OK) << rate;
  }
  desc_.frames_per_second = 0.0;
  desc_.width = desc_.height = 16384;
  EXPECT_EQ(open(), TAA_ERROR_ARGUMENT) << "more pixels than are read";
  desc_.width = kWidth;
  desc_.height = kHeight;
  const char* const twice[] = {"rows=topFirst", "motion.unit=uv", "motion.unit=ndc", nullptr};
  desc_.conventions = twice;
  EXPECT_EQ(open(), TAA_ERROR_CONVENTION);
  const char* const once[] = {"motion.unit=uv", "motion.unitX=ndc", "rows=topFirst", nullptr};
  desc_.conventions = once;
  EXPECT_EQ(open(), TAA_OK) << "a key that begins as another is another one";
}

// What was there would name planes of the new one, should the engine die before its first frame.
TEST_F(CaptureHeader, ACaptureThatIsReplacedIsGoneAtOnce) {
  ASSERT_EQ(open(), TAA_OK);
  ASSERT_EQ(frame(0), TAA_OK);
  closed();
  taa_capture* other = nullptr;
  desc_.replace = 0;
  EXPECT_EQ(taa_capture_open(&other, &desc_), TAA_ERROR_EXISTS);
  EXPECT_EQ(other, nullptr);
  EXPECT_EQ(readManifest(folder_).frames.size(), 1u) << "nobody asked to replace it";
  ASSERT_EQ(open(), TAA_OK);
  try {
    readManifest(folder_);
    ADD_FAILURE() << "it has no frame yet";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("\"frames\" is empty"), std::string::npos) << error.what();
  }
}

TEST_F(CaptureHeader, FoldersThatCannotBeAreRefused) {
  const std::string below = path_ + "/parent that is not there/capture", longest(5000, 'x');
  for (const std::string* path : {&below, &longest}) {
    desc_.folder = path->c_str();
    EXPECT_EQ(open(), TAA_ERROR_FOLDER);
    EXPECT_EQ(capture_, nullptr);
  }
}

// U+0085 is a control character of two bytes, and half a letter stands where 4096 bytes end.
TEST_F(CaptureHeader, TextsAreOnesThatCanBeShown) {
  const std::string name = "a\xc2\x85\x07z\xff", engine(4095, 'x'), tooLong = engine + "\xc3\xa9";
  desc_.name = name.c_str();
  desc_.engine = tooLong.c_str();
  ASSERT_EQ(open(), TAA_OK);
  ASSERT_EQ(frame(0), TAA_OK);
  const Manifest manifest = closed();
  EXPECT_EQ(manifest.name, "a  z?");
  EXPECT_EQ(manifest.engine, engine);
}

// Too long, half of a pair, above U+10FFFF, more than four bytes, cut off: each byte by itself is no letter.
TEST_F(CaptureHeader, LettersAreUtf8) {
  const std::string no = "\xc0\x80|\xc1\xbf|\xe0\x9f\xbf|\xed\xa0\x80|\xf0\x8f\xbf\xbf|\xf4\x90\x80\x80|"
                         "\xf8\xbf\xbf\xbf|\xe2\x82";
  const std::string yes = "\xc2\xa0|\xdf\xbf|\xe0\xa0\x80|\xed\x9f\xbf|\xee\x80\x80|\xef\xbf\xbf|"
                          "\xf0\x90\x80\x80|\xf4\x8f\xbf\xbf";
  desc_.name = no.c_str();
  desc_.engine = yes.c_str();
  ASSERT_EQ(open(), TAA_OK);
  ASSERT_EQ(frame(0), TAA_OK);
  const Manifest manifest = closed();
  EXPECT_EQ(manifest.name, "??|??|???|???|????|????|????|??");
  EXPECT_EQ(manifest.engine, yes);
}

TEST_F(CaptureHeader, ObjectsAreNamedOnce) {
  ASSERT_EQ(open(), TAA_OK);
  EXPECT_EQ(taa_capture_object(capture_, 0, "nothing"), TAA_ERROR_ARGUMENT);
  EXPECT_EQ(taa_capture_object(capture_, 7, "\"7\": door"), TAA_OK);
  EXPECT_EQ(taa_capture_object(capture_, 7, "window"), TAA_ERROR_ORDER);
  EXPECT_EQ(taa_capture_object(capture_, 77, "floor"), TAA_OK);
  EXPECT_EQ(taa_capture_object(capture_, 5, "named late"), TAA_OK);
  EXPECT_EQ(taa_capture_object(capture_, 5, "named again"), TAA_ERROR_ORDER);
  ASSERT_EQ(frame(0), TAA_OK);
  ASSERT_EQ(begin(1), TAA_OK) << "and then nothing of it";
  EXPECT_EQ(taa_capture_object(capture_, 4294967295u, "named after the last frame"), TAA_OK);
  const Manifest manifest = closed();
  EXPECT_EQ(manifest.objects.size(), 4u);
  EXPECT_EQ(manifest.objects.at(7), "\"7\": door");
  EXPECT_EQ(manifest.objects.count(4294967295u), 1u);
}

TEST_F(CaptureHeader, MatricesStandTogether) {
  ASSERT_EQ(open(), TAA_OK);
  frame_.view = kMatrix.data();
  EXPECT_EQ(begin(0), TAA_ERROR_ARGUMENT);
  frame_.previous_view = frame_.previous_projection = kMatrix.data();
  frame_.view = nullptr;
  EXPECT_EQ(begin(0), TAA_ERROR_ARGUMENT) << "previous ones alone";
  frame_.view = frame_.projection = kMatrix.data();
  frame_.previous_projection = nullptr;
  EXPECT_EQ(begin(0), TAA_ERROR_ARGUMENT);
  frame_.previous_view = nullptr;
  EXPECT_EQ(frame(0), TAA_OK);
  EXPECT_TRUE(closed().frames[0].view);
}

TEST_F(CaptureHeader, NumbersAreWithinTheirRanges) {
  ASSERT_EQ(open(), TAA_OK);
  const std::array<double, 16> far = {1e31};
  frame_.view64 = frame_.projection64 = far.data();
  EXPECT_EQ(begin(0), TAA_ERROR_NUMBER);
  frame_.view64 = frame_.projection64 = nullptr;
  frame_.jitter[1] = 1e7;
  EXPECT_EQ(begin(0), TAA_ERROR_NUMBER);
  frame_.jitter[1] = std::nan("");
  EXPECT_EQ(begin(0), TAA_ERROR_NUMBER);
  frame_.jitter[1] = 0.0;
  frame_.pre_exposure = -1.0;
  EXPECT_EQ(begin(0), TAA_ERROR_NUMBER);
  frame_.pre_exposure = 0.0;
  EXPECT_EQ(frame(0), TAA_OK);
  closed();
}

TEST_F(CaptureHeader, TimesRiseAndAreStatedOfAllFramesOrOfNone) {
  ASSERT_EQ(open(), TAA_OK);
  frame_.has_seconds = 1;
  ASSERT_EQ(begin(0), TAA_OK);
  frame_.has_seconds = 0;
  ASSERT_EQ(frame(1), TAA_OK) << "the frame before has no planes and is none";
  frame_.has_seconds = 1;
  EXPECT_EQ(frame(2), TAA_ERROR_ORDER);
  ASSERT_EQ(open(), TAA_OK);
  frame_.seconds = 0.5;
  ASSERT_EQ(frame(0), TAA_OK);
  EXPECT_EQ(frame(1), TAA_ERROR_ORDER) << "time stands still";
  frame_.seconds = 0.75;
  ASSERT_EQ(frame(1), TAA_OK);
  frame_.has_seconds = 0;
  EXPECT_EQ(frame(2), TAA_ERROR_ORDER);
  EXPECT_EQ(closed().frames.size(), 2u);
}

TEST_F(CaptureHeader, PlanesHaveAFormatAndASizeThatTheyCanHave) {
  desc_.output_width = 2 * kWidth;
  desc_.output_height = 2 * kHeight;
  ASSERT_EQ(open(), TAA_OK);
  ASSERT_EQ(begin(0), TAA_OK);
  EXPECT_EQ(plane("colour", TAA_RGBA16F), TAA_ERROR_PLANE);
  EXPECT_EQ(plane("color", TAA_RG16F), TAA_ERROR_PLANE) << "too few channels";
  EXPECT_EQ(plane("color", TAA_R32_UINT), TAA_ERROR_PLANE);
  EXPECT_EQ(plane("objectId", TAA_R32F), TAA_ERROR_PLANE) << "no whole number";
  EXPECT_EQ(plane("color", TAA_RGBA16F, kWidth - 1), TAA_ERROR_PLANE);
  EXPECT_EQ(plane("output", TAA_RGBA16F), TAA_ERROR_PLANE) << "of the render size";
  EXPECT_EQ(plane("depth", TAA_D32F, 2 * kWidth + 1), TAA_ERROR_PLANE) << "larger than both";
  EXPECT_EQ(taa_capture_plane(capture_, "color", TAA_RGBA16F, kWidth, kHeight, (std::size_t(1) << 30) + 1,
                              TAA_ROWS_AS_CONVENTIONS, pixels_.data()),
            TAA_ERROR_ARGUMENT);
  EXPECT_EQ(plane("color", TAA_R11G11B10F), TAA_OK);
  EXPECT_EQ(plane("motion", TAA_RGBA16F), TAA_OK) << "more channels than it needs";
  EXPECT_EQ(plane("depth", TAA_D24S8, 2 * kWidth, 2 * kHeight), TAA_OK);
  EXPECT_EQ(plane("objectId", TAA_R8_UINT, kWidth / 2, kHeight / 2), TAA_OK);
  EXPECT_EQ(plane("output", TAA_RGBA8_SRGB, 2 * kWidth, 2 * kHeight), TAA_OK);
  EXPECT_EQ(taa_capture_end(capture_), TAA_OK);
  EXPECT_EQ(closed().frames[0].planes.size(), 5u);
}

/// Every plane in every format: the header and who reads it are of one mind.
TEST_F(CaptureHeader, TakesTheFormatsThatAreRead) {
  for (std::size_t kind = 0; kind < kPlaneKinds; ++kind)
    for (std::size_t format = 0; format < kRawFormats; ++format) {
      ASSERT_EQ(open(), TAA_OK);
      Manifest manifest;
      manifest.sizePx = {kWidth, kHeight};
      manifest.frames.emplace_back();
      PlaneSource source;
      source.file = "file";
      manifest.planes[PlaneKind::Color] = source;
      source.raw = static_cast<RawFormat>(format);
      manifest.planes[static_cast<PlaneKind>(kind)] = source;
      bool isRead = true;
      try {
        checkManifest(manifest, "it");
      } catch (const Error&) {
        isRead = false;
      }
      const std::string name(planeName(static_cast<PlaneKind>(kind)));
      ASSERT_EQ(begin(0), TAA_OK);
      EXPECT_EQ(plane(name.c_str(), static_cast<taa_format>(format)), isRead ? TAA_OK : TAA_ERROR_PLANE)
          << name << " " << rawFormatName(static_cast<RawFormat>(format));
    }
}

// A disk that was full for a moment: color failed, and what came after it was written.
TEST_F(CaptureHeader, AFrameWithoutColorIsLeftOut) {
  ASSERT_EQ(open(), TAA_OK);
  ASSERT_EQ(frame(0), TAA_OK);
  ASSERT_EQ(begin(1), TAA_OK);
  ASSERT_EQ(plane("motion", TAA_RG16F), TAA_OK);
  EXPECT_EQ(taa_capture_end(capture_), TAA_ERROR_PLANE);
  ASSERT_EQ(frame(2), TAA_OK);
  const Manifest manifest = closed();
  ASSERT_EQ(manifest.frames.size(), 2u);
  EXPECT_EQ(manifest.frames[1].number, 2);
}

} // namespace taa::capture
