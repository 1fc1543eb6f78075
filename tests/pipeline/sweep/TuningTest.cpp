// A search keeps what it measured on its way.
#include "core/sweep/tune/Tuning.h"

#include "core/base/Error.h"
#include "core/settings/Parameters.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/SmallInspector.h"

#include <gtest/gtest.h>

#include <chrono>
#include <exception>
#include <string>
#include <string_view>

namespace {

using taa::Progress;
using taa::TuneRequest;
using taa::Tuning;

class TuningTest : public taa::test::small::InspectorTest {
 protected:
  static TuneRequest request() { return {"rmse=1", {"rectify.method"}, {2, 3, {}, 4}}; }
};

} // namespace

TEST_F(TuningTest, KnowsTheNumbersOfTheStartAndOfTheBest) {
  const auto inspector = opened();
  const taa::Settings start = inspector->shot().settings();
  const Progress progress;
  Tuning tuning(*inspector, request(), progress);
  EXPECT_FALSE(tuning.hasStart());
  int evaluated = 0;
  EXPECT_FALSE(tuning.run([&] { ++evaluated; }));
  EXPECT_EQ(evaluated, tuning.result().evaluations - 1) << "what came of the last one is known at the end";
  const auto fresh = opened();
  taa::TuneShot shot(*fresh, tuning.goal(), request().metrics);
  EXPECT_EQ(tuning.start().means, shot.measure(start, {}).means);
  EXPECT_EQ(tuning.best().means, shot.measure(tuning.result().settings, {}).means);
}

TEST_F(TuningTest, EndsAfterItsEvaluations) {
  const auto inspector = opened();
  TuneRequest two = request();
  two.evaluations = 2;
  const Progress progress;
  Tuning tuning(*inspector, two, progress);
  EXPECT_FALSE(tuning.run());
  EXPECT_EQ(tuning.result().evaluations, 2);
  EXPECT_FALSE(tuning.result().isComplete);
}

TEST_F(TuningTest, SaysHowFarItIsAndWhatStoppedIt) {
  const auto inspector = opened();
  std::string said;
  const Progress stopsAtTwo = [&](std::string_view what, int done, int total) {
    EXPECT_EQ(total, 200);
    said = what;
    return done < 2;
  };
  Tuning tuning(*inspector, request(), stopsAtTwo);
  EXPECT_TRUE(tuning.run()) << "it was cancelled";
  EXPECT_EQ(tuning.result().evaluations, 2);
  EXPECT_NE(said.find("goal"), std::string::npos) << said;
}

TEST_F(TuningTest, SaysHowMuchOfItsTimeHasPassed) {
  const auto inspector = opened();
  TuneRequest timed = request();
  timed.seconds = 1000;
  int calls = 0;
  const auto began = std::chrono::steady_clock::now();
  const Progress stopsAfterAWhile = [&](std::string_view, int done, int total) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
    EXPECT_EQ(total, 1000);
    EXPECT_LE(done, passed.count());
    EXPECT_GE(done, passed.count() - 2.0) << "whole seconds, from when the search began";
    return ++calls < 40;
  };
  Tuning tuning(*inspector, timed, stopsAfterAWhile);
  EXPECT_TRUE(tuning.run()) << "it was cancelled";
  EXPECT_EQ(calls, 40);
}

// Sharpness alone is served by what shows single frames.
TEST_F(TuningTest, KeepsRmseAndFlickerFromBecomingWorseUnlessTheyMay) {
  TuneRequest sharp = request();
  sharp.goal = "sharpness=1";
  sharp.varied = {"weight.minimum"};
  sharp.metrics = {4, 7, {}, 4};
  const Progress progress;
  sharp.trades = true;
  const auto trading = opened();
  Tuning trade(*trading, sharp, progress);
  trade.run();
  EXPECT_FALSE(worseMetrics(trade.best(), trade.start()).empty()) << "or there is nothing to keep it from";
  sharp.trades = false;
  const auto inspector = opened();
  Tuning guarded(*inspector, sharp, progress);
  guarded.run();
  EXPECT_TRUE(worseMetrics(guarded.best(), guarded.start()).empty());
  EXPECT_LE(guarded.result().goal, guarded.result().startGoal);
  EXPECT_GT(guarded.result().goal, trade.result().goal);
}

TEST_F(TuningTest, SaysWhereAMetricIsNotKnown) {
  const auto inspector = opened();
  TuneRequest flicker = request();
  flicker.goal = "flicker=1";
  flicker.metrics = {0, 0, {}, 4};
  const Progress progress;
  Tuning tuning(*inspector, flicker, progress);
  const std::string why = taa::test::errorOf([&] { tuning.run(); });
  EXPECT_NE(why.find("flicker is not known"), std::string::npos) << why;
}
