// Captures whose conventions are stated wrongly, one or two of them at a time: the doctor names all that is
// wrong, and nothing else.
#include "core/base/Files.h"
#include "core/capture/format/Manifest.h"
#include "core/doctor/examination/Doctor.h"
#include "core/doctor/source/StatedMotion.h"
#include "core/inspect/Inspector.h"
#include "core/report/CaptureExport.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <future>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kStatedFrames = 12;
constexpr glm::ivec2 kStatedPx{240, 136};

/// What is stated instead of what is so, and the id of the finding that tells it.
struct Misstated {
  std::string assignment, id;
};

/// Frames in which a camera goes around things that move, in the conventions of `like`.
class StatedCapture {
 public:
  StatedCapture(const std::string& name, const CaptureChoice& choice)
      : folder_(test::temporaryFolder() / name) {
    // One inspector has the context of a thread.
    std::async(std::launch::async, [&] { write(choice); }).get();
    healthy_ = capture::readManifest(folder_);
  }

  const capture::Manifest& healthy() const { return healthy_; }
  const std::filesystem::path& folder() const { return folder_; }
  capture::Manifest stating(const std::vector<std::string>& assignments) const {
    capture::Manifest stated = healthy_;
    for (const std::string& assignment : assignments) applyAssignment(stated.conventions, assignment);
    return stated;
  }
  /// All that is found in the frames where this is stated of them.
  std::vector<Finding> foundIn(const capture::Manifest& stated) const {
    return examine(examinationOf(open(stated), kStatedFrames)).findings;
  }
  DoctorSource open(const capture::Manifest& stated) const {
    writeFile(folder_ / capture::kManifestName, capture::manifestText(stated));
    return openForDoctor({folder_.string(), "", kStatedPx, {}});
  }
  /// Ids of it, in order.
  std::vector<std::string> found(const std::vector<std::string>& assignments) const {
    std::vector<std::string> ids;
    for (const Finding& finding : foundIn(stating(assignments))) ids.push_back(finding.id);
    return ids;
  }

 private:
  void write(const CaptureChoice& choice) const {
    std::filesystem::create_directories(folder_);
    Inspector inspector;
    inspector.shot().setSize(kStatedPx.x, kStatedPx.y);
    inspector.shot().open("builtin:gallery");
    inspector.shot().setCamera("orbit");
    CaptureExport files(inspector, choice, 0, kStatedFrames - 1);
    for (int frame = 0; frame < kStatedFrames; ++frame) {
      inspector.shot().seek(frame);
      files.add(folder_, {});
    }
    files.finish(folder_);
  }

  std::filesystem::path folder_;
  capture::Manifest healthy_;
};

class StatedConventions : public test::GlTest {
 protected:
  static const StatedCapture& own() {
    static const StatedCapture kOwn("stated-own", {});
    return kOwn;
  }
};

using Ids = std::vector<std::string>;

/// In no order.
std::multiset<std::string> setOf(const Ids& ids) {
  return {ids.begin(), ids.end()};
}

} // namespace

TEST_F(StatedConventions, AreNamedWhereOneIsWrong) {
  const Misstated one[] = {{"motion.direction=previousMinusCurrent", "motionNegated"},
                           {"motion.unit=uv", "motionUnit"},
                           {"motion.unit=ndc", "motionUnit"},
                           {"motion.yAxis=up", "motionNegatedY"},
                           {"motion.scaleX=-1", "motionNegatedX"},
                           {"motion.encoding=unreal", "motionNotEncoded"},
                           {"motion.jitter=both", "motionJitterTakenOff"},
                           {"motion.includesCamera=off", "motionCameraTwice"},
                           {"jitter.unit=uv", "jitterUnit"},
                           {"jitter.unit=ndc", "jitterUnit"},
                           {"jitter.yAxis=up", "jitterNegatedY"},
                           {"jitter.delay=-1", "jitterEarly"},
                           {"depth.range=minusOneToOne", "depthRange"},
                           {"matrices.clipY=down", "matricesFlipped"},
                           {"matrices.jittered=on", "matricesNotJittered"}};
  EXPECT_EQ(own().found({}), Ids{});
  for (const Misstated& stated : one)
    EXPECT_EQ(own().found({stated.assignment}), Ids{stated.id}) << stated.assignment;
}

