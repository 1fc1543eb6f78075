// Frames of a capture on disk: read once, kept within a budget, and read ahead.
#include "core/capture/source/Capture.h"
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"
#include "tests/unit/capture/CaptureFixtures.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace taa::capture {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 6;
constexpr glm::ivec2 kSize(8, 4);
/// Of one decoded frame: four channels of color.
constexpr std::size_t kFrameBytes = 8 * 4 * 4 * sizeof(float);

/// Frame n has the red value n everywhere.
Manifest writtenCapture(const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  Manifest manifest = manifestOf({}, kSize, kFrames);
  PlaneSource& color = manifest.planes[PlaneKind::Color];
  color.file = "color.{frame}.raw";
  color.raw = RawFormat::RGBA32F;
  color.sizePx = kSize;
  for (int frame = 0; frame < kFrames; ++frame)
    writeRawPlane(folder / ("color." + std::to_string(frame) + ".raw"),
                  planeFrom(kSize.x, kSize.y, 4, {static_cast<float>(frame), 0.0f, 0.0f, 1.0f}),
                  RawFormat::RGBA32F);
  writeFile(folder / kManifestName, manifestText(manifest));
  return manifest;
}

class CaptureTest : public testing::Test {
 protected:
  fs::path folder_ = test::temporaryFolder() / "capture";
  Manifest manifest_ = writtenCapture(folder_);

  fs::path file(int frame) const { return folder_ / ("color." + std::to_string(frame) + ".raw"); }
};

float redOf(const std::shared_ptr<const DecodedFrame>& frame) {
  return frame->color.pixels.front();
}

/// Reading ahead has no end that is told; a minute is more than any machine takes.
bool becomesReady(const Capture& capture, int frame) {
  for (int i = 0; i < 6000 && !capture.isReady(frame); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return capture.isReady(frame);
}

} // namespace

TEST_F(CaptureTest, FramesAreThoseOfTheFilesInAnyOrder) {
  const Capture capture(folder_, manifest_);
  EXPECT_EQ(capture.frames(), kFrames);
  EXPECT_EQ(capture.folder(), folder_);
  for (const int frame : {0, 1, 2, 5, 4, 3, 0, 5, 5}) {
    const std::shared_ptr<const DecodedFrame> decoded = capture.frame(frame);
    EXPECT_EQ(decoded->index, frame);
    EXPECT_EQ(redOf(decoded), static_cast<float>(frame));
  }
}

TEST_F(CaptureTest, AFrameThatIsKeptIsTheSame) {
  const Capture capture(folder_, manifest_);
  const std::shared_ptr<const DecodedFrame> first = capture.frame(2);
  EXPECT_EQ(capture.frame(2), first);
}

TEST_F(CaptureTest, ABudgetKeepsTheNewestFrames) {
  // Besides the two newest one is kept. Going down reads 3, 2, 1 after 4, and 0 ahead.
  const Capture capture(folder_, manifest_, kFrameBytes);
  const std::weak_ptr<const DecodedFrame> last = capture.frame(5);
  for (const int frame : {4, 3, 2, 1}) static_cast<void>(capture.frame(frame));
  EXPECT_TRUE(last.expired());
  // A budget of everything lets go of nothing.
  const Capture all(folder_, manifest_);
  const std::weak_ptr<const DecodedFrame> kept = all.frame(5);
  for (const int frame : {4, 3, 2, 1, 0}) static_cast<void>(all.frame(frame));
  EXPECT_FALSE(kept.expired());
}

TEST_F(CaptureTest, TheNextFrameIsReadAhead) {
  const Capture capture(folder_, manifest_);
  static_cast<void>(capture.frame(2));
  ASSERT_TRUE(becomesReady(capture, 3));
  fs::remove(file(3));
  EXPECT_EQ(redOf(capture.frame(3)), 3.0f);
  EXPECT_FALSE(capture.isReady(1));
  // Downward it is the one before.
  static_cast<void>(capture.frame(2));
  EXPECT_TRUE(becomesReady(capture, 1));
}

