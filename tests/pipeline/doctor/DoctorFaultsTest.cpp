// The doctor names faults that are injected into frames that are really drawn: a part of the table of
// confusions that takes seconds.
#include "core/doctor/Doctor.h"

#include "core/settings/Faults.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

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
        Fault::OffScreenClamped, Fault::LowPrecision}},
      {"disocclusion",
       "",
       {Fault::MotionHalved, Fault::MotionInUv, Fault::MotionCameraOnly, Fault::JitterSwapped,
        Fault::JitterFrozen}}};
  for (const FaultyShot& shot : shots) {
    EXPECT_TRUE(diagnosisWith(shot, nullptr).isHealthy()) << shot.scene;
    for (const Fault fault : shot.faults) {
      const Diagnosis diagnosis = diagnosisWith(shot, &fault);
      ASSERT_FALSE(diagnosis.isHealthy()) << faultInfo(fault).id << " in " << shot.scene;
      EXPECT_EQ(diagnosis.findings[0].id, faultInfo(fault).id) << shot.scene;
    }
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