// Frames are called by the numbers that the capture gives them, where one is missing.
TEST_F(StatedConventions, HoldNumbersOfFrames) {
  const StatedCapture shot("numbers", {});
  capture::Manifest stated = shot.healthy();
  EXPECT_EQ(shot.open(stated).frameNames.number(7), std::nullopt);
  stated.frames.erase(stated.frames.begin() + 5);
  EXPECT_EQ(examinationOf(shot.open(stated), kStatedFrames).captureInfo.frameNames.of(7), "7 (number 8)");
}

TEST_F(StatedConventions, AreNamedWhereTwoAreWrong) {
  const Misstated all[] = {{"motion.direction=previousMinusCurrent", "motionNegated"},
                           {"motion.unit=uv", "motionUnit"},
                           {"motion.yAxis=up", "motionNegatedY"},
                           {"jitter.meaning=sample", "jitterNegated"},
                           {"jitter.delay=1", "jitterLate"},
                           {"depth.reversed=off", "depthReversed"},
                           {"depth.kind=planar", "depthKind"},
                           {"depth.nearPlane=0.5", "nearPlaneWrong"}};
  for (auto one = std::begin(all); one != std::end(all); ++one)
    for (auto two = one; two != std::end(all); ++two) {
      const bool isOfDistance = one != two && two->id == "nearPlaneWrong" && one->id == "depthKind";
      // Distances are not reversed, and have no near plane: a capture that says so is refused.
      if (isOfDistance || (one->id == "depthReversed" && two->id == "depthKind")) continue;
      Ids expected = one == two ? Ids{one->id} : Ids{one->id, two->id};
      // x alone is negated then.
      if (setOf(expected) == setOf({"motionNegated", "motionNegatedY"})) expected = {"motionNegatedX"};
      const Ids assignments = one == two ? Ids{one->assignment} : Ids{one->assignment, two->assignment};
      EXPECT_EQ(setOf(own().found(assignments)), setOf(expected))
          << one->assignment << " " << two->assignment;
    }
}

// The next place of the sequence is often about the opposite of this one: some pairs of frames tell it from
// what is stated, and the shifts that are measured.
TEST_F(StatedConventions, OfJitterThatIsNegatedAndOfTheFrameBefore) {
  EXPECT_EQ(setOf(own().found({"jitter.meaning=sample", "jitter.delay=-1"})),
            setOf({"jitterNegated", "jitterEarly"}));
}

// Jitter of a unit that makes next to nothing of it, with a sign that pictures tell then.
TEST_F(StatedConventions, OfJitterThatIsNextToNone) {
  const StatedCapture godot("stated-small-jitter", {"godot", {}});
  EXPECT_EQ(godot.found({"jitter.unit=pixels"}), Ids{"jitterUnit"});
  EXPECT_EQ(godot.found({"jitter.unit=pixels", "jitter.meaning=sample"}),
            (Ids{"jitterUnit", "jitterNegated"}));
}

// Of a jitter that nothing explains no pixel of motion says anything; what is stored does.
TEST_F(StatedConventions, OfMotionAreNamedBesideJitterThatIsNot) {
  const StatedCapture babylon("stated-babylon", {"babylon", {}});
  EXPECT_EQ(babylon.found({"motion.jitter=both", "jitter.delay=-1"}), Ids{"motionJitterTakenOff"});
}

// Depth and matrices say which two of all that motion is decoded by are stated wrongly; what is stated
// rightly stays as it is. Of two that undo each other, or lie in one number, one is enough.
TEST_F(StatedConventions, OfMotionAreSetRightInPairs) {
  struct Wrong {
    std::string group;
    Misstated stated;
  };
  const Wrong all[] = {{"unit", {"motion.unit=uv", "motionUnit"}},
                       {"unit", {"motion.unit=ndc", "motionUnit"}},
                       {"axes", {"motion.direction=previousMinusCurrent", "motionNegated"}},
                       {"axes", {"motion.yAxis=up", "motionNegatedY"}},
                       {"axes", {"motion.scaleX=-1", "motionNegatedX"}},
                       {"camera", {"motion.includesCamera=off", "motionCameraTwice"}},
                       {"jitter", {"motion.jitter=both", "motionJitterTakenOff"}},
                       {"jitter", {"motion.jitter=current", "motionJitterTakenOff"}},
                       {"order", {"depth.reversed=off", "depthReversed"}},
                       {"range", {"depth.range=minusOneToOne", "depthRange"}},
                       {"clip", {"matrices.clipY=down", "matricesFlipped"}}};
  const capture::Conventions& healthy = own().healthy().conventions;
  for (auto one = std::begin(all); one != std::end(all); ++one)
    for (auto two = std::next(one); two != std::end(all); ++two) {
      if (one->group == two->group) continue;
      capture::Manifest stated = own().stating({one->stated.assignment, two->stated.assignment});
      std::multiset<std::string> ids;
      for (const Finding& finding : correctMotion(own().folder(), stated)) ids.insert(finding.id);
      EXPECT_EQ(ids, setOf({one->stated.id, two->stated.id}))
          << one->stated.assignment << " " << two->stated.assignment;
      EXPECT_EQ(stated.conventions, healthy) << one->stated.assignment << " " << two->stated.assignment;
    }
}

