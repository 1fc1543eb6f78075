// Frames with what was found made right: nothing is found in them, and they are nearer to the reference.
#include "core/doctor/examination/CorrectedLook.h"

#include "core/doctor/examination/Doctor.h"
#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace taa::doctor {
namespace {

class CorrectedLookTest : public test::GlTest {};

} // namespace

TEST_F(CorrectedLookTest, LeavesNothingToFindAndIsNearerToTheReference) {
  Settings faulty;
  inject(Fault::MotionNegatedY, faulty);
  DoctorSource source = openForDoctor({"builtin:gallery", "orbit", {240, 136}, faulty});
  const Diagnosis diagnosis = examine(examinationOf(source, 8));
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  const CorrectedLook look = lookAtCorrected(source, diagnosis, faulty, Settings{});
  EXPECT_EQ(differences(look.corrected.settings, Settings{}), std::vector<std::string>());
  EXPECT_TRUE(look.left.isHealthy());
  ASSERT_EQ(look.pictures.size(), 1u);
  EXPECT_EQ(look.pictures[0].given.width, 240);
  EXPECT_NE(look.pictures[0].given.pixels, look.pictures[0].corrected.pixels);
  ASSERT_TRUE(look.givenPsnr && look.correctedPsnr);
  EXPECT_GT(*look.correctedPsnr, *look.givenPsnr);
  EXPECT_TRUE(source.request.faults == faulty.fault) << "the source is left as it was";
}

TEST_F(CorrectedLookTest, SaysNothingWhereNoSettingMakesItRight) {
  DoctorSource source = openForDoctor({"builtin:gallery", "orbit", {64, 36}, {}});
  Diagnosis diagnosis;
  diagnosis.frames = 4;
  diagnosis.findings.resize(1);
  diagnosis.findings[0].id = "depthLinear";
  const CorrectedLook look = lookAtCorrected(source, diagnosis, {}, {});
  EXPECT_TRUE(look.corrected.findings.empty());
  EXPECT_TRUE(look.pictures.empty());
  EXPECT_FALSE(look.givenPsnr);
}

} // namespace taa::doctor
