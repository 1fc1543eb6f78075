// The façade: what going through time resolves and draws, and what it leaves alone.
#include "tests/support/SmallInspector.h"

#include "core/base/Error.h"
#include "core/render/JitterWay.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace {

using taa::allRows;
using taa::Image;
using taa::Inspector;
using taa::IntermediateId;
using taa::Settings;
using taa::test::otherJitter;
using taa::test::small::expectSame;
using taa::test::small::fresh;
using taa::test::small::isSame;
using taa::test::small::kHeight;
using taa::test::small::kWidth;
using taa::test::small::otherSettings;

class InspectorTimeTest : public taa::test::small::InspectorTest {};

/// How many frames a seek replays: it tells of each.
int replayed(Inspector& inspector, int frame) {
  const int expected = inspector.shot().replayLength(frame);
  int count = 0;
  inspector.shot().seek(frame, [&](std::string_view, int, int all) {
    EXPECT_EQ(all, expected);
    ++count;
    return true;
  });
  EXPECT_EQ(count, expected) << "to frame " << frame;
  return count;
}

/// Bytes of a history of the default settings: RGBA16F and RG32F.
constexpr std::size_t kHistoryBytes = std::size_t(kWidth) * kHeight * (8 + 8);

} // namespace

// Techniques: 1.8.
TEST_F(InspectorTimeTest, ReachesTheSameFrameByPlayingSeekingAndSteppingBack) {
  const std::vector<Image> expected = fresh({}, 6);
  const auto inspector = opened();
  for (int frame = 1; frame <= 6; ++frame) inspector->shot().advance();
  expectSame(inspector->views().images(allRows()), expected);
  for (int frame = 7; frame <= 11; ++frame) inspector->shot().seek(frame);
  for (int frame = 10; frame >= 6; --frame) inspector->shot().seek(frame);
  expectSame(inspector->views().images(allRows()), expected);
  inspector->shot().seek(20);
  inspector->shot().seek(6);
  expectSame(inspector->views().images(allRows()), expected);
  EXPECT_EQ(inspector->shot().frame(), 6);
}

// Also one that follows the camera: it is told without drawing, for the lane that is asked of.
TEST_F(InspectorTimeTest, TellsTheJitterThatIsDrawn) {
  Settings across;
  taa::applyAssignment(across, "jitter.sequence=perpendicular");
  const auto inspector = opened();
  inspector->shot().setLanes({Settings{}, across});
  for (const int frame : {0, 1, 9, 8}) {
    inspector->shot().seek(frame);
    for (int lane = 0; lane < 2; ++lane)
      EXPECT_EQ(inspector->shot().info(lane).jitterPx, inspector->views().inputs(lane).info.jitterPx) << lane;
  }
  EXPECT_NE(inspector->shot().info(1).jitterWay, taa::kFirstWay);
}

TEST_F(InspectorTimeTest, ReplaysOneFrameForAStepAndNoneForAStepBack) {
  const auto inspector = opened();
  EXPECT_EQ(replayed(*inspector, 8), 8) << "frame 0 is there already";
  EXPECT_EQ(replayed(*inspector, 9), 1);
  EXPECT_EQ(replayed(*inspector, 8), 0);
  EXPECT_EQ(replayed(*inspector, 7), 0);
  EXPECT_EQ(replayed(*inspector, 0), 0);
  EXPECT_EQ(replayed(*inspector, 9), 0) << "and on again";
}