// Pictures tell what is wrong alone, with more evidence; but not what is taken off, or added, by a statement.
TEST_F(StatedConventions, OfMotionAreLeftToPicturesWhereOneIsWrong) {
  const auto idsOf = [](const std::string& assignment) {
    capture::Manifest stated = own().stating({assignment});
    Ids ids;
    for (const Finding& finding : correctMotion(own().folder(), stated)) ids.push_back(finding.id);
    EXPECT_EQ(stated.conventions == own().healthy().conventions, !ids.empty()) << assignment;
    return ids;
  };
  for (const std::string assignment :
       {"motion.unit=uv", "motion.yAxis=up", "depth.reversed=off", "matrices.clipY=down"})
    EXPECT_EQ(idsOf(assignment), Ids{}) << assignment;
  EXPECT_EQ(idsOf("motion.includesCamera=off"), Ids{"motionCameraTwice"});
  EXPECT_EQ(idsOf("motion.jitter=both"), Ids{"motionJitterTakenOff"});
  EXPECT_EQ(idsOf("depth.range=minusOneToOne"), Ids{"depthRange"});
  capture::Manifest healthy = own().healthy();
  EXPECT_TRUE(correctMotion(own().folder(), healthy).empty());
}

// Motion whose jitter is taken off is decoded by what is stated of jitter.
TEST_F(StatedConventions, OfJitterAreNamedBesideThoseOfMotion) {
  const std::pair<Ids, Ids> pairs[] = {
      {{"motion.unit=uv", "motion.includesCamera=off"}, {"motionUnit", "motionCameraTwice"}},
      {{"motion.jitter=both", "jitter.delay=1"}, {"motionJitterTakenOff", "jitterLate"}},
      {{"motion.jitter=current", "jitter.yAxis=up"}, {"motionJitterTakenOff", "jitterNegatedY"}},
      {{"motion.includesCamera=off", "jitter.unit=uv"}, {"motionCameraTwice", "jitterUnit"}},
      {{"jitter.unit=ndc", "jitter.meaning=sample"}, {"jitterUnit", "jitterNegated"}},
      {{"jitter.unit=uv", "jitter.delay=-1"}, {"jitterUnit", "jitterEarly"}},
      {{"depth.range=minusOneToOne", "jitter.delay=1"}, {"depthRange", "jitterLate"}}};
  for (const auto& [assignments, ids] : pairs)
    EXPECT_EQ(setOf(own().found(assignments)), setOf(ids)) << assignments[0] << " " << assignments[1];
}

TEST_F(StatedConventions, OfMotionThatHoldsJitter) {
  const StatedCapture holding("stated-holding", {"taa-inspector", {"motion.jitter=both"}});
  EXPECT_EQ(holding.found({}), Ids{});
  EXPECT_EQ(holding.found({"motion.jitter=removed"}), Ids{"motionJitterBoth"});
  EXPECT_EQ(holding.found({"jitter.meaning=sample"}), Ids{"jitterNegated"});
  EXPECT_EQ(holding.found({"jitter.delay=1"}), Ids{"jitterLate"});
}

// Of an engine whose depth is not reversed: nearly all of it lies near 1, beyond the near plane.
TEST_F(StatedConventions, OfDepthThatIsNotReversed) {
  const StatedCapture fsr("stated-fsr", {"fsr", {}});
  EXPECT_EQ(fsr.found({}), Ids{});
  EXPECT_EQ(fsr.found({"depth.kind=planar"}), Ids{"depthKind"});
  const DoctorSource corrected = openForDoctor({fsr.folder().string(), "", kStatedPx, {}});
  EXPECT_FALSE(corrected.known.depthDistance) << "all else is examined by what it is";
  EXPECT_EQ(fsr.found({"depth.range=minusOneToOne"}), Ids{"depthRange"});
  EXPECT_EQ(fsr.found({"matrices.clipZ=minusOneToOne"}), Ids{"matricesRange"});
}

