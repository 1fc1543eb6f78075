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
  EXPECT_EQ(inspector->source(), "builtin:fan");
  EXPECT_EQ(inspector->frame(), 0);
  EXPECT_EQ(inspector->camera(), inspector->scene().shot.camera);
  EXPECT_EQ(inspector->width(), kWidth);
  EXPECT_TRUE(inspector->isExact());
  EXPECT_TRUE(inspector->info().startsHistory);
  EXPECT_GT(inspector->times().scene, 0.0);
  EXPECT_GT(inspector->times().resolve, 0.0);
}

TEST_F(InspectorTest, TellsOfEachProgramThatItCompilesWhileItOpens) {
  const auto inspector = opened();
  std::vector<int> steps;
  int total = 0;
  inspector->open("builtin:fan", [&](std::string_view what, int done, int all) {
    if (what != "Compiling shaders") return true;
    steps.push_back(done);
    total = all;
    return true;
  });
  ASSERT_GE(steps.size(), 4u) << "two programs at least, compiled and drawn";
  for (std::size_t step = 0; step < steps.size(); ++step) EXPECT_EQ(steps[step], static_cast<int>(step));
  EXPECT_EQ(total, static_cast<int>(steps.size()) + 1) << "the first frame comes after them";
  inspector->seek(2);
  for (const int last : {1, total / 2 + 1}) { // among those compiled, and those drawn
    const auto stops = [last](std::string_view what, int done, int) {
      return what != "Compiling shaders" || done < last;
    };
    EXPECT_THROW(inspector->open("builtin:fan", stops), taa::Cancelled);
    EXPECT_EQ(inspector->frame(), 2);
  }
}

TEST_F(InspectorTest, KeepsItsStateWhenSomethingCannotBeDone) {
  const auto inspector = opened();
  inspector->seek(2);
  const std::vector<Image> before = inspector->images(allRows());
  EXPECT_THROW(inspector->seek(-1), taa::Error);
  EXPECT_THROW(inspector->seek(inspector->frameCount()), taa::Error);
  EXPECT_THROW(inspector->open("no/such/model.glb"), taa::Error);
  EXPECT_THROW(inspector->open("builtin:nothing"), taa::Error);
  EXPECT_THROW(inspector->setCamera("backwards"), taa::Error);
  EXPECT_THROW(inspector->setSize(3, 100), taa::Error);
  EXPECT_THROW(inspector->setSize(1 << 20, 100), taa::Error);
  EXPECT_THROW(inspector->setLanes({}), taa::Error);
  EXPECT_THROW(inspector->setLanes(std::vector<Settings>(taa::kMostLanes + 1)), taa::Error);
  EXPECT_THROW(inspector->probe(kWidth, 0), taa::Error);
  EXPECT_THROW(inspector->probe(0, -1), taa::Error);
  EXPECT_EQ(inspector->source(), "builtin:fan");
  EXPECT_EQ(inspector->frame(), 2);
  EXPECT_EQ(inspector->laneCount(), 1);
  expectSame(inspector->images(allRows()), before);
  inspector->seek(3);
  expectSame(inspector->images(allRows()), fresh({}, 3));
}

TEST_F(InspectorTest, RefusesAPictureThatDoesNotFitIntoMemory) {
  const auto inspector = opened();
  if (!inspector->driver().isSoftware) GTEST_SKIP() << "a GPU's driver decides by itself";
  const int most = inspector->driver().maxTextureSize;
  try {
    inspector->setSize(most, most);
    FAIL() << "a picture of " << most << " pixels a side was accepted";
  } catch (const taa::Error& error) {
    EXPECT_NE(std::string(error.what()).find("memory"), std::string::npos) << error.what();
  }
  EXPECT_EQ(inspector->width(), kWidth);
}

TEST_F(InspectorTest, AnswersNewSettingsAtOnceAndExactlyLater) {
  const std::vector<Image> exact = fresh(otherSettings(), 9);
  const auto inspector = opened();
  inspector->seek(9);
  const std::vector<Image> old = inspector->images(allRows());
  inspector->setSettings(otherSettings());
  EXPECT_EQ(inspector->frame(), 9);
  EXPECT_FALSE(inspector->isExact());
  const std::vector<Image> atOnce = inspector->images(allRows());
  const auto at = [](const std::vector<Image>& images, IntermediateId id) {
    return images[static_cast<std::size_t>(id)];
  };
  EXPECT_TRUE(isSame(at(atOnce, IntermediateId::historyRaw), at(old, IntermediateId::historyRaw)));
  EXPECT_FALSE(
      isSame(at(atOnce, IntermediateId::historyRectified), at(old, IntermediateId::historyRectified)));
  inspector->refine();
  EXPECT_TRUE(inspector->isExact());
  expectSame(inspector->images(allRows()), exact);
}

