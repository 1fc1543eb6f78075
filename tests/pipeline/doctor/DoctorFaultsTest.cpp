// The doctor names faults that are injected into frames that are really drawn: a part of the table of
// confusions that takes seconds.
#include "core/doctor/examination/Doctor.h"

#include "core/settings/Faults.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFaultyFrames = 14; // the table's faults of one frame are in 8 and 12
constexpr glm::ivec2 kFaultyPx{240, 136};

struct FaultyShot {
  std::string scene, camera;
  std::vector<Fault> faults; ///< each by itself
};

Diagnosis diagnosisWith(const FaultyShot& shot, const Fault* fault) {
  SourceRequest request{"builtin:" + shot.scene, shot.camera, kFaultyPx, {}};
  if (fault) inject(*fault, request.settings);
  return examine(examinationOf(openForDoctor(request), kFaultyFrames));
}

class DoctorFaults : public test::GlTest {};

} // namespace

TEST_F(DoctorFaults, AreNamedFirst) {
  const std::vector<FaultyShot> shots = {
      {"gallery",
       "orbit",
       {Fault::MotionNegatedX, Fault::MotionSwapped, Fault::MotionZero, Fault::MotionShifted,
        Fault::MotionCoarse, Fault::JitterNegated, Fault::JitterLate, Fault::JitterDoubled,
        Fault::SkyWithoutMotion, Fault::HistoryNotSwapped, Fault::HistoryReadJittered, Fault::NanKept,
        Fault::AlphaOne, Fault::AlphaZero, Fault::BoxOfCorners, Fault::DilatesFarthest,
        Fault::OffScreenClamped, Fault::LowPrecision, Fault::DepthReversed, Fault::DepthLinear,
        // At silhouettes it has the motion of what is beside: outlines say nothing then.
        Fault::MotionLingers,
        // The way of small things over all frames holds that of the one.
        Fault::PreviousIdentity}},
      {"disocclusion",
       "",
       {Fault::MotionHalved, Fault::MotionInUv, Fault::MotionCameraOnly, Fault::JitterSwapped,
        Fault::JitterFrozen}},
      // What rests in the world rests on the screen: none of it is an interface.
      {"gallery", "still", {Fault::CameraOfSecondView, Fault::MotionRoot}},
      // Thin things that move before a sky; without jitter some of their edges stay where they are.
      {"crowd", "pan", {Fault::JitterNotApplied, Fault::SkyNotJittered}},
      {"crowd", "still", {Fault::JitterNotApplied, Fault::BoxOfCorners}},
      {"fence", "still", {Fault::InterfaceBefore}},
      // A camera that turns passes nothing; what boards hide tells which way around depth is.
      {"disocclusion", "pan", {Fault::DepthReversed, Fault::DepthLinear}},
      {"foliage", "still", {Fault::AlphaZero}},
      // The sky has the camera's own motion, as it is far away.
      {"foliage", "orbit", {Fault::CameraOfSecondView}},
      {"fence", "orbit", {Fault::CameraOfSecondView, Fault::NearPlaneWrong}},
      {"gallery", "pan", {Fault::CameraOfSecondView}},
      // Another near plane would make the same motion, but depth is this program's own.
      {"crowd", "orbit", {Fault::CameraOfSecondView}},
      {"foliage", "pan", {Fault::JitterFrozen}}};
  for (const FaultyShot& shot : shots) {
    EXPECT_TRUE(diagnosisWith(shot, nullptr).isHealthy()) << shot.scene;
    for (const Fault fault : shot.faults) {
      const Diagnosis diagnosis = diagnosisWith(shot, &fault);
      ASSERT_FALSE(diagnosis.isHealthy()) << faultInfo(fault).id << " in " << shot.scene;
      EXPECT_EQ(diagnosis.findings[0].id, faultInfo(fault).id) << shot.scene;
    }
  }
}

// Silhouettes are many there and sway a little: nothing was said of dilation.
TEST_F(DoctorFaults, OfDilationAreOpenWhereTheFarthestMakesAsGoodAsTheSame) {
  const Fault fault = Fault::DilatesFarthest;
  const Diagnosis diagnosis = diagnosisWith({"foliage", "orbit", {}}, &fault);
  EXPECT_TRUE(diagnosis.isHealthy());
  const auto open = std::ranges::find(diagnosis.parts.undecided(), "Dilation", &Undecided::question);
  ASSERT_NE(open, diagnosis.parts.undecided().end());
  EXPECT_EQ(open->reason, "at rims the motion of the farthest makes as good as the same");
}

// The silhouettes of what is coarse have the motion of what is beside, as those of motion that is late; but
// they showed nothing else a frame before.
TEST_F(DoctorFaults, OfACoarsePlaneAreNotLate) {
  const Fault fault = Fault::MotionCoarse;
  for (const Finding& finding : diagnosisWith({"crowd", "pan", {}}, &fault).findings)
    EXPECT_NE(finding.id, "motionLingers");
}

