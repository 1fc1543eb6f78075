// Settings measured on the shot of a session are measured as anybody else measures them.
#include "core/sweep/ShotSweep.h"

#include "core/settings/Presets.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/SmallInspector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <future>
#include <string>
#include <string_view>
#include <vector>

namespace {

using taa::LaneMetrics;
using taa::Metric;
using taa::ShotSweepRequest;

class ShotSweepTest : public taa::test::small::InspectorTest {
 protected:
  static ShotSweepRequest request() {
    ShotSweepRequest request;
    taa::SessionFile& shot = request.shots.emplace_back();
    shot.source = "builtin:fan";
    shot.camera = "orbit";
    shot.size = {taa::test::small::kWidth, taa::test::small::kHeight};
    shot.restarts = {2};
    request.settings = {{"one", taa::preset("balanced").settings},
                        {"other", taa::test::small::otherSettings()}};
    request.metrics = {2, 3, {Metric::Rmse, Metric::MeanAlpha, Metric::Flicker}, 4};
    return request;
  }
  static std::vector<LaneMetrics> swept(const ShotSweepRequest& request) {
    return std::async(std::launch::async,
                      [&] {
                        std::vector<LaneMetrics> all(request.count());
                        sweepShots(request,
                                   [&](std::size_t index, const LaneMetrics& frames) { all[index] = frames; },
                                   {});
                        return all;
                      })
        .get();
  }
};

} // namespace

TEST_F(ShotSweepTest, GivesTheNumbersOfTheShot) {
  const std::vector<LaneMetrics> all = swept(request());
  const auto inspector = opened({request().settings[0].settings, request().settings[1].settings});
  inspector->shot().setCamera("orbit");
  inspector->shot().setRestarts({2});
  const std::vector<LaneMetrics> expected = measureFrames(*inspector, request().metrics, {});
  for (std::size_t lane = 0; lane < expected.size(); ++lane) {
    ASSERT_EQ(all[lane].size(), expected[lane].size());
    for (std::size_t frame = 0; frame < expected[lane].size(); ++frame)
      EXPECT_EQ(all[lane][frame].values, expected[lane][frame].values) << lane << ", " << frame;
  }
  EXPECT_EQ(all[0][0].at(Metric::MeanAlpha), 1.0) << "history starts anew there";
}

TEST_F(ShotSweepTest, SaysWhereItIsAndStopsWhenItIsTold) {
  std::vector<int> places;
  const auto stopsInTheSecond = [&](std::string_view, int done, int total) {
    EXPECT_EQ(total, 4) << "frames of all settings";
    places.push_back(done);
    return done < 2;
  };
  std::size_t measured = 0;
  const auto stopped = [&] {
    EXPECT_THROW(sweepShots(
                     request(), [&](std::size_t, const LaneMetrics&) { ++measured; }, stopsInTheSecond),
                 taa::Cancelled);
  };
  std::async(std::launch::async, stopped).get();
  EXPECT_EQ(measured, 1u);
  EXPECT_TRUE(std::ranges::is_sorted(places));
}

TEST_F(ShotSweepTest, SaysWhatTheShotDoesNotHave) {
  ShotSweepRequest wrong = request();
  wrong.shots[0].camera = "absent";
  const std::string why = taa::test::errorOf([&] { swept(wrong); });
  EXPECT_NE(why.find("absent"), std::string::npos) << why;
}

// The second shot by itself is measured as it is behind the first one: neither knows of the other.
TEST_F(ShotSweepTest, MeasuresEachOfSeveralShotsByItself) {
  ShotSweepRequest both = request();
  taa::SessionFile fence;
  fence.source = "builtin:fence";
  fence.size = both.shots[0].size;
  both.shots.push_back(fence);
  ASSERT_EQ(both.count(), 4u);
  ShotSweepRequest alone = request();
  alone.shots = {fence};
  const std::vector<LaneMetrics> all = swept(both), first = swept(request()), second = swept(alone);
  for (std::size_t index = 0; index < both.count(); ++index) {
    EXPECT_EQ(both.shotOf(index).source, index < 2 ? "builtin:fan" : "builtin:fence");
    EXPECT_EQ(both.settingsOf(index).name, index % 2 == 0 ? "one" : "other");
    const LaneMetrics& expected = index < 2 ? first[index] : second[index - 2];
    ASSERT_EQ(all[index].size(), expected.size());
    for (std::size_t frame = 0; frame < expected.size(); ++frame)
      EXPECT_EQ(all[index][frame].values, expected[frame].values) << index << ", " << frame;
  }
  EXPECT_NE(all[0][1].values, all[2][1].values) << "another scene, other numbers";
}

TEST_F(ShotSweepTest, MeasuresTheLineOfSupersamplingOnceAShot) {
  ShotSweepRequest with = request();
  with.metrics.referenceSamples = 8;
  with.hasSupersampling = true;
  const std::vector<LaneMetrics> all = swept(with);
  EXPECT_TRUE(all[0][1].at(Metric::Supersampling));
  EXPECT_FALSE(all[1][1].at(Metric::Supersampling)) << "it is the same of all settings";
}

TEST_F(ShotSweepTest, SaysWhichShotHasNoSuchFrames) {
  ShotSweepRequest far = request();
  far.metrics.first = far.metrics.last = 240;
  EXPECT_EQ(taa::test::errorOf([&] { swept(far); }), "builtin:fan has frames 0 to 239, so no frame 240");
}