TEST_F(InspectorTest, KeepsTheOldPictureWhenRefiningIsCancelled) {
  const auto inspector = opened();
  inspector->seek(9);
  inspector->setSettings(otherJitter());
  const std::vector<Image> atOnce = inspector->images(allRows());
  EXPECT_THROW(inspector->refine([](std::string_view, int done, int) { return done < 5; }), taa::Cancelled);
  EXPECT_FALSE(inspector->isExact());
  expectSame(inspector->images(allRows()), atOnce);
  inspector->refine();
  expectSame(inspector->images(allRows()), fresh(otherJitter(), 9));
}

TEST_F(InspectorTest, PlaysOnFromInexactHistoryUntilOneStartsAnew) {
  const auto inspector = opened();
  inspector->seek(5);
  inspector->setSettings(otherSettings());
  inspector->advance();
  EXPECT_EQ(inspector->frame(), 6);
  EXPECT_FALSE(inspector->isExact());
  inspector->advance();
  EXPECT_FALSE(inspector->isExact());
  inspector->seek(0);
  EXPECT_TRUE(inspector->isExact());
  inspector->advance();
  EXPECT_TRUE(inspector->isExact());
  expectSame(inspector->images(allRows()), fresh(otherSettings(), 1));
  inspector->seek(6);
  expectSame(inspector->images(allRows()), fresh(otherSettings(), 6));
}

TEST_F(InspectorTest, IsExactAtOnceWhereNoHistoryIsUsed) {
  const auto inspector = opened();
  inspector->setSettings(otherJitter());
  EXPECT_TRUE(inspector->isExact());
  inspector->setCamera("pan");
  EXPECT_TRUE(inspector->isExact());
  inspector->seek(1);
  inspector->setCamera("dolly");
  EXPECT_FALSE(inspector->isExact());
}

TEST_F(InspectorTest, DrawsAnotherSizeOrCameraAsIfItHadAlwaysBeen) {
  const auto inspector = opened();
  inspector->seek(4);
  inspector->setSize(kWidth + 7, kHeight + 2);
  inspector->setCamera("pan");
  EXPECT_EQ(inspector->image(IntermediateId::resolved).width, kWidth + 7);
  EXPECT_FALSE(inspector->isExact());
  inspector->setSize(kWidth, kHeight);
  inspector->setCamera(inspector->scene().shot.camera);
  inspector->refine();
  expectSame(inspector->images(allRows()), fresh({}, 4));
}

TEST_F(InspectorTest, GivesObjectsTheMotionThatIsChosenAndRefusesUnknownOnes) {
  const auto inspector = opened();
  inspector->seek(4);
  const Image own = inspector->image(IntermediateId::motion);
  const std::vector<Image> before = inspector->images(allRows());
  inspector->setMotionModes({{"rotor", taa::MotionMode::None}});
  EXPECT_FALSE(inspector->isExact()) << "the history is from the motion before";
  inspector->refine();
  const std::vector<Image> forced = inspector->images(allRows());
  EXPECT_FALSE(isSame(inspector->image(IntermediateId::motion), own));
  EXPECT_THROW(inspector->setMotionModes({{"nobody", taa::MotionMode::None}}), taa::Error);
  EXPECT_EQ(inspector->motionModes(), (std::vector<taa::MotionOverride>{{"rotor", taa::MotionMode::None}}));
  inspector->seek(7);
  inspector->seek(4);
  expectSame(inspector->images(allRows()), forced);
  inspector->setMotionModes({});
  inspector->refine();
  expectSame(inspector->images(allRows()), before);
}

TEST_F(InspectorTest, RunsLanesAsIfEachWereAlone) {
  const std::vector<Settings> lanes = {Settings{}, otherSettings(), otherJitter()};
  std::vector<std::vector<Image>> alone;
  alone.reserve(lanes.size());
  for (const Settings& settings : lanes) alone.push_back(fresh(settings, 5));
  const auto inspector = opened(lanes);
  inspector->watch({IntermediateId::alpha});
  inspector->seek(2);
  for (int frame = 3; frame <= 5; ++frame) inspector->advance();
  for (int lane = 0; lane < 3; ++lane)
    expectSame(inspector->images(allRows(), lane), alone[static_cast<std::size_t>(lane)]);
  EXPECT_EQ(&inspector->inputs(0), &inspector->inputs(1)) << "drawn once";
  EXPECT_NE(&inspector->inputs(0), &inspector->inputs(2)) << "another jitter";
  EXPECT_EQ(inspector->info(2).jitterIndex, 5);
}

