// The façade: settings, lanes and looking, on a small picture.
#include "tests/support/SmallInspector.h"

#include "core/base/Error.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace {

using taa::allRows;
using taa::Image;
using taa::IntermediateId;
using taa::Settings;
using taa::test::otherJitter;
using taa::test::small::expectSame;
using taa::test::small::fresh;
using taa::test::small::isSame;
using taa::test::small::kHeight;
using taa::test::small::kWidth;
using taa::test::small::otherSettings;

using InspectorTest = taa::test::small::InspectorTest;

} // namespace

TEST_F(InspectorTest, OpensASourceAtFrameZeroWithItsOwnCamera) {
  const auto inspector = opened();
  EXPECT_EQ(inspector->shot().source(), "builtin:fan");
  EXPECT_EQ(inspector->shot().frame(), 0);
  EXPECT_EQ(inspector->shot().camera(), inspector->shot().scene().shot.camera);
  EXPECT_EQ(inspector->shot().width(), kWidth);
  EXPECT_TRUE(inspector->shot().isExact());
  EXPECT_TRUE(inspector->shot().info().startsHistory);
  EXPECT_GT(inspector->shot().times().scene, 0.0);
  EXPECT_GT(inspector->shot().times().resolve, 0.0);
}

TEST_F(InspectorTest, TellsOfEachProgramThatItCompilesWhileItOpens) {
  const auto inspector = opened();
  std::vector<int> steps;
  int total = 0;
  inspector->shot().open("builtin:fan", [&](std::string_view what, int done, int all) {
    if (what != "Compiling shaders") return true;
    steps.push_back(done);
    total = all;
    return true;
  });
  ASSERT_GE(steps.size(), 4u) << "two programs at least, compiled and drawn";
  for (std::size_t step = 0; step < steps.size(); ++step) EXPECT_EQ(steps[step], static_cast<int>(step));
  EXPECT_EQ(total, static_cast<int>(steps.size()) + 1) << "the first frame comes after them";
  inspector->shot().seek(2);
  for (const int last : {1, total / 2 + 1}) { // among those compiled, and those drawn
    const auto stops = [last](std::string_view what, int done, int) {
      return what != "Compiling shaders" || done < last;
    };
    EXPECT_THROW(inspector->shot().open("builtin:fan", stops), taa::Cancelled);
    EXPECT_EQ(inspector->shot().frame(), 2);
  }
}

TEST_F(InspectorTest, KeepsItsStateWhenSomethingCannotBeDone) {
  const auto inspector = opened();
  inspector->shot().seek(2);
  const std::vector<Image> before = inspector->views().images(allRows());
  EXPECT_THROW(inspector->shot().seek(-1), taa::Error);
  EXPECT_THROW(inspector->shot().seek(inspector->shot().frameCount()), taa::Error);
  EXPECT_THROW(inspector->shot().open("no/such/model.glb"), taa::Error);
  EXPECT_THROW(inspector->shot().open("builtin:nothing"), taa::Error);
  EXPECT_THROW(inspector->shot().setCamera("backwards"), taa::Error);
  EXPECT_THROW(inspector->shot().setSize(3, 100), taa::Error);
  EXPECT_THROW(inspector->shot().setSize(1 << 20, 100), taa::Error);
  EXPECT_THROW(inspector->shot().setLanes({}), taa::Error);
  EXPECT_THROW(inspector->shot().setLanes(std::vector<Settings>(taa::kMaxLanes + 1)), taa::Error);
  EXPECT_THROW(inspector->probes().probe(kWidth, 0), taa::Error);
  EXPECT_THROW(inspector->probes().probe(0, -1), taa::Error);
  EXPECT_EQ(inspector->shot().source(), "builtin:fan");
  EXPECT_EQ(inspector->shot().frame(), 2);
  EXPECT_EQ(inspector->shot().laneCount(), 1);
  expectSame(inspector->views().images(allRows()), before);
  inspector->shot().seek(3);
  expectSame(inspector->views().images(allRows()), fresh({}, 3));
}

