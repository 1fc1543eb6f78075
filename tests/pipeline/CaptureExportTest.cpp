// Shots that the program itself writes as captures, and opens again.
#include "core/report/CaptureExport.h"

#include "core/base/Files.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/planes/Planes.h"
#include "core/report/SequenceExport.h"
#include "core/settings/Presets.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"
#include "tests/support/SmallInspector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

using namespace taa;
using capture::DecodedFrame;

namespace {

constexpr int kLast = 3, kRead = 2;

/// A capture, and of its frame kRead what it was written of.
struct Exported {
  std::filesystem::path folder;
  Image color, motion, depth, previousDepth, mask;
  std::vector<std::uint32_t> objectId;
  glm::vec2 jitterPx{0.0f};

  DecodedFrame read() const {
    const capture::Manifest manifest = capture::readManifest(folder);
    return capture::decode(manifest, kRead, capture::readPlanes(folder, manifest, manifest.frames[kRead]));
  }
};

void keepInputs(Inspector& inspector, Exported& out) {
  const FrameInputs& inputs = inspector.views().inputs(0);
  out.color = inputs.color.download();
  out.motion = inputs.motion.download();
  out.depth = inputs.depth.download();
  out.previousDepth = inputs.previousDepth.download();
  if (inputs.mask) out.mask = inputs.mask.download();
  out.objectId = inputs.objectId.downloadIntegers();
  out.jitterPx = inputs.block.jitterPx;
}

/// One inspector has the context of this thread, so captures are written on another.
Exported exported(const std::string& name, const std::string& source, const Settings& settings,
                  const CaptureChoice& choice) {
  const auto write = [&] {
    Exported out;
    out.folder = taa::test::temporaryFolder() / name;
    std::filesystem::create_directories(out.folder);
    Inspector inspector;
    inspector.shot().setSize(taa::test::small::kWidth, taa::test::small::kHeight);
    inspector.shot().setSettings(settings);
    inspector.shot().open(source);
    CaptureExport files(inspector, choice, 0, kLast);
    for (int frame = 0; frame <= kLast; ++frame) {
      inspector.shot().seek(frame);
      files.add(out.folder, {});
      if (frame == kRead) keepInputs(inspector, out);
    }
    files.finish(out.folder);
    return out;
  };
  return std::async(std::launch::async, write).get();
}

void expectNear(const Image& image, const Image& expected, float relative, float absolute,
                const std::string& what) {
  ASSERT_EQ(image.pixels.size(), expected.pixels.size()) << what;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float value = expected.pixels[i];
    ASSERT_NEAR(image.pixels[i], value, absolute + relative * std::abs(value)) << what << ", value " << i;
  }
}

} // namespace

class CaptureExportTest : public taa::test::small::InspectorTest {};

TEST_F(CaptureExportTest, InputsComeBackInEveryEnginesConventions) {
  for (const capture::StartingPoint& point : capture::startingPoints()) {
    const std::string like(point.id);
    SCOPED_TRACE(like);
    CaptureChoice choice;
    choice.like = like;
    const Exported written = exported("like-" + like, "builtin:fan", Settings{}, choice);
    const DecodedFrame frame = written.read();
    EXPECT_EQ(capture::readManifest(written.folder).like, like);
    expectNear(frame.color, written.color, 0.0f, 0.0f, "color");
    // Half floats in units of up to the whole picture, and Unreal's 16 bits of a root.
    expectNear(frame.motion, written.motion, 1.0f / 1024.0f, 0.002f, "motion");
    // Babylon's half floats, and 24 bits between near and far.
    expectNear(frame.depth, written.depth, 1.0f / 1024.0f, 1e-7f, "depth");
    expectNear(frame.previousDepth, written.previousDepth, 0.0f, 0.0f, "previous depth");
    EXPECT_EQ(frame.objectId, written.objectId);
    EXPECT_NEAR(frame.jitterPx.x, written.jitterPx.x, 1e-6f);
    EXPECT_NEAR(frame.jitterPx.y, written.jitterPx.y, 1e-6f);
  }
}

// What was blended in, and what changes without motion.
TEST_F(CaptureExportTest, BothMasksComeBack) {
  Settings settings;
  settings.inputs.mask = MaskSource::Opacity;
  settings.inputs.blended = BlendedAs::Before; // only what is blended is reactive
  const Exported written = exported("masks", "builtin:glass", settings, {});
  const DecodedFrame frame = written.read();
  ASSERT_EQ(frame.mask.channels, 2);
  ASSERT_EQ(frame.mask.pixels.size(), written.mask.pixels.size());
  float reactive = 0.0f, responsive = 0.0f;
  for (std::size_t i = 0; i < frame.mask.pixels.size(); ++i) // 8 bits: a step apart they would be 0.004
    ASSERT_NEAR(frame.mask.pixels[i], written.mask.pixels[i], 1e-6f) << i;
  for (std::size_t i = 0; i < frame.mask.pixels.size(); i += 2) {
    reactive = std::max(reactive, frame.mask.pixels[i]);
    responsive = std::max(responsive, frame.mask.pixels[i + 1]);
  }
  EXPECT_GT(reactive, 0.0f);
  EXPECT_EQ(responsive, 1.0f);
}

// What the rest of the session is made of stays as it is, whichever name it was opened and is written by.
TEST_F(CaptureExportTest, TheOpenCaptureIsNotWrittenOver) {
  const Exported written = exported("open", "builtin:fan", Settings{}, {});
  const std::filesystem::path manifest = written.folder / capture::kManifestName;
  const std::string before = readFile(manifest);
  SequenceRequest request;
  request.kind = SequenceKind::Capture;
  request.last = 1;
  for (const std::filesystem::path& source : {written.folder, manifest}) {
    Inspector inspector;
    inspector.shot().open(source.string());
    request.target = written.folder / ".." / written.folder.filename() / capture::kManifestName;
    EXPECT_NE(test::errorOf([&] { exportSequence(inspector, request, {}); }).find("the one that is open"),
              std::string::npos);
    EXPECT_EQ(readFile(manifest), before);
    request.target = written.folder / "other" / capture::kManifestName;
    EXPECT_EQ(test::errorOf([&] { exportSequence(inspector, request, {}); }), "");
    EXPECT_EQ(capture::readManifest(written.folder / "other").frames.size(), 2u);
  }
  Inspector inspector;
  inspector.shot().setSize(taa::test::small::kWidth, taa::test::small::kHeight);
  inspector.shot().open("builtin:fan");
  request.target = manifest;
  EXPECT_EQ(test::errorOf([&] { exportSequence(inspector, request, {}); }), "") << "a scene is open";
  EXPECT_EQ(capture::readManifest(written.folder).frames.size(), 2u);
}

class CaptureOfPreset : public CaptureExportTest, public testing::WithParamInterface<std::size_t> {};

TEST_P(CaptureOfPreset, HasTheBitsOfTheShot) {
  const Preset& preset = wholePresets()[GetParam()];
  SCOPED_TRACE(preset.id);
  const Exported written = exported("preset-" + preset.id, "builtin:fan", preset.settings, {});
  auto inspector = std::make_unique<Inspector>();
  inspector->shot().setSettings(preset.settings);
  inspector->shot().open(written.folder.string());
  inspector->shot().seek(kLast);
  taa::test::small::expectSame(inspector->views().images(allRows()),
                               taa::test::small::fresh(preset.settings, kLast));
}

INSTANTIATE_TEST_SUITE_P(Presets, CaptureOfPreset, testing::Range(std::size_t{0}, wholePresets().size()));
