// Profiles, the cost of stages and thumbnails, on real frames.
#include "core/inspect/Inspector.h"
#include "core/settings/Presets.h"
#include "tests/support/CompareImages.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using taa::Inspector;
using taa::IntermediateId;
using taa::Stage;

namespace {

constexpr int kWidth = 97, kHeight = 61;

class ProfileTest : public taa::test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    inspector = std::make_unique<Inspector>();
    inspector->shot().setSize(kWidth, kHeight);
    inspector->shot().open("builtin:fan");
    inspector->shot().seek(3);
  }
  void TearDown() override {
    inspector.reset();
    context().makeCurrent();
    GlTest::TearDown();
  }
  std::unique_ptr<Inspector> inspector;
};

std::set<std::string> namesOf(const taa::FrameProfile& profile) {
  std::set<std::string> names;
  for (const taa::PassCost& cost : profile.passes) names.insert(cost.name);
  return names;
}

} // namespace

TEST_F(ProfileTest, ThereIsNoneUnlessItIsAskedFor) {
  inspector->shot().advance();
  EXPECT_FALSE(inspector->profiler().takeProfile());
  inspector->profiler().setProfiling(true);
  EXPECT_FALSE(inspector->profiler().takeProfile()) << "no frame was made since";
  inspector->shot().advance();
  EXPECT_TRUE(inspector->profiler().takeProfile());
  EXPECT_FALSE(inspector->profiler().takeProfile());
  inspector->profiler().setProfiling(false);
  inspector->shot().advance();
  EXPECT_FALSE(inspector->profiler().takeProfile());
}

TEST_F(ProfileTest, HoldsThePassesOfTheFrameAndOfWhatWasLookedAt) {
  taa::Settings settings;
  settings.inputs.motion = taa::MotionSource::CameraFromDepth;
  inspector->shot().setSettings(settings);
  inspector->shot().refine(); // only exact histories are kept
  inspector->profiler().setProfiling(true);
  inspector->shot().advance();
  inspector->views().picture(IntermediateId::alpha, {}, {}, 40, 30);
  inspector->probes().probe(3, 4);
  inspector->views().thumbnail(IntermediateId::resolved, {16, 9});
  const auto profile = inspector->profiler().takeProfile();
  ASSERT_TRUE(profile);
  EXPECT_EQ(profile->frame, 4);
  EXPECT_EQ(namesOf(*profile), (std::set<std::string>{"Shadows, as the sun sees them", "G-buffer", "Sky",
                                                      "Camera motion", "Resolve", "Exposing for views",
                                                      "Views", "Probe", "Thumbnails", "Between the passes"}));
  double sum = 0.0;
  for (const taa::PassCost& cost : profile->passes) sum += cost.milliseconds;
  EXPECT_NEAR(profile->totalMs, sum, 1e-9);
  EXPECT_GT(profile->checkpointBytes, std::size_t(kWidth * kHeight));
}

// Nothing that casts moves there: its map is kept from frame to frame, but where time is taken.
TEST_F(ProfileTest, OfAStillSceneHasItsShadows) {
  inspector->shot().open("builtin:fence");
  inspector->shot().seek(2);
  inspector->profiler().setProfiling(true);
  inspector->shot().advance();
  const auto profile = inspector->profiler().takeProfile();
  ASSERT_TRUE(profile);
  EXPECT_TRUE(namesOf(*profile).contains("Shadows, as the sun sees them"));
}

TEST_F(ProfileTest, OfAReplayIsThatOfTheLastFrame) {
  inspector->profiler().setProfiling(true);
  inspector->shot().seek(9);
  const auto profile = inspector->profiler().takeProfile();
  ASSERT_TRUE(profile);
  const auto resolve = std::ranges::find(profile->passes, "Resolve", &taa::PassCost::name);
  ASSERT_NE(resolve, profile->passes.end());
  EXPECT_EQ(resolve->runs, 1);
}

