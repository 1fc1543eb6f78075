// Captures whose conventions are stated wrongly, one or two of them at a time: the doctor names all that is
// wrong, and nothing else.
#include "core/base/Files.h"
#include "core/capture/format/Manifest.h"
#include "core/doctor/Doctor.h"
#include "core/inspect/Inspector.h"
#include "core/report/CaptureExport.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <future>
#include <set>
#include <string>
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
  /// All that is found in the frames where this is stated of them.
  std::vector<Finding> foundIn(const capture::Manifest& stated) const {
    writeFile(folder_ / capture::kManifestName, capture::manifestText(stated));
    const DoctorSource source = openForDoctor({folder_.string(), "", kStatedPx, {}});
    return examine(examinationOf(source, kStatedFrames)).findings;
  }
  /// Ids of it, in order.
  std::vector<std::string> found(const std::vector<std::string>& assignments) const {
    capture::Manifest stated = healthy_;
    for (const std::string& assignment : assignments) applyAssignment(stated.conventions, assignment);
    std::vector<std::string> ids;
    for (const Finding& finding : foundIn(stated)) ids.push_back(finding.id);
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