TEST_F(CaptureTest, WhatFailsAheadIsToldWhenItIsAskedFor) {
  fs::remove(file(1));
  const Capture capture(folder_, manifest_);
  EXPECT_EQ(redOf(capture.frame(0)), 0.0f);
  EXPECT_EQ(redOf(capture.frame(2)), 2.0f);
  EXPECT_NE(test::errorOf([&] { static_cast<void>(capture.frame(1)); }), "");
  EXPECT_NE(test::errorOf([&] { static_cast<void>(capture.frame(1)); }), "") << "nothing is made up";
  EXPECT_EQ(redOf(capture.frame(0)), 0.0f);
}

TEST_F(CaptureTest, AFileThatComesBackIsReadAgain) {
  const std::string bytes = readFile(file(3));
  fs::remove(file(3));
  const Capture capture(folder_, manifest_);
  EXPECT_THROW(static_cast<void>(capture.frame(3)), Error);
  writeFile(file(3), bytes);
  EXPECT_EQ(redOf(capture.frame(3)), 3.0f);
}

TEST_F(CaptureTest, ManyThreadsGetTheSameFrames) {
  const Capture capture(folder_, manifest_, kFrameBytes);
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (std::size_t i = 0; i < wrong.size(); ++i)
    threads.emplace_back([&capture, &count = wrong[i], i] {
      for (int step = 0; step < 200; ++step) {
        const int frame = static_cast<int>(i % 2 == 0 ? step : 200 - step) % kFrames;
        count += redOf(capture.frame(frame)) == static_cast<float>(frame) ? 0 : 1;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

TEST_F(CaptureTest, FramesOutsideAreAnError) {
  const Capture capture(folder_, manifest_);
  EXPECT_THROW(static_cast<void>(capture.frame(-1)), Error);
  EXPECT_THROW(static_cast<void>(capture.frame(kFrames)), Error);
}

TEST_F(CaptureTest, IsOpenedByItsFolderOrItsManifest) {
  for (const fs::path& source : {folder_, folder_ / kManifestName}) {
    EXPECT_TRUE(isCapture(source.string()));
    EXPECT_EQ(redOf(openCapture(source.string())->frame(1)), 1.0f);
  }
  fs::create_directory(folder_ / "folder.json");
  EXPECT_EQ(folderOf((folder_ / "folder.json").string()), folder_ / "folder.json");
  fs::copy_file(folder_ / kManifestName, folder_ / "night.json");
  fs::rename(folder_ / kManifestName, folder_ / "capture.old");
  EXPECT_TRUE(isCapture((folder_ / "night.json").string()));
  EXPECT_EQ(redOf(openCapture((folder_ / "night.json").string())->frame(1)), 1.0f);
  fs::rename(folder_ / "capture.old", folder_ / kManifestName);
  // Within the folder its file has a name and no path.
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  EXPECT_NO_THROW(static_cast<void>(openCapture(kManifestName)));
  EXPECT_EQ(nameOf("."), "capture");
  fs::current_path(before);
  EXPECT_EQ(nameOf("a/capture/"), "capture");
  EXPECT_EQ(nameOf("capture"), "capture");
  EXPECT_FALSE(isCapture("builtin:fan"));
  EXPECT_FALSE(isCapture((folder_ / "scene.gltf").string()));
}

TEST_F(CaptureTest, OpeningChecksTheFirstFrame) {
  fs::remove(file(0));
  EXPECT_THROW(static_cast<void>(openCapture(folder_.string())), Error);
  fs::remove(folder_ / kManifestName);
  const std::string error = test::errorOf([&] { static_cast<void>(openCapture(folder_.string())); });
  EXPECT_NE(error.find("capture.json"), std::string::npos) << error;
}

} // namespace taa::capture
