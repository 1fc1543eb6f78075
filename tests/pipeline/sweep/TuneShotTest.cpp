// What tuning measures of settings is what anybody else measures of them.
#include "core/sweep/tune/TuneShot.h"

#include "core/settings/Parameters.h"
#include "tests/support/SmallInspector.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>

namespace {

using taa::Metric;
using taa::Settings;
using taa::TuneNumbers;

class TuneShotTest : public taa::test::small::InspectorTest {
 protected:
  static constexpr int kFirst = 2, kLast = 3, kSamples = 4;

  static std::optional<double> of(const TuneNumbers& numbers, Metric metric) {
    return numbers.means[static_cast<std::size_t>(metric)];
  }
};

} // namespace

TEST_F(TuneShotTest, MeasuresTheMeanOfItsFramesOfAnySettings) {
  const taa::TuneGoal goal("rmse=1,meanAlpha=1");
  const taa::MetricsRequest request{kFirst, kLast, goal.metrics(), kSamples};
  const taa::LaneMetrics expected =
      taa::measureFrames(*opened({taa::test::small::otherSettings()}), request, {}).front();
  const auto inspector = opened();
  taa::TuneShot shot(*inspector, goal, request);
  shot.measure(Settings{}, {});
  const TuneNumbers numbers = shot.measure(taa::test::small::otherSettings(), {});
  for (const Metric metric : goal.metrics()) EXPECT_EQ(of(numbers, metric), meanOfFrames(expected, metric));
  EXPECT_FALSE(of(numbers, Metric::Psnr)) << "nobody asked for it";
}

TEST_F(TuneShotTest, TimesTheResolveOnceForEachProgram) {
  const auto inspector = opened();
  const taa::TuneGoal goal("cost=1");
  taa::TuneShot shot(*inspector, goal, {kFirst, kLast, {}, kSamples});
  EXPECT_EQ(shot.measure(Settings{}, {}).cost, 1.0) << "of the start itself";
  Settings number;
  applyAssignment(number, "weight.minimum=0.5");
  EXPECT_EQ(shot.measure(number, {}).cost, 1.0) << "a number changes no program";
  const Settings method = taa::test::small::otherSettings();
  const double cost = shot.measure(method, {}).cost;
  EXPECT_GT(cost, 0.0);
  EXPECT_EQ(shot.measure(method, {}).cost, cost) << "measured once";
  EXPECT_EQ(inspector->shot().laneCount(), 1);
  EXPECT_TRUE(inspector->shot().settings() == method);
}