TEST_F(InspectorTest, ChangesOneLaneAndLeavesTheOthersExact) {
  const auto inspector = opened({Settings{}, Settings{}});
  inspector->seek(4);
  const std::vector<Image> first = inspector->images(allRows(), 0);
  inspector->setSettings(otherJitter(), 1);
  EXPECT_TRUE(inspector->isExact(0));
  EXPECT_FALSE(inspector->isExact(1));
  expectSame(inspector->images(allRows(), 0), first);
  inspector->refine();
  expectSame(inspector->images(allRows(), 0), first);
  expectSame(inspector->images(allRows(), 1), fresh(otherJitter(), 4));
}

TEST_F(InspectorTest, AddsALaneThatIsExactFromTheStart) {
  const auto inspector = opened();
  inspector->seek(4);
  inspector->setLanes({Settings{}, otherSettings()});
  EXPECT_EQ(inspector->laneCount(), 2);
  EXPECT_EQ(inspector->frame(), 4);
  expectSame(inspector->images(allRows(), 1), fresh(otherSettings(), 4));
}

TEST_F(InspectorTest, LooksWithoutChangingWhatItLooksAt) {
  const std::vector<std::vector<IntermediateId>> watched = {{}, {IntermediateId::clipAmount}, allRows()};
  std::vector<std::vector<Image>> resolved, clipped;
  for (const auto& ids : watched) {
    const auto inspector = opened();
    inspector->watch(ids);
    resolved.emplace_back();
    clipped.emplace_back();
    for (int frame = 0; frame < 6; ++frame) {
      if (frame > 0) inspector->advance();
      resolved.back().push_back(inspector->image(IntermediateId::resolved));
      clipped.back().push_back(inspector->image(IntermediateId::clipAmount));
      inspector->probe(3, 4);
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
  inspector->watch({IntermediateId::boxMin});
  inspector->seek(3);
  const std::vector<Image> all = inspector->images(allRows());
  const taa::gl::Rect part{5, 6, 11, 3};
  // One of each number of channels and of each way to be held: every set of ids is a program to compile.
  for (IntermediateId id : {IntermediateId::boxMin, IntermediateId::color, IntermediateId::motion,
                            IntermediateId::objectId, IntermediateId::resolved}) {
    const Image& whole = all[static_cast<std::size_t>(id)];
    EXPECT_TRUE(isSame(inspector->image(id), whole)) << taa::intermediate(id).name;
    const Image cut = inspector->image(id, 0, part);
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        EXPECT_EQ(cut.texel(x, y), whole.texel(part.x + x, part.y + y)) << taa::intermediate(id).name;
  }
}

TEST_F(InspectorTest, ProbesWhatThePictureShows) {
  const auto inspector = opened();
  inspector->seek(5);
  const std::vector<Image> all = inspector->images(allRows());
  for (int sample = 0; sample < 12; ++sample) {
    const int x = (sample * 29) % kWidth, y = (sample * 17) % kHeight;
    const taa::PixelRecord record = inspector->probe(x, y);
    for (std::size_t index = 0; index < all.size(); ++index)
      EXPECT_EQ(record[index], all[index].texel(x, y)) << taa::kResolveRows[index].name;
  }
  const std::vector<taa::PixelRecord> corner = inspector->probeAround(0, kHeight - 1, 1);
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
  inspector->seek(2);
  const taa::Intermediate& row = taa::intermediate(IntermediateId::rejectReason);
  const taa::Picture asked =
      inspector->picture(row.id, taa::defaultStyle(row), {.zoom = 2.0f}, 2 * kWidth, 2 * kHeight);
  inspector->watch({row.id});
  const taa::Picture watched =
      inspector->picture(row.id, taa::defaultStyle(row), {.zoom = 2.0f}, 2 * kWidth, 2 * kHeight);
  EXPECT_EQ(asked.rgba, watched.rgba);
  EXPECT_EQ(asked.width, 2 * kWidth);
  EXPECT_EQ(asked.rgba.size(), std::size_t{4} * asked.width * asked.height);
}

TEST_F(InspectorTest, CompilesItsShadersAgainWithoutLosingItsPlace) {
  const auto inspector = opened();
  inspector->seek(3);
  inspector->reloadShaders();
  EXPECT_EQ(inspector->frame(), 3);
  inspector->refine();
  expectSame(inspector->images(allRows()), fresh({}, 3));
}
