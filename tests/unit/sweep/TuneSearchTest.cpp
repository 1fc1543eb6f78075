// The search for better settings, on goals whose best settings are known.
#include "core/sweep/tune/TuneSearch.h"

#include "core/base/Error.h"
#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <vector>

using taa::Parameter;
using taa::Settings;
using taa::TuneResult;
using taa::TuneSearch;

namespace {

double valueOf(const Settings& settings, const std::string& path) {
  return taa::parameter(path).get(settings);
}

/// 1 at its best: the least α at 0.3, history clamped, and depth not compared.
double bowl(const Settings& settings) {
  const double off = valueOf(settings, "weight.minimum") - 0.3;
  const bool isClamped = settings.rectify.method == taa::RectifyMethod::Clamp;
  return 1.0 + off * off + (isClamped ? 0.0 : 0.5) + valueOf(settings, "validate.depth");
}

Settings start() {
  Settings settings;
  applyAssignment(settings, "weight.minimum=0.02");
  applyAssignment(settings, "rectify.method=none");
  applyAssignment(settings, "validate.depth=on");
  return settings;
}

TuneResult tuned(unsigned seed = 1, taa::TuneLimits limits = {10'000, {}},
                 const TuneSearch::Evaluate& evaluate = bowl) {
  TuneSearch search(start(), taa::tunableRows(), seed, evaluate);
  search.run(limits);
  return search.result();
}

std::vector<double> valuesAround(const std::string& path, double value, double step) {
  return taa::tunedValues(taa::parameter(path), value, step);
}

} // namespace

TEST(TuneSearch, FindsTheBestOfNumbersChoicesAndSwitches) {
  const TuneResult result = tuned();
  EXPECT_TRUE(result.isComplete);
  EXPECT_EQ(result.settings.rectify.method, taa::RectifyMethod::Clamp);
  EXPECT_EQ(valueOf(result.settings, "validate.depth"), 0.0);
  // A last step of 1/64 along the cube root: 0.3 ± 3·0.3^⅔/64, and what that gains is below a hundredth.
  EXPECT_NEAR(valueOf(result.settings, "weight.minimum"), 0.3, 3.0 * std::pow(0.3, 2.0 / 3.0) / 64.0);
  EXPECT_EQ(result.goal, bowl(result.settings));
}

TEST(TuneSearch, ChangesNothingThatChangesNoGoal) {
  const TuneResult result = tuned();
  const std::vector<std::string> changes = differences(result.settings, start());
  EXPECT_EQ(changes.size(), 3u);
}

TEST(TuneSearch, SaysItsWay) {
  const TuneResult result = tuned();
  EXPECT_DOUBLE_EQ(result.startGoal, bowl(start()));
  Settings settings = start();
  double goal = result.startGoal;
  for (const taa::TuneStep& step : result.steps) {
    applyAssignment(settings, step.change);
    EXPECT_EQ(step.goal, bowl(settings)) << step.change;
    EXPECT_LT(step.goal, goal) << step.change;
    EXPECT_LE(step.evaluation, result.evaluations);
    goal = step.goal;
  }
  EXPECT_TRUE(settings == result.settings);
}

TEST(TuneSearch, GoesTheSameWayWithTheSameSeed) {
  const auto wayOf = [](unsigned seed) {
    std::string way;
    for (const taa::TuneStep& step : tuned(seed).steps)
      way += std::to_string(step.evaluation) + " " + step.change + "\n";
    return way;
  };
  EXPECT_EQ(wayOf(7), wayOf(7));
  EXPECT_NE(wayOf(7), wayOf(8));
}

TEST(TuneSearch, MeasuresNoSettingsTwiceAndNoMoreThanItMay) {
  std::set<std::string> seen;
  int count = 0;
  const auto counting = [&](const Settings& settings) {
    std::string text;
    for (const std::string& each : differences(settings, Settings{})) text += each + " ";
    EXPECT_TRUE(seen.insert(text).second) << text;
    ++count;
    return bowl(settings);
  };
  const TuneResult all = tuned(1, {10'000, {}}, counting);
  EXPECT_EQ(all.evaluations, count);
  for (const int most : {1, 2, 17}) {
    const TuneResult some = tuned(1, {most, {}});
    EXPECT_EQ(some.evaluations, most);
    EXPECT_FALSE(some.isComplete);
    EXPECT_LE(some.goal, some.startGoal);
  }
  int left = 5;
  EXPECT_EQ(tuned(1, {10'000, [&] { return --left < 0; }}).isComplete, false);
}

TEST(TuneSearch, StaysWhereNothingIsBetter) {
  const TuneResult flat = tuned(1, {10'000, {}}, [](const Settings&) { return 1.0; });
  EXPECT_TRUE(flat.settings == start());
  EXPECT_TRUE(flat.steps.empty());
  const auto best = [](const Settings& settings) { return settings == start() ? 1.0 : 2.0; };
  EXPECT_TRUE(tuned(1, {10'000, {}}, best).settings == start());
  const auto broken = [](const Settings& settings) {
    return settings == start() ? 1.0 : std::numeric_limits<double>::quiet_NaN();
  };
  EXPECT_TRUE(tuned(1, {10'000, {}}, broken).settings == start()) << "what is no number is not better";
}

TEST(TuneSearch, KeepsTheBestWhenItIsCancelled) {
  int left = 120;
  TuneSearch search(start(), taa::tunableRows(), 1, [&](const Settings& settings) {
    if (--left < 0) throw taa::Cancelled();
    return bowl(settings);
  });
  EXPECT_THROW(search.run({10'000, {}}), taa::Cancelled);
  EXPECT_EQ(search.result().evaluations, 120);
  EXPECT_FALSE(search.result().steps.empty());
  EXPECT_EQ(search.result().goal, bowl(search.result().settings));
}

TEST(TuneSearch, VariesTheResolveAlone) {
  for (const Parameter* row : taa::tunableRows()) {
    EXPECT_GE(row->stage, taa::Stage::DilateMotion) << row->path;
    EXPECT_LE(row->stage, taa::Stage::Blend) << row->path;
    EXPECT_NE(row->path, "history.precision");
  }
  EXPECT_GT(taa::tunableRows().size(), 60u);
}

TEST(TuneSearch, VariesWhatItIsTold) {
  const auto paths = [](const std::vector<std::string>& names) {
    std::vector<std::string> found;
    for (const Parameter* row : taa::tunableRows(names)) found.emplace_back(row->path);
    return found;
  };
  EXPECT_EQ(paths({"weight.minimum"}), std::vector<std::string>{"weight.minimum"});
  EXPECT_EQ(paths({"dilate", "reproject.method"}),
            (std::vector<std::string>{"dilate.method", "dilate.ties", "dilate.upLeft", "reproject.method"}));
  EXPECT_NE(taa::test::errorOf([&] { paths({"jitter.period"}); }).find("jitter.period"), std::string::npos);
}

TEST(TuneSearch, StepsAlongTheCubeRootOfARange) {
  // 0…1 at 0.125, whose root is 0.5: (0.5 ∓ 0.125)³ = 0.052734375 and 0.244140625, to three digits.
  EXPECT_EQ(valuesAround("weight.alpha", 0.125, 0.125),
            (std::vector<double>{static_cast<double>(0.0527f), static_cast<double>(0.244f)}));
  EXPECT_EQ(valuesAround("weight.alpha", 0.0, 0.5), std::vector<double>{0.125});
  EXPECT_EQ(valuesAround("weight.alpha", 1.0, 0.5), std::vector<double>{0.125});
  // −1…1 evenly.
  EXPECT_EQ(valuesAround("validate.normalLimit", 0.5, 0.125), (std::vector<double>{0.25, 0.75}));
}

TEST(TuneSearch, TriesEveryOtherChoice) {
  const Parameter& row = taa::parameter("rectify.method");
  const std::vector<double> others = taa::tunedValues(row, 2.0, 0.125);
  EXPECT_EQ(others.size(), row.choices.size() - 1);
  EXPECT_EQ(std::ranges::count(others, 2.0), 0);
  EXPECT_EQ(taa::tunedValues(taa::parameter("validate.depth"), 1.0, 0.125), std::vector<double>{0.0});
}
