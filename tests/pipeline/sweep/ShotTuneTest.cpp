// The search beside the window goes the way of anybody else's.
#include "core/sweep/tune/ShotTune.h"

#include "core/base/Error.h"
#include "core/settings/Presets.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/SmallInspector.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <future>
#include <string>
#include <string_view>
#include <vector>

namespace {

using taa::ShotTuneRequest;
using taa::TuneWay;
using taa::Tuning;

class ShotTuneTest : public taa::test::small::InspectorTest {
 protected:
  static ShotTuneRequest request() {
    ShotTuneRequest request;
    request.shot.source = "builtin:fan";
    request.shot.size = {taa::test::small::kWidth, taa::test::small::kHeight};
    request.start = taa::preset("balanced").settings;
    request.tuning = {"rmse=1", {"rectify.method"}, {2, 3, {}, 4}};
    return request;
  }
  /// On a thread without an Inspector; what was told.
  static std::vector<TuneWay> tuned(const ShotTuneRequest& request, const taa::Progress& progress = {}) {
    return std::async(std::launch::async,
                      [&] {
                        std::vector<TuneWay> ways;
                        try {
                          tuneShot(
                              request, [&](const TuneWay& way) { ways.push_back(way); }, progress);
                        } catch (const taa::Cancelled&) { // what was told stays
                        }
                        return ways;
                      })
        .get();
  }
};

} // namespace

TEST_F(ShotTuneTest, GoesTheWayOfASearchOnTheShot) {
  const std::vector<TuneWay> ways = tuned(request());
  const auto inspector = opened({request().start});
  const taa::Progress progress;
  Tuning tuning(*inspector, request().tuning, progress);
  EXPECT_FALSE(tuning.run());
  ASSERT_FALSE(ways.empty());
  const TuneWay& last = ways.back();
  EXPECT_TRUE(last.result.settings == tuning.result().settings);
  EXPECT_EQ(last.result.goal, tuning.result().goal);
  EXPECT_EQ(last.result.evaluations, tuning.result().evaluations);
  EXPECT_EQ(last.start.means, tuning.start().means);
  EXPECT_EQ(last.best.means, tuning.best().means);
  EXPECT_TRUE(last.result.isComplete);
  EXPECT_LE(last.result.goal, last.result.startGoal);
}

TEST_F(ShotTuneTest, TellsEachEvaluationOnceItIsKnownWhatCameOfIt) {
  const std::vector<TuneWay> ways = tuned(request());
  ASSERT_EQ(ways.size(), static_cast<std::size_t>(ways.back().result.evaluations));
  for (std::size_t place = 0; place < ways.size(); ++place)
    EXPECT_EQ(ways[place].result.evaluations, static_cast<int>(place) + 1);
  for (std::size_t place = 1; place < ways.size(); ++place)
    EXPECT_LE(ways[place].result.goal, ways[place - 1].result.goal);
}

TEST_F(ShotTuneTest, LeavesTheBestWhenItIsStopped) {
  const std::vector<TuneWay> ways = tuned(request(), [](std::string_view what, int done, int) {
    return !what.starts_with("Tuning") || done < 2;
  });
  ASSERT_FALSE(ways.empty());
  EXPECT_EQ(ways.back().result.evaluations, 2);
  EXPECT_FALSE(ways.back().result.isComplete);
}

TEST_F(ShotTuneTest, SaysWhatItCannotTune) {
  ShotTuneRequest wrong = request();
  wrong.tuning.goal = "beauty=1";
  const std::string why = taa::test::errorOf([&] { tuned(wrong); });
  EXPECT_NE(why.find("beauty"), std::string::npos) << why;
}