TEST_F(InspectorTimeTest, RestoresWithoutDrawingWhatIsNotLookedAt) {
  const std::vector<Image> expected = fresh({}, 6), next = fresh({}, 7);
  const auto inspector = opened();
  inspector->views().watch({IntermediateId::resolved, IntermediateId::historyLength, IntermediateId::output});
  inspector->shot().seek(9);
  inspector->shot().seek(6);
  EXPECT_EQ(inspector->shot().info().frame, 6);
  EXPECT_EQ(inspector->shot().info().jitterPx, inspector->views().inputs().info.jitterPx);
  inspector->shot().seek(5);
  inspector->shot().seek(6);
  for (const IntermediateId id :
       {IntermediateId::resolved, IntermediateId::historyLength, IntermediateId::output})
    EXPECT_TRUE(isSame(inspector->views().image(id), expected[static_cast<std::size_t>(id)]))
        << taa::intermediate(id).name;
  EXPECT_TRUE(isSame(inspector->views().images({IntermediateId::resolved}).front(),
                     expected[static_cast<std::size_t>(IntermediateId::resolved)]));
  EXPECT_EQ(inspector->shot().times().scene, 0.0) << "nothing was drawn";
  EXPECT_EQ(inspector->shot().times().resolve, 0.0);
  const taa::PixelRecord record = inspector->probes().probe(20, 9);
  EXPECT_GT(inspector->shot().times().scene, 0.0) << "now it is";
  for (const taa::Intermediate& row : taa::kResolveRows)
    EXPECT_EQ(record[static_cast<std::size_t>(row.id)],
              expected[static_cast<std::size_t>(row.id)].texel(20, 9))
        << row.name;
  for (const taa::Intermediate& row : taa::kResolveRows)
    EXPECT_TRUE(isSame(inspector->views().image(row.id), expected[static_cast<std::size_t>(row.id)]))
        << row.name;
  inspector->shot().seek(5);
  inspector->shot().seek(6);
  inspector->shot().advance();
  expectSame(inspector->views().images(allRows()), next);
}

TEST_F(InspectorTimeTest, RestoresWhatIsShownOfThePictureToo) {
  Settings sharp = otherSettings();
  taa::applyAssignment(sharp, "output.sharpen=rcas");
  Settings exact;
  taa::applyAssignment(exact, "history.precision=full");
  Settings coarse;
  taa::applyAssignment(coarse, "history.precision=unorm8");
  for (const Settings& settings : {sharp, exact, coarse}) {
    const auto inspector = opened({settings});
    inspector->shot().seek(7);
    inspector->shot().seek(6);
    const std::vector<Image> expected = fresh(settings, 6);
    for (const IntermediateId id :
         {IntermediateId::output, IntermediateId::resolved, IntermediateId::historyLength})
      EXPECT_TRUE(isSame(inspector->views().image(id), expected[static_cast<std::size_t>(id)]))
          << taa::intermediate(id).name;
  }
}

TEST_F(InspectorTimeTest, DrawsNothingAnewForSettingsOfTheResolve) {
  const auto inspector = opened({Settings{}, Settings{}});
  inspector->shot().seek(6);
  const std::vector<Image> second = inspector->views().images(allRows(), 1);
  inspector->shot().setSettings(otherSettings(), 0);
  EXPECT_EQ(inspector->shot().times().scene, 0.0);
  EXPECT_GT(inspector->shot().times().resolve, 0.0);
  EXPECT_EQ(&inspector->views().inputs(0), &inspector->views().inputs(1));
  expectSame(inspector->views().images(allRows(), 1), second);
  inspector->shot().setSettings(otherJitter(), 0);
  EXPECT_GT(inspector->shot().times().scene, 0.0);
  EXPECT_NE(&inspector->views().inputs(0), &inspector->views().inputs(1));
  expectSame(inspector->views().images(allRows(), 1), second);
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows(), 0), fresh(otherJitter(), 6));
  expectSame(inspector->views().images(allRows(), 1), second);
}

TEST_F(InspectorTimeTest, StaysExactWhenOnlyWhatIsShownOfThePictureChanges) {
  Settings sharp;
  taa::applyAssignment(sharp, "output.sharpen=rcas");
  const auto inspector = opened();
  inspector->views().watch({IntermediateId::output});
  inspector->shot().seek(6);
  const Image blurry = inspector->views().image(IntermediateId::output);
  inspector->shot().setSettings(sharp);
  EXPECT_TRUE(inspector->shot().isExact());
  EXPECT_EQ(inspector->shot().times().scene, 0.0);
  EXPECT_FALSE(isSame(inspector->views().image(IntermediateId::output), blurry));
  expectSame(inspector->views().images(allRows()), fresh(sharp, 6));
  EXPECT_EQ(replayed(*inspector, 5), 0);
  expectSame(inspector->views().images(allRows()), fresh(sharp, 5));
}

