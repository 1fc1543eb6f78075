// Lessons as text: what is read of them, and what is refused with file and line.
#include "core/lessons/Lesson.h"
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/lessons/Ladder.h"
#include "core/report/Techniques.h"
#include "core/settings/Parameters.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

std::string step(const std::string& header) {
  return "# Title\n\nWhat it is.\n\n## One\n\n```state\n" + header + "```\n\nSome *text*.\n";
}

std::string refusal(const std::string& text) {
  try {
    taa::lessonFromText(text, "some.md");
  } catch (const taa::Error& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(Lesson, ReadsTitleSummaryStepsAndText) {
  const taa::Lesson lesson =
      taa::lessonFromText(step("scene: builtin:fan\n") + "## Two\n\nMore.\n", "lessons/07-some-thing.md");
  EXPECT_EQ(lesson.id, "some-thing");
  EXPECT_EQ(lesson.title, "Title");
  EXPECT_EQ(lesson.summary, "What it is.\n\n");
  ASSERT_EQ(lesson.steps.size(), 2u);
  EXPECT_EQ(lesson.steps[0].title, "One");
  EXPECT_EQ(lesson.steps[0].text, "Some *text*.\n");
  EXPECT_EQ(lesson.steps[1].text, "More.\n");
}

TEST(Lesson, AStepKnowsItsLineBehindATaskToo) {
  const taa::Lesson lesson = taa::lessonFromText(
      step("task: metric psnr > 30\nsolution: set weight.alpha=0.5\n") + "## Two\n\nMore.\n", "some.md");
  EXPECT_EQ(lesson.steps[0].line, 5);
  EXPECT_EQ(lesson.steps[1].line, 13);
}

TEST(Lesson, AStepGoesOnFromTheOneBefore) {
  const taa::Lesson lesson = taa::lessonFromText(
      step("scene: builtin:fan\nframe: 7\npreset: minimal\nview: resolved\nview: alpha\nprobe: 3,4\n") +
          "## Two\n```state\nset: weight.alpha=0.5\nview: color\n```\n",
      "some.md");
  const taa::LessonState& state = lesson.steps[1].state;
  EXPECT_EQ(state.shot.source, "builtin:fan");
  EXPECT_EQ(state.shot.frame, 7);
  EXPECT_EQ(state.shot.settings.settings.weight.alpha, 0.5f);
  ASSERT_EQ(state.views.size(), 1u);
  EXPECT_EQ(state.views.front().id, taa::IntermediateId::color);
  ASSERT_EQ(state.probes.size(), 1u);
  EXPECT_EQ(state.probes.front(), glm::ivec2(3, 4));
}

TEST(Lesson, UnfoldsTheStagesOfWhatAStepSets) {
  const taa::Lesson lesson = taa::lessonFromText(
      step("preset: minimal\nset: rectify.method=clamp weight.alpha=0.2\nset: rectify.minStrength=0.5\n") +
          "## Two\n```state\nframe: 3\n```\n## Three\n```state\nstage: output\n```\n"
          "## Four\n```state\npreset: minimal\n```\n",
      "some.md");
  using Stages = std::vector<taa::Stage>;
  const auto stages = [&](std::size_t at) { return lesson.steps[at].state.stages; };
  EXPECT_EQ(stages(0), (Stages{taa::Stage::BlendWeight, taa::Stage::RectifyHistory})) << "the last is shown";
  EXPECT_EQ(stages(1), stages(0));
  EXPECT_EQ(stages(2), Stages{taa::Stage::Output});
  EXPECT_EQ(stages(3), Stages{}) << "nothing differs from a preset";
  EXPECT_NE(refusal(step("stage: rectify\n")).find("there is no stage \"rectify\""), std::string::npos);
}

TEST(Lesson, ReadsClaimsTasksHintsAndSolutions) {
  const taa::Lesson lesson =
      taa::lessonFromText(step("scene: builtin:fan\npreset: minimal\nlane: off = off\nclaim: metric psnr > "
                               "metric psnr of off * 2 + 1\n"
                               "task: probe picked boxMin.y at 3 <= 0.5\nhint: Look.\nsolution: probe 1,2\n"),
                          "some.md");
  const taa::LessonStep& only = lesson.steps.front();
  ASSERT_EQ(only.claims.size(), 1u);
  EXPECT_EQ(only.claims.front().right.lane, "off");
  EXPECT_EQ(only.claims.front().right.factor, 2.0);
  EXPECT_EQ(only.claims.front().right.offset, 1.0);
  ASSERT_TRUE(only.task);
  const taa::Quantity& asked = only.task->conditions.front().left;
  EXPECT_EQ(asked.row, taa::IntermediateId::boxMin);
  EXPECT_EQ(asked.channel, 1);
  EXPECT_EQ(asked.frame, 3);
  EXPECT_FALSE(asked.pixel);
  ASSERT_EQ(only.task->solution.probes.size(), 1u);
  EXPECT_EQ(only.task->solution.probes.front(), glm::ivec2(1, 2));
  EXPECT_TRUE(only.state.probes.empty());
}

TEST(Lesson, PosesLieEvenlyBetweenThoseThatAreSaidAndRestBeyond) {
  const taa::Lesson lesson = taa::lessonFromText(
      step("scene: builtin:fan\npose: 2 0,1,4 10,0\npose: 6 2,1,4 -10,4\n") +
          "## Two\n```state\ncamera: still\n```\n## Three\n```state\npose: 0 1,1,1 0,0\n```\n",
      "some.md");
  const taa::CameraTrack& track = lesson.steps[0].state.shot.track.value();
  EXPECT_EQ(track.at(0).position, glm::vec3(0, 1, 4));
  EXPECT_EQ(track.at(3).position, glm::vec3(0.5f, 1, 4));
  EXPECT_EQ(track.at(4).yaw, 0.0f);
  EXPECT_EQ(track.at(5).pitch, 3.0f);
  EXPECT_EQ(track.at(40).position, glm::vec3(2, 1, 4));
  EXPECT_FALSE(lesson.steps[1].state.shot.track);
  EXPECT_EQ(lesson.steps[2].state.shot.track.value().poses.size(), 1u);
}

TEST(Lesson, RecordsFramesWithTheirFaultsAndResolvesThemWithout) {
  const taa::Lesson lesson = taa::lessonFromText(
      step("scene: builtin:fan\nrecord: 6 like=unreal preset=minimal fault=motionNegated reference=8\n"
           "preset: sharp\n") +
          "## Two\n```state\nscene: builtin:fence\n```\n",
      "some.md");
  const taa::LessonState& state = lesson.steps[0].state;
  ASSERT_TRUE(state.recording);
  EXPECT_EQ(state.recording->frames, 6);
  EXPECT_EQ(state.recording->like, "unreal");
  EXPECT_EQ(state.recording->referenceSamples, 8);
  EXPECT_EQ(state.recording->settings.fault.motionX, -1.0f);
  EXPECT_EQ(state.shot.settings.settings.fault.motionX, 1.0f);
  EXPECT_FALSE(lesson.steps[1].state.recording);
}

TEST(Lesson, NamesATechniqueOnceHoweverOftenItsStepsDo) {
  const taa::Lesson lesson = taa::lessonFromText(
      step("techniques: 11.1 J9\n") + "## Two\n```state\ntechniques: J9 11.2\n```\n", "some.md");
  EXPECT_EQ(lesson.techniques, (std::vector<std::string>{"11.1", "J9", "11.2"}));
}

TEST(Lesson, ALadderIsATableBehindTheText) {
  const taa::Lesson lesson = taa::lessonFromText(step("scene: builtin:fan\n"
                                                      "rung: source000-4 psnr=21.44 flicker=0.0123\n"
                                                      "rung: off psnr=20 flicker=0.2\n"),
                                                 "some.md");
  const taa::LessonStep& only = lesson.steps.front();
  ASSERT_EQ(only.ladder.size(), 2u);
  EXPECT_EQ(only.ladder[0].preset, "source000-4");
  EXPECT_EQ(only.ladder[0].psnr, 21.44);
  EXPECT_EQ(only.ladder[0].flicker, 0.0123);
  EXPECT_EQ(only.ladder[1].line, 10);
  EXPECT_EQ(only.text, "Some *text*.\n");
  // Nine samples for the box, one motion vector, one bilinear tap of history.
  const std::string note = "\n*Fetches*: texture reads of the resolve for a pixel, a tap of a filter as one.";
  EXPECT_EQ(taa::ladderMarkdown(only.ladder), "| Preset | PSNR | Flicker | Fetches |\n|---|---|---|---|\n"
                                              "| 4. clamp | 21.4 | 0.0123 | 11 |\n"
                                              "| TAA off | 20.0 | 0.2000 | 1 |\n" +
                                                  note + "\n");
  EXPECT_EQ(taa::ladderMarkdown(only.ladder, {.times = {1.0, 0.25}, .isLinked = true}),
            "| Preset | PSNR | Flicker | Fetches | Time |\n|---|---|---|---|---|\n"
            "| [4. clamp](rung:source000-4) | 21.4 | 0.0123 | 11 | 1.00 | \n"
            "| [TAA off](rung:off) | 20.0 | 0.2000 | 1 | 0.25 | \n" +
                note + " *Time*: of the resolve, as many times that of the first row.\n");
  EXPECT_EQ(taa::ladderMarkdown({}), "");
}

TEST(Lesson, RefusesWhatItDoesNotKnowWithTheLine) {
  const std::pair<std::string, std::string> wrong[] = {
      {"scene: builtin:fam\n", "some.md:8: there is no scene \"builtin:fam\"; near it is \"builtin:fan\""},
      {"sceen: builtin:fan\n", "some.md:8: there is no key \"sceen\"; near it is \"scene\""},
      {"preset: minimum\n", "some.md:8: there is no preset \"minimum\"; near it is \"minimal\""},
      {"claim: metric psnr > lots\n", "some.md:8: \"lots\" is none of metric, probe, difference, share, "
                                      "verdict, doctor, lineage, volume, levels, "
                                      "pushed, fetches, changed and time"},
      {"claim: lineage 3,4 blur > 1\n",
       "some.md:8: \"blur\" is none of samples, frames, radius, spread and older"},
      {"claim: pushed two > 1\n", "some.md:8: what is pushed is: pushed none, or pushed several"},
      {"pose: 3 0,1,2\n", "some.md:8: expected FRAME X,Y,Z YAW,PITCH"},
      {"pose: 3 0,1,2 0,0\npose: 3 0,1,2 0,0\n", "some.md:9: frame 3 comes after frame 3"},
      {"record: 99\n", "some.md:8: \"99\" is not a whole number from 1 to 32"},
      {"record: 4 like=unreal twice\n",
       "some.md:8: expected FRAMES like=ENGINE preset=PRESET fault=FAULT reference=SAMPLES"},
      {"claim: metric psnr of off > 1\n", "some.md:8: the step has no lane \"off\""},
      {"claim: metric psnr > 1 2\n", "some.md:8: \"2\" is more than the condition needs"},
      {"rung: source000-44 psnr=1 flicker=1\n",
       "some.md:8: there is no preset \"source000-44\"; near it is \"source000-4\""},
      {"rung: off psnr=1\n", "some.md:8: expected PRESET psnr=NUMBER flicker=NUMBER"},
      {"rung: off flicker=1 psnr=1\n", "some.md:8: expected PRESET psnr=NUMBER flicker=NUMBER"},
      {"probe: 3\n", "some.md:8: \"3\" is no pixel: expected X,Y"},
      {"frame: -1\n", "some.md:8: \"-1\" is not a whole number from 0 to 100000"},
      {"nonsense\n", "some.md:8: \"nonsense\" is no line of a header: expected key: value"},
  };
  for (const auto& [header, sentence] : wrong) EXPECT_EQ(refusal(step(header)), sentence) << header;
}

TEST(Lesson, RefusesWhatLacksAPart) {
  EXPECT_EQ(refusal("## One\n"), "some.md:1: the lesson has no title: \"# \" and its name");
  EXPECT_EQ(refusal("# Title\n"), "some.md:1: the lesson has no step: \"## \" and its name");
  EXPECT_EQ(refusal("# T\n## One\n```state\n"), "some.md:3: the header has no end: ``` is missing");
  EXPECT_EQ(refusal("# T\n```state\n"), "some.md:2: a header comes below the title of a step");
  EXPECT_EQ(refusal(step("hint: None.\n")), "some.md:5: the step has a hint or a solution and no task");
}

TEST(Lesson, RefusesMoreThanALessonNeeds) {
  EXPECT_NE(refusal(std::string(taa::kMaxLessonBytes + 1, 'a')).find("more than"), std::string::npos);
  std::string many = "# T\n";
  for (std::size_t i = 0; i <= taa::kMaxLessonSteps; ++i) many += "## S\n";
  EXPECT_NE(refusal(many).find("at most 64 steps"), std::string::npos);
  std::string lines;
  for (std::size_t i = 0; i <= taa::kMaxStepLines; ++i) lines += "frame: 1\n";
  EXPECT_NE(refusal(step(lines)).find("at most 128 lines"), std::string::npos);
  std::string rungs;
  for (std::size_t i = 0; i <= taa::kMaxRungs; ++i) rungs += "rung: off psnr=1 flicker=1\n";
  EXPECT_NE(refusal(step(rungs)).find("at most 20 rungs"), std::string::npos);
}

TEST(Lesson, OpensNothingBesideItsFolder) {
  const fs::path folder = taa::test::temporaryFolder() / "lesson-folder" / "lessons";
  fs::create_directories(folder);
  taa::writeFile(folder.parent_path() / "outside.glb", "x");
  taa::writeFile(folder / "inside.glb", "x");
  taa::writeFile(folder / "out.md", step("scene: ../outside.glb\n"));
  taa::writeFile(folder / "in.md", step("scene: inside.glb\n"));
  const taa::LessonFolder read = taa::readLessons(folder);
  ASSERT_EQ(read.lessons.size(), 1u);
  EXPECT_EQ(read.lessons.front().id, "in");
  ASSERT_EQ(read.errors.size(), 1u);
  EXPECT_NE(read.errors.front().find("out.md:8: "), std::string::npos) << read.errors.front();
  EXPECT_NE(refusal(step("scene: inside.glb\n")).find("no built-in scene"), std::string::npos);
}

TEST(Lesson, RefusalsNameTheFileAndTheLineOnce) {
  EXPECT_EQ(refusal(""), "some.md: the lesson has no title: \"# \" and its name");
  EXPECT_EQ(refusal("# T\n\x1b[2J\n"), "some.md:2: the line has bytes that are no text");
  EXPECT_EQ(
      refusal(step("techniques: 4.1 99.9\n")).find("some.md:8: there is no technique \"99.9\"; near it is "),
      0u);
  const auto refusalOf = [](const char* path) {
    try {
      taa::readLesson(path);
    } catch (const taa::Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusalOf("/dev/zero"), "cannot open /dev/zero: it is not a regular file");
  EXPECT_EQ(refusalOf("/no/such/lesson.md"), "cannot open /no/such/lesson.md: No such file or directory");
}

TEST(Lesson, ALinkInAFolderOfLessonsLeadsNowhereElse) {
  const fs::path folder = taa::test::temporaryFolder() / "lesson-link" / "lessons";
  fs::remove_all(folder);
  fs::create_directories(folder);
  taa::writeFile(folder.parent_path() / "outside.md", step(""));
  fs::create_symlink(folder.parent_path() / "outside.md", folder / "in.md");
  const taa::LessonFolder read = taa::readLessons(folder);
  EXPECT_TRUE(read.lessons.empty());
  ASSERT_EQ(read.errors.size(), 1u);
  EXPECT_EQ(read.errors.front(), "in.md leads out of the folder; only files below it are opened");
}

TEST(Lesson, AFolderThatIsNotThereIsAnErrorInWords) {
  const taa::LessonFolder read = taa::readLessons("/no/such/folder");
  EXPECT_TRUE(read.lessons.empty());
  ASSERT_EQ(read.errors.size(), 1u);
  EXPECT_NE(read.errors.front().find("cannot read the folder"), std::string::npos);
}

TEST(Lesson, BuiltinOnesHaveNamesOfTheirOwnAndTeachTechniquesThatThereAre) {
  std::set<std::string> ids, rows;
  for (const taa::Technique& technique : taa::techniques()) rows.emplace(technique.row);
  for (const taa::Lesson& lesson : taa::builtinLessons()) {
    EXPECT_TRUE(ids.insert(lesson.id).second) << lesson.id;
    EXPECT_FALSE(lesson.summary.empty()) << lesson.place;
    for (const std::string& row : lesson.techniques)
      EXPECT_TRUE(rows.contains(row)) << lesson.place << ": " << row;
  }
  EXPECT_GE(ids.size(), 3u);
}

TEST(Lesson, FoldsTheStagesThatNoValueItSpeaksOfIsOf) {
  const taa::Lesson lesson = taa::lessonFromText(step("scene: builtin:fan\nvalues: rejectReason alpha\n") +
                                                     "## Then\n\n```state\nframe: 3\n```\n\nText.\n",
                                                 "some.md");
  const auto probe = [&](std::size_t number) {
    const taa::SessionFile session = taa::lessonSession(lesson.steps.at(number).state);
    return nlohmann::json::parse(session.window).at("probe");
  };
  const auto folded = [&](std::size_t number) {
    return probe(number).at("folded").get<std::set<std::string>>();
  };
  EXPECT_EQ(probe(0).at("at"), "rejectReason") << "it is scrolled to";
  EXPECT_FALSE(probe(1).contains("at"));
  std::set<std::string> others;
  for (const taa::StageInfo& info : taa::kStages) others.emplace(info.id);
  for (const taa::IntermediateId id : {taa::IntermediateId::rejectReason, taa::IntermediateId::alpha})
    EXPECT_EQ(others.erase(std::string(taa::stageInfo(taa::intermediate(id).stage).id)), 1u);
  EXPECT_EQ(folded(0), others);
  EXPECT_TRUE(folded(1).empty()) << "the next step speaks of others";
}

TEST(Lesson, AStateIsASessionThatReadsBack) {
  const taa::Lesson lesson = taa::lessonFromText(step("scene: builtin:fan\nframe: 7\npreset: minimal\nset: "
                                                      "weight.alpha=0.5\nview: alpha compare=preset:off "
                                                      "high=0.5\nprobe: 3,4\nplots: alpha\npage: plots\n"),
                                                 "some.md");
  const taa::SessionFile session = taa::lessonSession(lesson.steps.front().state);
  const taa::SessionFile read = taa::sessionFromText(taa::sessionToText(session), "session");
  EXPECT_EQ(read.source, "builtin:fan");
  EXPECT_EQ(read.frame, 7);
  EXPECT_EQ(read.size, taa::kLessonSizePx);
  EXPECT_TRUE(read.settings.settings == session.settings.settings);
  EXPECT_NE(read.window.find("\"comparedWith\":\"preset:off\""), std::string::npos) << read.window;
  EXPECT_NE(read.window.find("\"lower\":\"plots\""), std::string::npos) << read.window;
}
