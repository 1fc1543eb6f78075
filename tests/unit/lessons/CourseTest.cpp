// The course as a whole: what it meets.
#include "core/lessons/Lesson.h"
#include "core/report/Techniques.h"
#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace {

/// Settings that a lesson's claims are measured with: of steps, lanes and solutions, and of what is recorded.
std::vector<taa::Settings> measuredSettings(const taa::Lesson& lesson) {
  std::vector<taa::Settings> all;
  for (const taa::LessonStep& step : lesson.steps) {
    if (step.claims.empty() && !step.task) continue;
    all.push_back(step.state.shot.settings.settings);
    for (const taa::LessonLane& lane : step.state.lanes) all.push_back(lane.settings);
    if (step.state.recording) all.push_back(step.state.recording->settings);
    if (step.task) all.push_back(step.task->solution.shot.settings.settings);
  }
  return all;
}

/// Whether what is between backticks is in force: "path=value" has that value, "path" another than by
/// default. What is no setting, as the name of an intermediate or a preset, counts as in force.
bool isInForce(const std::string& said, const taa::Settings& settings) {
  const std::size_t equals = std::min(said.find('='), said.size());
  const auto row = std::ranges::find(taa::parameters(), said.substr(0, equals), &taa::Parameter::path);
  if (row == taa::parameters().end()) return true;
  if (equals == said.size()) return row->get(settings) != row->defaultValue();
  return row->get(settings) == taa::parseValue(*row, said.substr(equals + 1));
}

/// Whether one of the settings that choose the technique is in force somewhere in the lesson.
bool hasInForce(const taa::Lesson& lesson, const taa::Technique& technique) {
  std::vector<std::string> said;
  for (std::size_t begin = technique.here.find('`'); begin != technique.here.npos;) {
    const std::size_t end = technique.here.find('`', begin + 1);
    said.emplace_back(technique.here.substr(begin + 1, end - begin - 1));
    begin = technique.here.find('`', end + 1);
  }
  if (said.empty()) return true; // always
  return std::ranges::any_of(measuredSettings(lesson), [&](const taa::Settings& settings) {
    return std::ranges::any_of(said, [&](const std::string& one) { return isInForce(one, settings); });
  });
}

/// Of which quantity, whatever lane has it.
auto measuredOf(const taa::Quantity& quantity) {
  return std::tuple(quantity.kind, quantity.number, quantity.metric, quantity.row, quantity.channel,
                    quantity.pixel, quantity.isBelow, quantity.figure, quantity.isSeveral, quantity.frame);
}

/// Whether it asks a lane to be at least, or at most, what another is, and holds where both are the same: if
/// what they differ in did nothing. "=" says that it does nothing.
bool holdsOfTheSame(const taa::Claim& claim) {
  const bool isComparison = measuredOf(claim.left) == measuredOf(claim.right) &&
                            claim.left.kind != taa::QuantityKind::Number &&
                            claim.left.lane != claim.right.lane && claim.relation != taa::Relation::Equal;
  const auto sideOf = [](const taa::Quantity& side, double value) {
    return value * side.factor + side.offset;
  };
  // Of metrics and shares: 30 is a PSNR, 1 a part.
  return isComparison && std::ranges::any_of(std::array{1.0, 30.0}, [&](double value) {
           return holds(claim, sideOf(claim.left, value), sideOf(claim.right, value));
         });
}

} // namespace

TEST(Course, MeetsEveryTechniqueOfTheManualWithAClaim) {
  for (const taa::Technique& technique : taa::techniques()) {
    if (technique.here.starts_with("Left out")) continue;
    bool isMet = false;
    for (const taa::Lesson& lesson : taa::builtinLessons())
      isMet = isMet ||
              (std::ranges::count(lesson.techniques, technique.row) > 0 && hasInForce(lesson, technique));
    EXPECT_TRUE(isMet) << technique.row << ", " << technique.name << ": " << technique.here;
  }
}

TEST(Course, ComparesLanesSoThatAClaimFailsWhereTheyAreTheSame) {
  for (const taa::Lesson& lesson : taa::builtinLessons())
    for (const taa::LessonStep& step : lesson.steps)
      for (const taa::Claim& claim : step.claims)
        EXPECT_FALSE(holdsOfTheSame(claim)) << lesson.place << ":" << claim.line << ": " << claim.text;
  // What it is about, and what it is not.
  for (const char* lenient : {"metric psnr of a <= metric psnr of b", "metric psnr > metric psnr of a - 1",
                              "metric flicker of a < metric flicker * 1.05"})
    EXPECT_TRUE(holdsOfTheSame(taa::conditionFrom(lenient))) << lenient;
  for (const char* strict : {"metric psnr > metric psnr of a", "metric psnr = metric psnr of a within 0.1",
                             "metric flicker of a < metric flicker * 0.9", "metric psnr < 20"})
    EXPECT_FALSE(holdsOfTheSame(taa::conditionFrom(strict))) << strict;
}