TEST_F(InspectorTest, RefusesAPictureThatDoesNotFitIntoMemory) {
  const auto inspector = opened();
  if (!inspector->shot().driver().isSoftware) GTEST_SKIP() << "a GPU's driver decides by itself";
  const int most = inspector->shot().driver().maxTextureSize;
  try {
    inspector->shot().setSize(most, most);
    FAIL() << "a picture of " << most << " pixels a side was accepted";
  } catch (const taa::Error& error) {
    EXPECT_NE(std::string(error.what()).find("memory"), std::string::npos) << error.what();
  }
  EXPECT_EQ(inspector->shot().width(), kWidth);
}

TEST_F(InspectorTest, AnswersNewSettingsAtOnceAndExactlyLater) {
  const std::vector<Image> exact = fresh(otherSettings(), 9);
  const auto inspector = opened();
  inspector->shot().seek(9);
  const std::vector<Image> old = inspector->views().images(allRows());
  inspector->shot().setSettings(otherSettings());
  EXPECT_EQ(inspector->shot().frame(), 9);
  EXPECT_FALSE(inspector->shot().isExact());
  const std::vector<Image> atOnce = inspector->views().images(allRows());
  const auto at = [](const std::vector<Image>& images, IntermediateId id) {
    return images[static_cast<std::size_t>(id)];
  };
  EXPECT_TRUE(isSame(at(atOnce, IntermediateId::historyRaw), at(old, IntermediateId::historyRaw)));
  EXPECT_FALSE(
      isSame(at(atOnce, IntermediateId::historyRectified), at(old, IntermediateId::historyRectified)));
  inspector->shot().refine();
  EXPECT_TRUE(inspector->shot().isExact());
  expectSame(inspector->views().images(allRows()), exact);
}

TEST_F(InspectorTest, KeepsTheOldPictureWhenRefiningIsCancelled) {
  const auto inspector = opened();
  inspector->shot().seek(9);
  inspector->shot().setSettings(otherJitter());
  const std::vector<Image> atOnce = inspector->views().images(allRows());
  EXPECT_THROW(inspector->shot().refine([](std::string_view, int done, int) { return done < 5; }),
               taa::Cancelled);
  EXPECT_FALSE(inspector->shot().isExact());
  expectSame(inspector->views().images(allRows()), atOnce);
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows()), fresh(otherJitter(), 9));
}

TEST_F(InspectorTest, PlaysOnFromInexactHistoryUntilOneStartsAnew) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  inspector->shot().setSettings(otherSettings());
  inspector->shot().advance();
  EXPECT_EQ(inspector->shot().frame(), 6);
  EXPECT_FALSE(inspector->shot().isExact());
  inspector->shot().advance();
  EXPECT_FALSE(inspector->shot().isExact());
  inspector->shot().seek(0);
  EXPECT_TRUE(inspector->shot().isExact());
  inspector->shot().advance();
  EXPECT_TRUE(inspector->shot().isExact());
  expectSame(inspector->views().images(allRows()), fresh(otherSettings(), 1));
  inspector->shot().seek(6);
  expectSame(inspector->views().images(allRows()), fresh(otherSettings(), 6));
}

TEST_F(InspectorTest, IsExactAtOnceWhereNoHistoryIsUsed) {
  const auto inspector = opened();
  inspector->shot().setSettings(otherJitter());
  EXPECT_TRUE(inspector->shot().isExact());
  inspector->shot().setCamera("pan");
  EXPECT_TRUE(inspector->shot().isExact());
  inspector->shot().seek(1);
  inspector->shot().setCamera("dolly");
  EXPECT_FALSE(inspector->shot().isExact());
}

TEST_F(InspectorTest, DrawsAnotherSizeOrCameraAsIfItHadAlwaysBeen) {
  const auto inspector = opened();
  inspector->shot().seek(4);
  inspector->shot().setSize(kWidth + 7, kHeight + 2);
  inspector->shot().setCamera("pan");
  EXPECT_EQ(inspector->views().image(IntermediateId::resolved).width, kWidth + 7);
  EXPECT_FALSE(inspector->shot().isExact());
  inspector->shot().setSize(kWidth, kHeight);
  inspector->shot().setCamera(inspector->shot().scene().shot.camera);
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows()), fresh({}, 4));
}

