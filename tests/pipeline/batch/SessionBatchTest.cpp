// Sessions, styles and animations on the command line of taa-batch.
#include "core/base/Files.h"
#include "core/io/SessionFile.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"

#include <OpenImageIO/imageio.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using taa::test::ProcessResult;

class SessionBatchTest : public taa::test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    folder_ = taa::test::temporaryFolder() / "session";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    taa::SessionFile session;
    session.source = "builtin:fan";
    session.camera = "orbit";
    session.frame = 5;
    session.size = {64, 36};
    session.settings = {"fsr2", taa::preset("fsr2").settings, taa::preset("fsr2").settings};
    taa::applyAssignment(session.settings.settings, "weight.minimum=0.25");
    writeSession(file(), session);
  }
  fs::path file() const { return folder_ / "it.taa.json"; }
  static ProcessResult batch(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), taa::test::binary("taa-batch").string());
    return taa::test::runProcess(arguments);
  }
  std::vector<std::string> flags(const char* command) const {
    return {command, "builtin:fan", "--size", "64x36", "--camera",
            "orbit", "--preset",    "fsr2",   "--set", "weight.minimum=0.25"};
  }
  fs::path folder_;
};

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

} // namespace

TEST_F(SessionBatchTest, ASessionIsTheSameAsItsFlags) {
  const std::vector<std::string> png = {"--format", "png", "--out"};
  const std::string a = (folder_ / "a").string(), b = (folder_ / "b").string();
  ASSERT_EQ(batch(joined(joined({"render", "--session", file().string()}, png), {a})).exitCode, 0);
  ASSERT_EQ(batch(joined(joined(flags("render"), {"--frames", "5"}), joined(png, {b}))).exitCode, 0);
  EXPECT_EQ(taa::readFile(a + "/frame.0005.resolved.png"), taa::readFile(b + "/frame.0005.resolved.png"));
  const ProcessResult is = batch({"probe", "--session", file().string(), "--pixel", "30,20"});
  const ProcessResult want = batch(joined(flags("probe"), {"--frame", "5", "--pixel", "30,20"}));
  EXPECT_EQ(is.exitCode, 0) << is.err;
  EXPECT_EQ(is.out, want.out);
  const ProcessResult other =
      batch({"probe", "--session", file().string(), "--set", "weight.minimum=0.5", "--pixel", "30,20"});
  EXPECT_NE(other.out, want.out);
}

