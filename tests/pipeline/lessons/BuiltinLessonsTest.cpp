// Every step of every built-in lesson: its state is set, its claims hold, and its task is not solved at the
// start and is by the solution that it states.
#include "core/inspect/Inspector.h"
#include "core/lessons/LessonCheck.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

class BuiltinLesson : public taa::test::GlTest, public testing::WithParamInterface<std::string> {};

std::vector<std::string> builtinIds() {
  std::vector<std::string> ids;
  for (const taa::Lesson& lesson : taa::builtinLessons()) ids.push_back(lesson.id);
  return ids;
}

} // namespace

TEST_P(BuiltinLesson, SaysWhatIsTrue) {
  const auto lesson = std::ranges::find(taa::builtinLessons(), GetParam(), &taa::Lesson::id);
  taa::Inspector inspector;
  const std::vector<taa::LessonFinding> findings = taa::checkLesson(inspector, *lesson);
  EXPECT_FALSE(findings.empty()) << "nothing of it is asserted";
  for (const std::string& mistake : taa::mistakesOf(findings)) ADD_FAILURE() << mistake;
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinLesson, testing::ValuesIn(builtinIds()), [](const auto& lesson) {
  std::string name = lesson.param;
  std::ranges::replace(name, '-', '_');
  return name;
});