TEST_F(InspectorTimeTest, GoesAnywhereInAPlayedShotWithinSixteenFrames) {
  const auto inspector = opened();
  EXPECT_EQ(inspector->shot().checkpointBudget(), std::size_t(1) << 30);
  // As many histories as the default budget holds of 1280 × 720.
  inspector->shot().setCheckpointBudget(kHistoryBytes *
                                        (inspector->shot().checkpointBudget() / (1280 * 720 * 16)));
  ASSERT_EQ(inspector->shot().frameCount(), 240);
  while (inspector->shot().frame() < 239) inspector->shot().advance();
  for (int back = 1; back <= 16; ++back) EXPECT_EQ(replayed(*inspector, 239 - back), 0);
  EXPECT_EQ(replayed(*inspector, 239), 0);
  std::vector<int> lengths;
  for (int seek = 0; seek < 80; ++seek) lengths.push_back(replayed(*inspector, (seek * 89 + 40) % 240));
  std::ranges::sort(lengths);
  EXPECT_LE(lengths.back(), 16);
  EXPECT_LE(lengths[lengths.size() / 2], 8);
  EXPECT_EQ(replayed(*inspector, 0), 0);
  EXPECT_EQ(replayed(*inspector, 239), 0);
}

TEST_F(InspectorTimeTest, KnowsTheNearestCachedFrame) {
  const auto inspector = opened();
  EXPECT_EQ(inspector->shot().nearestCached(0), 0);
  EXPECT_EQ(inspector->shot().nearestCached(100), 1) << "one frame from the first";
  inspector->shot().seek(30);
  EXPECT_EQ(inspector->shot().nearestCached(12), 12);
  EXPECT_EQ(inspector->shot().nearestCached(200), 31);
  EXPECT_EQ(inspector->shot().replayLength(200), 170);
  EXPECT_LE(replayed(*inspector, 31), 1);
}

TEST_F(InspectorTimeTest, ReplaysFromTheStartWhenNothingMayBeKept) {
  const std::vector<Image> expected = fresh({}, 4);
  const auto inspector = opened();
  inspector->shot().seek(9);
  inspector->shot().setCheckpointBudget(0);
  EXPECT_EQ(replayed(*inspector, 10), 1) << "the histories in use stay";
  EXPECT_EQ(replayed(*inspector, 4), 5);
  expectSame(inspector->views().images(allRows()), expected);
}

TEST_F(InspectorTimeTest, ReplaysAPartOfTheShotWhenSomeHistoriesFit) {
  const auto inspector = opened();
  inspector->shot().setCheckpointBudget(12 * kHistoryBytes);
  inspector->shot().seek(100);
  EXPECT_EQ(replayed(*inspector, 99), 0);
  // Six anchors over 240 frames: one each 40.
  EXPECT_EQ(inspector->shot().frameCount(), 240);
  EXPECT_LE(replayed(*inspector, 79), 40);
}

TEST_F(InspectorTimeTest, SharesTheBudgetSoThatEveryLaneKeepsAsManyFrames) {
  Settings full; // 32 bytes a pixel instead of 24: color, N and depth, motion
  taa::applyAssignment(full, "history.precision=full");
  constexpr std::size_t kPixels = std::size_t(kWidth) * kHeight;
  const auto inspector = opened();
  inspector->shot().setCheckpointBudget(10 * (24 + 32) * kPixels);
  inspector->shot().setLanes({Settings{}, full});
  inspector->shot().seek(40);
  EXPECT_EQ(inspector->shot().keptFrames().size(), 10u);
  // Lanes that come take their share from those that are there.
  inspector->shot().changeLanes({Settings{}, full, full, full});
  inspector->shot().refine();
  EXPECT_EQ(inspector->shot().keptFrames().size(), 10u * (24 + 32) / (24 + 3 * 32));
  inspector->profiler().setProfiling(true);
  inspector->shot().seek(41);
  const auto profile = inspector->profiler().takeProfile();
  ASSERT_TRUE(profile);
  EXPECT_LE(profile->checkpointBytes, inspector->shot().checkpointBudget());
  EXPECT_GE(profile->checkpointBytes, inspector->shot().checkpointBudget() / 2);
}

TEST_F(InspectorTimeTest, StaysWhereItWasWhenASeekIsCancelled) {
  const auto inspector = opened();
  inspector->views().watch({IntermediateId::alpha});
  inspector->shot().seek(3);
  const std::vector<Image> before = inspector->views().images(allRows());
  EXPECT_THROW(inspector->shot().seek(12, [](std::string_view, int done, int) { return done < 4; }),
               taa::Cancelled);
  EXPECT_EQ(inspector->shot().frame(), 3);
  expectSame(inspector->views().images(allRows()), before);
  EXPECT_EQ(replayed(*inspector, 12), 5) << "what was replayed is kept";
  expectSame(inspector->views().images(allRows()), fresh({}, 12));
}
