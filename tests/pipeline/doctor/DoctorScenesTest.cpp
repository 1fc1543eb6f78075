// The doctor on frames that are really drawn, and on those of other engines: no false alarm on healthy ones.
#include "core/doctor/examination/Doctor.h"

#include "core/scene/builtin/SceneSource.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFrames = 10;

using FrameChange = std::function<void(DoctorFrame&)>;

class DoctorScenes : public test::GlTest {
 protected:
  static DoctorSource sourceOf(const std::string& source, const std::string& camera) {
    return openForDoctor({source, camera, {320, 180}, {}});
  }

  static Diagnosis diagnosisOf(const DoctorSource& source, const FrameChange& change = {},
                               int frames = kFrames) {
    Examination examination = examinationOf(source, frames);
    examination.read = [read = examination.read, change](int frame) {
      DoctorFrame out = read(frame);
      if (change) change(out);
      return out;
    };
    return examine(examination);
  }

  /// "motionNegatedY in object 2 (board)", by commas.
  static std::string told(const Diagnosis& diagnosis) {
    std::string text;
    for (const Finding& finding : diagnosis.findings) {
      text += (text.empty() ? "" : ", ") + finding.id + " in ";
      for (const RegionPlace& region : finding.regions)
        text += (finding.isWholePicture ? std::string("all") : region.name) + " ";
      text += "(" + finding.reason + ")";
    }
    return text;
  }

  /// What is said of places that no motion leads to.
  static std::string outliersOf(const Diagnosis& diagnosis) {
    const std::vector<Undecided>& undecided = diagnosis.parts.undecided();
    const auto motion = std::ranges::find(undecided, "Motion", &Undecided::question);
    return motion != undecided.end() && motion->isMisfit ? motion->reason : std::string();
  }

  /// Names of findings and of parts, that are right, or undecided, which stand there more than once.
  static std::string toldTwice(const Diagnosis& diagnosis) {
    std::set<std::string> names;
    std::string text;
    const auto add = [&](const std::string& name) {
      if (!names.insert(name).second) text += name + ";";
    };
    for (const Finding& finding : diagnosis.findings) add(finding.name);
    for (const RightPart& right : diagnosis.parts.right()) add(right.part);
    for (const Undecided& open : diagnosis.parts.undecided()) add(open.question);
    return text;
  }

  static std::string firstOf(const Diagnosis& diagnosis) {
    return diagnosis.findings.empty() ? "" : diagnosis.findings[0].id;
  }
};

} // namespace

TEST_F(DoctorScenes, OfThisProgramAreHealthy) {
  for (const BuiltinScene& scene : builtinScenes())
    for (const char* camera : {"still", "pan", "orbit"}) {
      const Diagnosis diagnosis = diagnosisOf(sourceOf("builtin:" + scene.id, camera));
      EXPECT_EQ(told(diagnosis), "") << scene.id << " " << camera;
      EXPECT_EQ(toldTwice(diagnosis), "") << scene.id << " " << camera;
      EXPECT_EQ(outliersOf(diagnosis), "") << scene.id << " " << camera;
    }
}

// As the command examines them without options: cuts, lights that go out and objects that stop are among
// these frames. Boards of the crowd lie in one place and are told.
TEST_F(DoctorScenes, OfThisProgramAreHealthyByTheirOwnCamera) {
  for (const BuiltinScene& scene : builtinScenes()) {
    const Diagnosis diagnosis = diagnosisOf(sourceOf("builtin:" + scene.id, ""), {}, kDoctorFrames);
    if (scene.id == "crowd")
      EXPECT_TRUE(told(diagnosis).starts_with("zFighting in object 175")) << told(diagnosis);
    else
      EXPECT_EQ(told(diagnosis), "") << scene.id;
    EXPECT_EQ(outliersOf(diagnosis), "") << scene.id;
  }
}

