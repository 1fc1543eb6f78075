// The course as a whole: what it meets.
#include "core/lessons/Lesson.h"
#include "core/report/Techniques.h"
#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
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