TEST_F(SessionBatchTest, RestartsAndClassesAreFlagsAndPartOfASession) {
  taa::SessionFile session = taa::readSession(file());
  session.restarts = {5};
  writeSession(file(), session);
  const auto reasonOf = [&](const std::vector<std::string>& arguments) {
    const ProcessResult result = batch(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return nlohmann::json::parse(result.out)
        .at("lanes")
        .at(0)
        .at("values")
        .at("rejectReason")
        .at("V")
        .get<float>();
  };
  const std::vector<std::string> probe{"--pixel", "30,20", "--json"};
  EXPECT_EQ(reasonOf(joined({"probe", "--session", file().string()}, probe)), 1.0f) << "no history";
  const std::vector<std::string> at5 = joined(flags("probe"), joined({"--frame", "5"}, probe));
  EXPECT_NE(reasonOf(at5), 1.0f);
  EXPECT_EQ(reasonOf(joined(at5, {"--restart", "2", "--restart", "5"})), 1.0f);
  const ProcessResult late = batch(joined(at5, {"--restart", "240"}));
  EXPECT_EQ(late.exitCode, 2);
  EXPECT_NE(late.err.find("frame 240"), std::string::npos) << late.err;
  EXPECT_EQ(batch(joined(at5, {"--class", "nobody=character"})).exitCode, 2);
  EXPECT_EQ(batch(joined(at5, {"--class", "rotor=person"})).exitCode, 2);
}

// By each way that names come in, and by each command that takes them.
TEST_F(SessionBatchTest, OldNamesAreSaidOnceOnTheErrorStream) {
  const std::string note = "note: weight.most is called weight.sourceMax now\n";
  const auto notesIn = [&](const std::vector<std::string>& arguments) {
    const ProcessResult result = batch(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out.find("weight.most"), std::string::npos) << result.out;
    std::size_t count = 0;
    for (std::size_t at = result.err.find(note); at != std::string::npos; at = result.err.find(note, at + 1))
      ++count;
    return count;
  };
  const std::string preset = (folder_ / "old.json").string();
  taa::writeFile(preset, R"({"format": 1, "id": "a", "label": "A", "settings": {"weight": {"most": 0.5}}})");
  nlohmann::json session = nlohmann::json::parse(taa::readFile(file()));
  session["settings"]["weight"] = {{"most", 0.5}};
  taa::writeFile(file(), session.dump());
  const std::vector<std::string> small{"probe",   "builtin:fan", "--size",  "16x9",
                                       "--pixel", "3,3",         "--frame", "0"};
  EXPECT_EQ(notesIn(joined(small, {"--set", "weight.most=0.5"})), 1u);
  EXPECT_EQ(notesIn(joined(small, {"--lane", preset, "--lane", preset, "--set", "weight.most=0.5"})), 1u);
  EXPECT_EQ(notesIn({"probe", "--session", file().string(), "--pixel", "3,3"}), 1u);
  EXPECT_EQ(notesIn({"glsl", "--set", "weight.most=0.5"}), 1u);
  EXPECT_EQ(notesIn({"glsl", "--set", "weight.sourceMax=0.5"}), 0u);
}

TEST_F(SessionBatchTest, MistakesAreNamed) {
  EXPECT_EQ(batch({"probe", "--pixel", "1,1", "--frame", "0"}).exitCode, 2);
  EXPECT_EQ(batch({"probe", "builtin:fan", "--session", file().string(), "--pixel", "1,1"}).exitCode, 2);
  const ProcessResult missing = batch({"probe", "--session", "/nowhere.taa.json", "--pixel", "1,1"});
  EXPECT_EQ(missing.exitCode, 1);
  EXPECT_NE(missing.err.find("/nowhere.taa.json"), std::string::npos);
  const ProcessResult style =
      batch(joined(flags("render"), {"--frames", "0", "--out", folder_.string(), "--style", "map=pink"}));
  EXPECT_EQ(style.exitCode, 2);
  EXPECT_NE(style.err.find("viridis"), std::string::npos) << style.err;
}

TEST_F(SessionBatchTest, WhatItAsksForAndIsNotThereIsItsFaultAndWhatTheCallAsksForTheCalls) {
  const auto changed = [&](const char* name, auto change) {
    taa::SessionFile session = taa::readSession(file());
    change(session);
    const fs::path path = folder_ / (std::string(name) + ".taa.json");
    writeSession(path, session);
    return path.string();
  };
  const std::pair<std::string, std::string> cases[] = {
      {changed("camera", [](taa::SessionFile& session) { session.camera = "drone"; }),
       "there is no camera \"drone\" in builtin:fan"},
      {changed("animation", [](taa::SessionFile& session) { session.choice.animation = "walk"; }),
       "builtin:fan has one animation"},
      {changed("hidden", [](taa::SessionFile& session) { session.filter.hidden = {"sail"}; }),
       "no object is called \"sail\""},
      {changed("restart", [](taa::SessionFile& session) { session.restarts = {999}; }),
       "cannot restart the history at frame 999"},
      {changed("frame", [](taa::SessionFile& session) { session.frame = 999; }),
       "there is no frame 999: builtin:fan has frames 0 to 239"},
  };
  const std::vector<std::string> out = {"--out", (folder_ / "none").string()};
  for (const auto& [path, reason] : cases) {
    const ProcessResult result = batch(joined({"render", "--session", path}, out));
    EXPECT_EQ(result.exitCode, 1) << result.err;
    EXPECT_EQ(result.err.find("taa-batch: cannot open the session " + path + ": " + reason), 0u)
        << result.err;
  }
  const ProcessResult mine =
      batch(joined({"render", "--session", file().string(), "--hide", "sail", "--frames", "0"}, out));
  EXPECT_EQ(mine.exitCode, 2);
  EXPECT_EQ(mine.err.find("taa-batch: --hide: no object is called \"sail\""), 0u) << mine.err;
  const ProcessResult itsOwn =
      batch(joined({"render", "--session", cases[1].first, "--length", "9", "--frames", "0"}, out));
  EXPECT_EQ(itsOwn.exitCode, 1) << "its animation, whatever length the call gives: " << itsOwn.err;
  EXPECT_FALSE(fs::exists(out.back()));
}

TEST_F(SessionBatchTest, WritesAnAnimationForEachIntermediate) {
  const ProcessResult result =
      batch(joined(flags("render"), {"--frames", "0..2", "--emit", "resolved,alpha", "--style", "map=inferno",
                                     "--format", "gif", "--fps", "10", "--out", folder_.string()}));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  for (const char* name : {"resolved.gif", "alpha.gif"}) {
    const auto input = OIIO::ImageInput::open((folder_ / name).string());
    ASSERT_TRUE(input) << name;
    EXPECT_TRUE(input->seek_subimage(2, 0));
    EXPECT_FALSE(input->seek_subimage(3, 0));
    EXPECT_NE(result.out.find(name), std::string::npos);
  }
}
