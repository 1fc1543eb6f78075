// A shot that is written as a capture in this program's own conventions and opened again: everything after
// the inputs works the same, bit for bit.
#include "core/base/Error.h"
#include "core/render/CaptureFacts.h"
#include "core/settings/Presets.h"
#include "tests/support/Batch.h"
#include "tests/support/Paths.h"
#include "tests/support/SmallInspector.h"
#include "tests/support/capture/CapturedShot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

using namespace taa;
using taa::test::small::expectSame;
using taa::test::small::isSame;
using taa::test::small::kHeight;
using taa::test::small::kWidth;

namespace {

constexpr int kCapturedFrames = 9;
constexpr int kLast = kCapturedFrames - 1;

Settings presetOf(const std::string& id) {
  return std::ranges::find(builtinPresets(), id, &Preset::id)->settings;
}

/// One inspector has the context of this thread, so captures are written on another.
std::string written(const std::string& name, const Settings& settings, bool hasOutput = false) {
  const std::filesystem::path folder = taa::test::temporaryFolder() / name;
  const auto write = [&] {
    const gl::Context context;
    taa::test::CapturedShot("builtin:fan", {kWidth, kHeight}, settings, kCapturedFrames)
        .write(folder, hasOutput);
  };
  std::async(std::launch::async, write).get();
  return folder.string();
}

class CapturedSceneTest : public taa::test::small::InspectorTest {
 protected:
  static std::unique_ptr<Inspector> openedCapture(const std::string& folder,
                                                  const std::vector<Settings>& lanes = {Settings{}}) {
    auto inspector = std::make_unique<Inspector>();
    inspector->shot().setLanes(lanes);
    inspector->shot().open(folder);
    return inspector;
  }
  static std::vector<Image> all(Inspector& inspector) { return inspector.views().images(allRows()); }
};

} // namespace

TEST_F(CapturedSceneTest, EveryIntermediateHasTheBitsOfTheSceneItWasTakenOf) {
  for (const std::string preset : {"balanced", "off", "stable", "ue4", "playdead", "fsr2", "hdrp-taau"}) {
    SCOPED_TRACE(preset);
    const Settings settings = presetOf(preset);
    const std::string folder = written("bits-" + preset, settings);
    auto inspector = openedCapture(folder, {settings});
    inspector->shot().seek(kLast);
    expectSame(all(*inspector), taa::test::small::fresh(settings, kLast));
  }
}

TEST_F(CapturedSceneTest, SeekingPlayingAndSteppingBackAreTheSame) {
  const std::string folder = written("time", Settings{});
  auto inspector = openedCapture(folder);
  EXPECT_EQ(inspector->shot().frameCount(), kCapturedFrames);
  EXPECT_EQ(inspector->shot().width(), kWidth);
  EXPECT_EQ(inspector->shot().height(), kHeight);
  while (inspector->shot().frame() < kLast) inspector->shot().advance();
  const std::vector<Image> played = all(*inspector);
  inspector->shot().seek(3);
  const std::vector<Image> back = all(*inspector);
  inspector->shot().seek(kLast);
  expectSame(all(*inspector), played);
  inspector->shot().seek(3);
  expectSame(all(*inspector), back);
  expectSame(back, taa::test::small::fresh(Settings{}, 3));
}

TEST_F(CapturedSceneTest, RestartsAndLanesWorkAsInAScene) {
  const std::string folder = written("lanes", Settings{});
  const std::vector<Settings> lanes{Settings{}, taa::test::small::otherSettings()};
  auto inspector = openedCapture(folder, lanes);
  inspector->shot().seek(5);
  expectSame(inspector->views().images(allRows(), 1), taa::test::small::fresh(lanes[1], 5));
  inspector->shot().setRestarts({5});
  EXPECT_TRUE(inspector->shot().isExact());
  EXPECT_TRUE(inspector->shot().info().startsHistory);
  for (const float length : inspector->views().image(IntermediateId::historyLength).pixels)
    ASSERT_EQ(length, 1.0f);
}

// Whatever asks a renderer for something else.
TEST_F(CapturedSceneTest, SettingsOfTheRendererChangeNothing) {
  const std::string folder = written("own", Settings{});
  auto inspector = openedCapture(folder);
  inspector->shot().seek(4);
  const std::vector<Image> before = all(*inspector);
  Settings other;
  other.jitter.sequence = JitterSequence::R2;
  other.inputs.renderScale = 0.5f;
  other.inputs.mipBias = -1.0f;
  other.inputs.noise = InputNoise::Blue;
  inspector->shot().setSettings(other);
  EXPECT_TRUE(inspector->shot().isExact()) << "nothing of it counts";
  expectSame(all(*inspector), before);
  EXPECT_EQ(inspector->shot().settings().inputs.renderScale, 0.5f) << "what was set is there for a scene";
  EXPECT_EQ(inspector->shot().usedSettings().inputs.renderScale, 1.0f);
  inspector->shot().open("builtin:fan");
  EXPECT_EQ(inspector->shot().usedSettings().inputs.renderScale, 0.5f);
}

