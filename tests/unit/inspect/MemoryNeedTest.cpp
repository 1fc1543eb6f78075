// What a picture takes is added up from its formats, and refused in words when it is not there.
#include "core/inspect/MemoryNeed.h"

#include "core/base/FreeMemory.h"
#include "core/scene/Scene.h"
#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace taa {
namespace {

constexpr std::size_t kPixels = 100 * 50;

MemoryNeed needOf(const std::vector<std::string>& assignments,
                  const std::vector<IntermediateId>& watched = {}) {
  Settings settings;
  for (const std::string& assignment : assignments) applyAssignment(settings, assignment);
  return memoryNeed({settings}, {100, 50}, watched);
}

// Bytes of a pixel of the inputs: color 8 or 16, motion 4 or 8, normal 8, object id 4, two depths of 4.
TEST(MemoryNeed, CountsTheInputsOfTwoFramesInTheFormatsTheyHave) {
  EXPECT_EQ(needOf({"inputs.precision=half"}).inputs, 2 * 32 * kPixels);
  EXPECT_EQ(needOf({"inputs.precision=full"}).inputs, 2 * 44 * kPixels);
  EXPECT_EQ(needOf({"inputs.mask=material"}).inputs, 2 * 34 * kPixels);
  EXPECT_EQ(needOf({"inputs.mask=autoReactive"}).inputs, (2 * 34 + 8) * kPixels);
  EXPECT_EQ(needOf({"inputs.blended=after"}).inputs, 2 * 40 * kPixels);
  EXPECT_EQ(needOf({"inputs.noise=blueNoise"}).inputs, (2 * 32 + 8) * kPixels);
  EXPECT_EQ(needOf({"inputs.range=ldr"}).inputs, (2 * 32 + 8) * kPixels);
  EXPECT_EQ(needOf({"inputs.renderScale=0.5"}).inputs, 2 * 32 * kPixels / 4);
}

// Of a scene with fog: what it adds, kept with the frame, and before that is done as it was marched and the
// color that is drawn into; with a history also the mean of the frames before. 8 bytes a pixel each.
TEST(MemoryNeed, CountsFogWhereTheSceneHasSome) {
  Scene scene;
  scene.fog.emplace_back();
  const auto inputs = [&](const char* assignment) {
    Settings settings;
    applyAssignment(settings, assignment);
    return memoryNeed({settings}, {100, 50}, {}, &scene).inputs;
  };
  EXPECT_EQ(inputs("inputs.fogSteps=4"), (2 * 40 + 16) * kPixels);
  EXPECT_EQ(inputs("inputs.fogHistory=clamped"), (2 * 40 + 24) * kPixels);
  EXPECT_EQ(inputs("inputs.fogDensity=0"), 2 * 32 * kPixels);
}

// One map of 2,048² depths for all lanes, where there is a sun to cast shadows and they are wanted.
TEST(MemoryNeed, CountsTheShadowMapWhereSomethingCastsShadows) {
  constexpr std::size_t kMap = std::size_t{2048} * 2048 * 4;
  Scene scene;
  const auto inputs = [&](Shadows shadows) {
    Settings settings;
    settings.inputs.shadows = shadows;
    return memoryNeed({settings, settings}, {100, 50}, {}, &scene).inputs;
  };
  const std::size_t none = inputs(Shadows::None);
  EXPECT_EQ(inputs(Shadows::Hard), none + kMap);
  EXPECT_EQ(inputs(Shadows::AsScene), none) << "a scene wants none unless it says so";
  scene.sky.shadows = SunShadows::Soft;
  EXPECT_EQ(inputs(Shadows::AsScene), none + kMap);
  scene.sky.sunEnabled = false;
  EXPECT_EQ(inputs(Shadows::AsScene), none);
  EXPECT_EQ(inputs(Shadows::Soft), none);
}

// Color 8 or 16, surface 8, and the layers that settings ask for: motion 8 for the depth test at rest,
// object 8.
TEST(MemoryNeed, CountsTheHistoriesThatLivePlayingAtOnce) {
  EXPECT_EQ(needOf({"history.precision=half", "validate.depth=off"}).histories, 7 * 16 * kPixels);
  EXPECT_EQ(needOf({"history.precision=full", "validate.depth=off"}).histories, 7 * 24 * kPixels);
  EXPECT_EQ(needOf({"history.precision=half"}).histories, 7 * 24 * kPixels);
  EXPECT_EQ(needOf({"history.precision=half", "validate.object=on"}).histories, 7 * 32 * kPixels);
  EXPECT_EQ(needOf({"inputs.renderScale=0.5"}).histories, needOf({}).histories)
      << "they have the picture's size";
}

TEST(MemoryNeed, CountsWhatIsWatchedInBothFrames) {
  EXPECT_EQ(needOf({}).intermediates, 0u);
  EXPECT_EQ(needOf({}, {IntermediateId::historyRaw}).intermediates, 2 * 16 * kPixels)
      << "three channels are stored in four";
  EXPECT_EQ(needOf({}, {IntermediateId::historyRaw, IntermediateId::alpha}).intermediates, 2 * 20 * kPixels);
  EXPECT_EQ(needOf({}, {IntermediateId::resolved, IntermediateId::color}).intermediates, 0u)
      << "what is read in place takes nothing";
  EXPECT_EQ(needOf({"inputs.renderScale=0.5"}, {IntermediateId::color}).intermediates, 2 * 16 * kPixels)
      << "not of another size";
  EXPECT_EQ(needOf({}, {IntermediateId::lock, IntermediateId::alphaMotion}).intermediates, 2 * 4 * kPixels)
      << "both are 0: one layer";
}

TEST(MemoryNeed, CountsSharedInputsOnce) {
  Settings other;
  applyAssignment(other, "rectify.method=clamp");
  Settings elsewhere;
  applyAssignment(elsewhere, "jitter.period=8");
  const std::size_t one = memoryNeed({Settings{}}, {100, 50}, {}).inputs;
  EXPECT_EQ(memoryNeed({Settings{}, other}, {100, 50}, {}).inputs, one);
  EXPECT_EQ(memoryNeed({Settings{}, elsewhere}, {100, 50}, {}).inputs, 2 * one);
  EXPECT_EQ(memoryNeed({Settings{}, other}, {100, 50}, {}).histories, (2 * 3 + 4) * needOf({}).histories / 7);
}

// It is drawn at full size in 32-bit floats, lane after lane; rows have 16 or 4 bytes a pixel.
TEST(MemoryNeed, CountsTheReferenceWhereItIsWatched) {
  using enum IntermediateId;
  EXPECT_EQ(needOf({}, {resolved}).reference, 0u);
  EXPECT_EQ(needOf({}, {IntermediateId::reference, resolved}).reference, (44 + 16) * kPixels);
  EXPECT_EQ(needOf({}, {IntermediateId::reference, alpha}).intermediates, needOf({}, {alpha}).intermediates);
  EXPECT_EQ(needOf({"inputs.renderScale=0.5"}, {referenceError}).reference, (44 + 4) * kPixels);
  EXPECT_EQ(memoryNeed({Settings{}, Settings{}}, {100, 50}, {referenceError, referenceErrorAbs}).reference,
            (44 + 2 * (4 + 4)) * kPixels);
}

// Sixteen frames of main memory: what is shown twice and the steps; of parts four errors, what was kept and
// where history was read.
TEST(MemoryNeed, CountsTheFramesOfRowsOverTime) {
  using enum IntermediateId;
  const std::size_t drawn = 44 + 4; // the reference, and the row
  EXPECT_EQ(needOf({}, {flicker}).reference, (drawn + 16 * 4 * (6 + 4)) * kPixels);
  EXPECT_EQ(needOf({}, {errorGhost}).reference, (drawn + 16 * 4 * (19 + 4)) * kPixels);
  EXPECT_EQ(needOf({}, {flicker, errorGhost}).reference, (drawn + 4 + 16 * 4 * (6 + 19 + 4)) * kPixels)
      << "the steps are those of both";
}

TEST(MemoryNeed, IsRefusedInWordsWhereTheReferenceDoesNotFit) {
  const MemoryNeed need{1u << 20, 1u << 20, 1u << 20, 7u << 20};
  EXPECT_EQ(
      memoryRefusal(need, {64, 48}, 9u << 20),
      "cannot use a picture of 64 × 48 pixels: it takes about 10 MiB of memory (inputs 1 MiB, histories 1 "
      "MiB, intermediates 1 MiB, reference 7 MiB) and 9 MiB are free; choose a smaller size, fewer lanes or "
      "fewer views");
  EXPECT_EQ(referenceRefusal(7u << 20, {64, 48}, 7u << 20), "");
  EXPECT_EQ(
      referenceRefusal(7u << 20, {64, 48}, 6u << 20),
      "cannot draw the reference of a picture of 64 × 48 pixels: it takes about 7 MiB of memory and 6 MiB "
      "are free; choose a smaller size");
}

TEST(MemoryNeed, IsRefusedInWordsWhereItIsNotThere) {
  const MemoryNeed need{3u << 20, 5u << 20, std::size_t(2) << 30, 0};
  EXPECT_EQ(memoryRefusal(need, {640, 480}, need.total()), "");
  EXPECT_EQ(
      memoryRefusal(need, {640, 480}, need.total() - 1),
      "cannot use a picture of 640 × 480 pixels: it takes about 2.0 GiB of memory (inputs 3 MiB, histories 5 "
      "MiB, intermediates 2.0 GiB) and 2.0 GiB are free; choose a smaller size, fewer lanes or fewer views");
}

TEST(MemoryNeed, IsSaidInMebibytesAndGibibytes) {
  EXPECT_EQ(bytesText(0), "0 MiB");
  EXPECT_EQ(bytesText((std::size_t(1) << 30) - (1u << 20)), "1023 MiB");
  EXPECT_EQ(bytesText(std::size_t(5) << 29), "2.5 GiB");
}

TEST(FreeMemory, IsWhatTheSystemSays) {
  EXPECT_EQ(availableIn("MemTotal:  9 kB\nMemFree: 1 kB\nMemAvailable:    3 kB\nBuffers: 7 kB\n"), 3072u);
  EXPECT_EQ(availableIn("MemTotal:  9 kB\n"), std::nullopt);
  EXPECT_EQ(availableIn("MemAvailable: none"), std::nullopt);
  EXPECT_EQ(availableIn(""), std::nullopt);
  ASSERT_TRUE(freeMemory());
  EXPECT_GT(*freeMemory(), std::size_t(1) << 20);
  EXPECT_LT(*freeMemory(), std::size_t(1) << 46);
}

} // namespace
} // namespace taa