TEST_F(InspectorTest, GivesObjectsTheMotionThatIsChosenAndRefusesUnknownOnes) {
  const auto inspector = opened();
  inspector->shot().seek(4);
  const Image own = inspector->views().image(IntermediateId::motion);
  const std::vector<Image> before = inspector->views().images(allRows());
  inspector->shot().setMotionModes({{"rotor", taa::MotionMode::None}});
  EXPECT_FALSE(inspector->shot().isExact()) << "the history is from the motion before";
  inspector->shot().refine();
  const std::vector<Image> forced = inspector->views().images(allRows());
  EXPECT_FALSE(isSame(inspector->views().image(IntermediateId::motion), own));
  EXPECT_THROW(inspector->shot().setMotionModes({{"nobody", taa::MotionMode::None}}), taa::Error);
  EXPECT_EQ(inspector->shot().motionModes(),
            (std::vector<taa::MotionOverride>{{"rotor", taa::MotionMode::None}}));
  inspector->shot().seek(7);
  inspector->shot().seek(4);
  expectSame(inspector->views().images(allRows()), forced);
  inspector->shot().setMotionModes({});
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows()), before);
}

TEST_F(InspectorTest, RunsLanesAsIfEachWereAlone) {
  const std::vector<Settings> lanes = {Settings{}, otherSettings(), otherJitter()};
  std::vector<std::vector<Image>> alone;
  alone.reserve(lanes.size());
  for (const Settings& settings : lanes) alone.push_back(fresh(settings, 5));
  const auto inspector = opened(lanes);
  inspector->views().watch({IntermediateId::alpha});
  inspector->shot().seek(2);
  for (int frame = 3; frame <= 5; ++frame) inspector->shot().advance();
  for (int lane = 0; lane < 3; ++lane)
    expectSame(inspector->views().images(allRows(), lane), alone[static_cast<std::size_t>(lane)]);
  EXPECT_EQ(&inspector->views().inputs(0), &inspector->views().inputs(1)) << "drawn once";
  EXPECT_NE(&inspector->views().inputs(0), &inspector->views().inputs(2)) << "another jitter";
  EXPECT_EQ(inspector->shot().info(2).jitterIndex, 5);
}

TEST_F(InspectorTest, ChangesOneLaneAndLeavesTheOthersExact) {
  const auto inspector = opened({Settings{}, Settings{}});
  inspector->shot().seek(4);
  const std::vector<Image> first = inspector->views().images(allRows(), 0);
  inspector->shot().setSettings(otherJitter(), 1);
  EXPECT_TRUE(inspector->shot().isExact(0));
  EXPECT_FALSE(inspector->shot().isExact(1));
  expectSame(inspector->views().images(allRows(), 0), first);
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows(), 0), first);
  expectSame(inspector->views().images(allRows(), 1), fresh(otherJitter(), 4));
}

TEST_F(InspectorTest, AddsALaneThatIsExactFromTheStart) {
  const auto inspector = opened();
  inspector->shot().seek(4);
  inspector->shot().setLanes({Settings{}, otherSettings()});
  EXPECT_EQ(inspector->shot().laneCount(), 2);
  EXPECT_EQ(inspector->shot().frame(), 4);
  expectSame(inspector->views().images(allRows(), 1), fresh(otherSettings(), 4));
}