// Thin leaves shift by the jitter in few places, and an interface that rests has most of the detail.
TEST_F(DoctorFaults, OfAnInterfaceAreNotThoseOfJitter) {
  const Fault fault = Fault::InterfaceBefore;
  const Diagnosis diagnosis = diagnosisWith({"foliage", "still", {}}, &fault);
  for (const Finding& finding : diagnosis.findings) EXPECT_EQ(finding.id, "interfaceBefore");
  EXPECT_TRUE(std::ranges::any_of(diagnosis.parts.undecided(), [](const Undecided& open) {
    return std::ranges::count(open.faults, Fault::InterfaceBefore) > 0;
  }));
}

// Nothing but silhouettes and what is blended moves: the farthest of nine rests, and so does the pixel's own
// place.
TEST_F(DoctorFaults, OfDilationMayLookLikeNoReprojection) {
  const Fault fault = Fault::DilatesFarthest;
  const Diagnosis diagnosis = diagnosisWith({"glass", "still", {}}, &fault);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].confidence, Confidence::Likely);
  EXPECT_EQ(diagnosis.findings[0].alike, std::vector<std::string>{"dilatesFarthest"});
}

// Where depth has no jitter, its silhouettes are not those of the pictures, and say nothing of motion.
TEST_F(DoctorFaults, OfDepthAreNoneOfMotion) {
  const Fault fault = Fault::DepthNotJittered;
  const Diagnosis diagnosis = diagnosisWith({"text", "still", {}}, &fault);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].id, "depthNotJittered");
}

TEST_F(DoctorFaults, AreNamedInASkyThatHoldsAShareOfTheJitter) {
  for (const std::string scene : {"gallery", "crowd"}) {
    SourceRequest request{"builtin:" + scene, "pan", kFaultyPx, {}};
    ASSERT_TRUE(injectHalf(Fault::SkyNotJittered, request.settings));
    const Diagnosis diagnosis = examine(examinationOf(openForDoctor(request), kFaultyFrames));
    ASSERT_EQ(diagnosis.findings.size(), 1u) << scene;
    EXPECT_EQ(diagnosis.findings[0].id, faultInfo(Fault::SkyNotJittered).id);
    EXPECT_EQ(diagnosis.findings[0].name, "Sky with another jitter");
    // The factor is read off the frames: what was injected, more or less.
    EXPECT_NEAR(diagnosis.findings[0].residuals[0].value, 0.5, 0.15) << scene;
  }
}

// What these frames do not show is said to be open, and nothing is called right that is not.
TEST_F(DoctorFaults, AreLeftOpenWhereFramesDoNotShowThem) {
  struct OpenCase {
    std::string scene, camera;
    Fault fault;
    bool isHalf;
    std::string question;
  };
  const std::vector<OpenCase> cases = {
      {"fence", "still", Fault::JitterHalved, true, "Jitter's length"},
      {"crowd", "still", Fault::JitterHalved, true, "Jitter's length"},
      {"foliage", "orbit", Fault::AlphaOne, false, "The weight of the current frame"},
      {"crowd", "pan", Fault::CameraOfSecondView, false, "Motion of object 1 (ground)"},
      {"crowd", "orbit", Fault::OldTransformOnReturn, false, "small regions"}};
  for (const OpenCase& open : cases) {
    SourceRequest request{"builtin:" + open.scene, open.camera, kFaultyPx, {}};
    request.settings.inputs.shadows = Shadows::None; // where they move over the meadow, the weight shows
    if (open.isHalf)
      ASSERT_TRUE(injectHalf(open.fault, request.settings));
    else
      inject(open.fault, request.settings);
    const Diagnosis diagnosis = examine(examinationOf(openForDoctor(request), kFaultyFrames));
    EXPECT_TRUE(diagnosis.isHealthy()) << open.question;
    EXPECT_TRUE(std::ranges::any_of(diagnosis.parts.undecided(), [&](const Undecided& undecided) {
      return undecided.question.find(open.question) != std::string::npos &&
             std::ranges::count(undecided.faults, open.fault) == 1;
    })) << open.question;
  }
}

// The fan's hub turns and looks the same: by depth and matrices it rests.
TEST_F(DoctorFaults, AreOneFindingWhereAPartMovesAsOneCannotSee) {
  SourceRequest request{"builtin:fan", "dolly", {480, 270}, {}};
  inject(Fault::MotionNegatedY, request.settings);
  const Diagnosis diagnosis = examine(examinationOf(openForDoctor(request), kFaultyFrames));
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].id, faultInfo(Fault::MotionNegatedY).id);
}

} // namespace taa::doctor