TEST_F(ProfileTest, EveryStageIsMeasuredAndNothingIsChangedByIt) {
  const taa::Image before = inspector->views().image(IntermediateId::resolved);
  const taa::StageCosts costs = inspector->profiler().measureStages();
  EXPECT_EQ(costs.frame, 3);
  EXPECT_EQ(costs.width, kWidth);
  std::set<Stage> stages;
  for (const taa::StageCost& cost : costs.stages) {
    stages.insert(cost.stage);
    EXPECT_LE(cost.ms.low, cost.ms.median);
    EXPECT_GE(cost.ms.high, cost.ms.median);
    EXPECT_LT(cost.ms.spread(), 1e9) << "enough rounds for a range";
  }
  EXPECT_EQ(stages.size(), taa::kCostStages.size());
  EXPECT_GT(costs.whole.median, 0.0);
  EXPECT_GT(costs.cheapest.median, 0.0);
  EXPECT_EQ(taa::test::difference(inspector->views().image(IntermediateId::resolved), before), "");
}

TEST_F(ProfileTest, StagesWithTheCheapestSettingsCostNothingAndTheRestIsMeasured) {
  taa::Settings settings = taa::preset("minimal").settings;
  settings.history.filter = taa::HistoryFilter::CatmullRom16;
  inspector->shot().setSettings(settings);
  std::set<int> totals;
  const taa::StageCosts costs = inspector->profiler().measureStages([&](std::string_view, int, int total) {
    totals.insert(total);
    return true;
  });
  EXPECT_EQ(totals, std::set{2 * costs.rounds}) << "all stages at once, and the history's filter";
  for (const taa::StageCost& cost : costs.stages) {
    EXPECT_EQ(cost.isCheapest, cost.stage != Stage::SampleHistory);
    if (cost.isCheapest) {
      EXPECT_EQ(cost.ms.median, 0.0);
      EXPECT_EQ(cost.ms.spread(), 0.0);
    }
  }
}

TEST_F(ProfileTest, AMeasurementThatWasStoppedGoesOn) {
  int reported = 0, first = -1;
  const taa::Progress stopsAtFive = [&](std::string_view, int done, int) { return done < 5; };
  EXPECT_THROW(inspector->profiler().measureStages(stopsAtFive), taa::Cancelled);
  const taa::Progress counts = [&](std::string_view, int done, int) {
    if (first < 0) first = done;
    ++reported;
    return true;
  };
  inspector->profiler().measureStages(counts);
  EXPECT_EQ(first, 5);
  // Another frame starts anew.
  EXPECT_THROW(inspector->profiler().measureStages(stopsAtFive), taa::Cancelled);
  inspector->shot().advance();
  first = -1;
  inspector->profiler().measureStages(counts);
  EXPECT_EQ(first, 0);
}

TEST_F(ProfileTest, AThumbnailIsThePictureOfTheFullPicturesTexels) {
  constexpr glm::ivec2 kTexels{24, 15};
  for (const IntermediateId id : taa::mainRows()) {
    const taa::Intermediate& row = taa::intermediate(id);
    const taa::Picture thumbnail = inspector->views().thumbnail(id, kTexels);
    ASSERT_EQ(thumbnail.width, kTexels.x);
    // The full picture at 1:1, which shows each texel in a pixel of its own.
    const taa::Picture full = inspector->views().picture(id, taa::defaultStyle(row), {}, kWidth, kHeight);
    for (int y = 0; y < kTexels.y; ++y)
      for (int x = 0; x < kTexels.x; ++x) {
        const int fullX = (2 * x + 1) * kWidth / (2 * kTexels.x),
                  fullY = (2 * y + 1) * kHeight / (2 * kTexels.y);
        const auto at = [](const taa::Picture& picture, int column, int line) {
          const auto* texel = picture.rgba.data() + 4 * (std::size_t(line) * picture.width + column);
          return std::vector<int>(texel, texel + 4);
        };
        ASSERT_EQ(at(thumbnail, x, y), at(full, fullX, fullY)) << row.name << " at " << x << ", " << y;
      }
  }
}