TEST_F(InspectorTest, LooksWithoutChangingWhatItLooksAt) {
  const std::vector<std::vector<IntermediateId>> watched = {{}, {IntermediateId::clipAmount}, allRows()};
  std::vector<std::vector<Image>> resolved, clipped;
  for (const auto& ids : watched) {
    const auto inspector = opened();
    inspector->views().watch(ids);
    resolved.emplace_back();
    clipped.emplace_back();
    for (int frame = 0; frame < 6; ++frame) {
      if (frame > 0) inspector->shot().advance();
      resolved.back().push_back(inspector->views().image(IntermediateId::resolved));
      clipped.back().push_back(inspector->views().image(IntermediateId::clipAmount));
      inspector->probes().probe(3, 4);
    }
  }
  for (std::size_t frame = 0; frame < 6; ++frame)
    for (std::size_t other = 1; other < watched.size(); ++other) {
      EXPECT_TRUE(isSame(resolved[other][frame], resolved[0][frame])) << frame;
      EXPECT_TRUE(isSame(clipped[other][frame], clipped[0][frame])) << frame;
    }
}

TEST_F(InspectorTest, GivesTheSameValuesHoweverTheyAreAskedFor) {
  const auto inspector = opened();
  inspector->views().watch({IntermediateId::boxMin});
  inspector->shot().seek(3);
  const std::vector<Image> all = inspector->views().images(allRows());
  const taa::gl::Rect part{5, 6, 11, 3};
  // One of each number of channels and of each way to be held: every set of ids is a program to compile.
  for (IntermediateId id : {IntermediateId::boxMin, IntermediateId::color, IntermediateId::motion,
                            IntermediateId::objectId, IntermediateId::resolved}) {
    const Image& whole = all[static_cast<std::size_t>(id)];
    EXPECT_TRUE(isSame(inspector->views().image(id), whole)) << taa::intermediate(id).name;
    const Image cut = inspector->views().image(id, 0, part);
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        EXPECT_EQ(cut.texel(x, y), whole.texel(part.x + x, part.y + y)) << taa::intermediate(id).name;
  }
}

TEST_F(InspectorTest, ProbesWhatThePictureShows) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  const std::vector<Image> all = inspector->views().images(allRows());
  for (int sample = 0; sample < 12; ++sample) {
    const int x = (sample * 29) % kWidth, y = (sample * 17) % kHeight;
    const taa::PixelRecord record = inspector->probes().probe(x, y);
    for (std::size_t index = 0; index < all.size(); ++index)
      EXPECT_EQ(record[index], all[index].texel(x, y)) << taa::kResolveRows[index].name;
  }
  const std::vector<taa::PixelRecord> corner = inspector->probes().probeAround(0, kHeight - 1, 1);
  ASSERT_EQ(corner.size(), 9u);
  const Image& color = all[static_cast<std::size_t>(IntermediateId::color)];
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int index = (dy + 1) * 3 + dx + 1;
      EXPECT_EQ(taa::twin::at(corner.at(static_cast<std::size_t>(index)), IntermediateId::color),
                color.texel(std::max(dx, 0), kHeight - 1 + std::min(dy, 0)));
    }
}

TEST_F(InspectorTest, ShowsWhatItHolds) {
  const auto inspector = opened();
  inspector->shot().seek(2);
  const taa::Intermediate& row = taa::intermediate(IntermediateId::rejectReason);
  const taa::Picture asked =
      inspector->views().picture(row.id, taa::defaultStyle(row), {.zoom = 2.0f}, 2 * kWidth, 2 * kHeight);
  inspector->views().watch({row.id});
  const taa::Picture watched =
      inspector->views().picture(row.id, taa::defaultStyle(row), {.zoom = 2.0f}, 2 * kWidth, 2 * kHeight);
  EXPECT_EQ(asked.rgba, watched.rgba);
  EXPECT_EQ(asked.width, 2 * kWidth);
  EXPECT_EQ(asked.rgba.size(), std::size_t{4} * asked.width * asked.height);
}

TEST_F(InspectorTest, CompilesItsShadersAgainWithoutLosingItsPlace) {
  const auto inspector = opened();
  inspector->shot().setInputsBudget(64u << 20); // what is kept was drawn with the old ones
  inspector->shot().seek(3);
  inspector->shot().reloadShaders();
  EXPECT_EQ(inspector->shot().frame(), 3);
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows()), fresh({}, 3));
}