TEST_F(CapturedSceneTest, WhatACaptureHasNotIsRefusedInASentence) {
  const std::string folder = written("refused", Settings{});
  auto inspector = openedCapture(folder);
  InspectedShot& shot = inspector->shot();
  EXPECT_THROW(shot.setSize(64, 64), Error);
  EXPECT_THROW(shot.setCamera("orbit"), Error);
  EXPECT_THROW(shot.setObjectFilter({.hidden = {"fan"}, .isolated = {}}), Error);
  EXPECT_THROW(shot.setMotionModes({{"fan", MotionMode::None}}), Error);
  EXPECT_THROW(shot.setObjectClasses({{"fan", ObjectClass::Character}}), Error);
  EXPECT_THROW(shot.setCameraTrack({kFreeCamera, 0, {CameraPose{}}}), Error);
  EXPECT_THROW(inspector->reference().refine(16), Error);
  EXPECT_THROW(inspector->views().image(IntermediateId::engineOutput), Error);
  EXPECT_NO_THROW(shot.setFlownCameras({{}, kCaptureCamera}));
  EXPECT_EQ(shot.cameras(), std::vector<std::string>{kCaptureCamera});
  shot.seek(2);
  expectSame(all(*inspector), taa::test::small::fresh(Settings{}, 2));
}

TEST_F(CapturedSceneTest, AProbeThatFollowedASurfaceStaysOnItsPixel) {
  const std::string folder = written("probes", Settings{});
  auto inspector = openedCapture(folder);
  inspector->shot().seek(2);
  const Probe probe =
      inspector->probes().anchored({.pixel = {10, 10}, .follow = Follow::Surface, .frame = 2});
  EXPECT_EQ(probe.follow, Follow::Screen);
  EXPECT_EQ(inspector->probes().spot(probe).pixel, glm::ivec2(10, 10));
}

TEST_F(CapturedSceneTest, TheEnginesOutputIsARowLikeAnyOther) {
  const std::string folder = written("engine", Settings{}, true);
  auto inspector = openedCapture(folder);
  inspector->shot().seek(4);
  Views& views = inspector->views();
  const Image engine = views.image(IntermediateId::engineOutput), color = views.image(IntermediateId::color);
  const Image resolved = views.image(IntermediateId::resolved),
              difference = views.image(IntermediateId::engineDifferenceAbs);
  EXPECT_EQ(engine.pixels, color.pixels) << "what stands for it in this capture";
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      float most = 0.0f;
      for (int channel = 0; channel < 3; ++channel)
        most = std::max(most, std::abs(resolved.at(x, y)[channel] - engine.at(x, y)[channel]));
      ASSERT_EQ(*difference.at(x, y), most);
    }
  const PixelRecord record = inspector->probes().probe(7, 9);
  EXPECT_EQ(twin::at(record, IntermediateId::engineOutput).x, engine.at(7, 9)[0]);
  EXPECT_EQ(twin::at(record, IntermediateId::engineDifferenceAbs).x, *difference.at(7, 9));
}

TEST_F(CapturedSceneTest, ASceneThatIsOpenedAfterItHasTheSizeOfBefore) {
  const std::string folder = written("size", Settings{});
  auto inspector = std::make_unique<Inspector>();
  inspector->shot().setSize(32, 20);
  inspector->shot().open("builtin:fan");
  inspector->shot().open(folder + "/capture.json");
  EXPECT_EQ(inspector->shot().width(), kWidth);
  inspector->shot().open("builtin:fence");
  EXPECT_EQ(inspector->shot().width(), 32);
  EXPECT_EQ(inspector->shot().height(), 20);
}

// The command line takes a capture as it takes a scene, and says what would have no effect.
TEST_F(CapturedSceneTest, IsProbedFromTheCommandLine) {
  const std::vector<std::string> probe = {
      "probe", written("batch", Settings{}), "--pixel", "7,9", "--frame", "4", "--json"};
  const auto expectProbed = [&](const std::vector<std::string>& more) {
    const test::ProcessResult result = test::batch(test::joined(probe, more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.out.find("\"resolved\""), std::string::npos);
  };
  expectProbed({});
  expectProbed({"--size", "48x27"}); // its own
  test::expectUsageError(test::joined(probe, {"--size", "64x36"}), {"--size 64x36"});
  expectProbed({"--set", "rectify.method=clamp", "--set", "inputs.precision=full"});
  for (const std::string fixed : {"jitter.sequence=r2", "inputs.renderScale=0.5", "inputs.noise=blueNoise"})
    test::expectUsageError(test::joined(probe, {"--set", fixed}), {"--set " + fixed});
  test::expectUsageError(test::joined(probe, {"--camera", "orbit"}), {"--camera"});
}