// Boards that slide by a fourth of the way are no contradiction of depth and matrices, which make the motion
// of the wall: that is right, and the boards are open, in one sentence.
TEST_F(DoctorScenes, LeaveOpenInOneSentenceWhatIsPartlyRight) {
  const Diagnosis diagnosis = diagnosisOf(openForDoctor({"builtin:disocclusion", "", {320, 180}, {}}));
  EXPECT_EQ(told(diagnosis), "");
  EXPECT_EQ(toldTwice(diagnosis), "");
  const std::vector<Undecided>& undecided = diagnosis.parts.undecided();
  const auto open = std::ranges::find(undecided, "Depth and matrices", &Undecided::question);
  ASSERT_NE(open, undecided.end());
  EXPECT_TRUE(open->reason.starts_with("Depth and matrices make the motion of what rests; not decided: "))
      << open->reason;
  EXPECT_FALSE(open->isMisfit) << open->reason;
}

TEST_F(DoctorScenes, ShowFaultsOfMotion) {
  const DoctorSource source = sourceOf("builtin:gallery", "orbit");
  const auto changed = [&](const std::function<glm::vec2(const glm::vec2&)>& change) {
    return firstOf(diagnosisOf(source, [&](DoctorFrame& frame) {
      for (std::size_t i = 0; i < frame.motionPx.pixels.size(); i += 2) {
        const glm::vec2 motion(frame.motionPx.pixels[i], frame.motionPx.pixels[i + 1]);
        if (!isMotion(motion)) continue;
        frame.motionPx.pixels[i] = change(motion).x;
        frame.motionPx.pixels[i + 1] = change(motion).y;
      }
    }));
  };
  EXPECT_EQ(changed([](const glm::vec2& m) { return glm::vec2(m.x, -m.y); }), "motionNegatedY");
  EXPECT_EQ(changed([](const glm::vec2& m) { return glm::vec2(-m.x, m.y); }), "motionNegatedX");
  EXPECT_EQ(changed([](const glm::vec2& m) { return 2.0f * m; }), "motionDoubled");
}

class DoctorOfEngines : public DoctorScenes {
 protected:
  /// Empty: it is not here.
  static std::string dataFolder(const std::string& name) {
    const std::filesystem::path folder = std::filesystem::path(TAA_SHARED_DATA) / name;
    return std::filesystem::exists(folder) ? folder.string() : std::string();
  }
};

/// Whether a note says something.
static bool isNoted(const Diagnosis& diagnosis, const std::string& part) {
  return std::ranges::any_of(diagnosis.notes,
                             [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

// That is what an import states of it; who states nothing is told that the sky has none.
TEST_F(DoctorOfEngines, BlenderIsHealthyWhereTheSkysMotionIsStatedToBeTheCameras) {
  const std::string folder = dataFolder("capture-blender");
  if (folder.empty()) GTEST_SKIP() << "the frames are not here";
  // In 14 frames the middle of one ring alone goes as the camera makes it, and what is seen of it does not.
  for (const int frames : {14, kDoctorFrames}) {
    const Diagnosis diagnosis = examine(examinationOf(sourceOf(folder, ""), frames));
    EXPECT_EQ(told(diagnosis), "");
    EXPECT_TRUE(isNoted(diagnosis, "motion.whereNothing"));
  }
}

TEST_F(DoctorOfEngines, ThreeIsHealthyAndItsFirstFrameIsNotJittered) {
  const std::string folder = dataFolder("capture-three");
  if (folder.empty()) GTEST_SKIP() << "the frames are not here";
  const Diagnosis diagnosis = examine(examinationOf(sourceOf(folder, ""), kDoctorFrames));
  EXPECT_EQ(told(diagnosis), "");
  EXPECT_TRUE(isNoted(diagnosis, "first frame is not jittered"));
  EXPECT_FALSE(isNoted(diagnosis, "motion.whereNothing"));
}

} // namespace taa::doctor