// Texture coordinates as pixels are next to nothing: the camera's motion, added once more, would fit.
TEST_F(StatedConventions, OfTextureCoordinates) {
  const StatedCapture unity("stated-unity", {"unity", {}});
  EXPECT_EQ(unity.found({}), Ids{});
  const auto corrected = [&](const Ids& assignments) {
    capture::Manifest stated = unity.stating(assignments);
    std::multiset<std::string> ids;
    for (const Finding& finding : correctMotion(unity.folder(), stated)) ids.insert(finding.id);
    EXPECT_EQ(stated.conventions == unity.healthy().conventions, !ids.empty());
    return ids;
  };
  EXPECT_EQ(corrected({"motion.unit=pixels"}), setOf({}));
  EXPECT_EQ(corrected({"motion.unit=pixels", "matrices.clipZ=zeroToOne"}),
            setOf({"motionInUv", "matricesRange"}));
  EXPECT_EQ(corrected({"motion.unit=pixels", "motion.includesCamera=off"}),
            setOf({"motionInUv", "motionCameraTwice"}));
  EXPECT_EQ(corrected({"motion.unit=ndc", "motion.includesCamera=off"}),
            setOf({"motionHalved", "motionCameraTwice"}));
}

TEST_F(StatedConventions, OfOpenGlsMatrices) {
  const StatedCapture godot("stated-godot", {"godot", {}});
  EXPECT_EQ(godot.found({}), Ids{});
  EXPECT_EQ(godot.found({"matrices.clipZ=zeroToOne"}), Ids{"matricesRange"});
  EXPECT_EQ(godot.found({"matrices.clipZ=zeroToOne", "jitter.meaning=sample"}),
            (Ids{"matricesRange", "jitterNegated"}));
}

// All that has a y is wrong then: three findings would send somebody to three places.
TEST_F(StatedConventions, OfRowsAreOneFinding) {
  EXPECT_EQ(own().found({"rows=bottomFirst"}), Ids{"rowsTurned"});
  EXPECT_EQ(setOf(own().found({"rows=bottomFirst", "motion.jitter=both"})),
            setOf({"rowsTurned", "motionJitterTakenOff"}));
  EXPECT_EQ(setOf(own().found({"rows=bottomFirst", "depth.range=minusOneToOne"})),
            setOf({"rowsTurned", "depthRange"}));
}

// With matrices upside down all that is examined by them would look wrong.
TEST_F(StatedConventions, OfMatricesHideNothing) {
  EXPECT_EQ(own().found({"matrices.clipY=down", "jitter.meaning=sample"}),
            (Ids{"matricesFlipped", "jitterNegated"}));
  EXPECT_EQ(own().found({"matrices.jittered=on", "jitter.delay=1"}),
            (Ids{"matricesNotJittered", "jitterLate"}));
}

TEST_F(StatedConventions, OfMatricesWithJitter) {
  const StatedCapture jittered("stated-jittered", {"taa-inspector", {"matrices.jittered=on"}});
  EXPECT_EQ(jittered.found({}), Ids{});
  EXPECT_EQ(jittered.found({"matrices.jittered=off"}), Ids{"matricesJittered"});
  EXPECT_EQ(jittered.found({"jitter.meaning=sample"}), Ids{"jitterNegated"});
  EXPECT_EQ(jittered.found({"jitter.delay=1"}), Ids{"jitterLate"});
}

TEST_F(StatedConventions, OfAnEncodingWithoutSign) {
  const StatedCapture unreal("stated-unreal", {"unreal", {}});
  EXPECT_EQ(unreal.found({}), Ids{});
  EXPECT_EQ(unreal.found({"motion.encoding=plain"}), Ids{"motionEncoded"});
  EXPECT_EQ(unreal.found({"motion.encoding=plain", "jitter.meaning=sample"}),
            (Ids{"motionEncoded", "jitterNegated"}));
}

// Of two near planes that contradict each other motion tells which is right: here the stated one is.
TEST_F(StatedConventions, OfANearPlaneOrItsMatrices) {
  capture::Manifest stated = own().healthy();
  for (capture::CapturedFrame& frame : stated.frames) {
    double& nearPlane = (*frame.projection)[11];
    stated.conventions.depth.nearPlane = nearPlane;
    nearPlane *= 5.0;
  }
  const std::vector<Finding> found = own().foundIn(stated);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, "nearPlaneWrong");
  EXPECT_NE(found[0].change.find("State the matrices"), std::string::npos) << found[0].change;
}

} // namespace taa::doctor
