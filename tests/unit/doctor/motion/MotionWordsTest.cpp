// Motion as an engine writes it, and what findings are called.
#include "core/doctor/motion/MotionWords.h"

#include "core/settings/Faults.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace taa::doctor {

TEST(MotionWords, WriteMotionAsTheEngineDoes) {
  CaptureInfo captureInfo;
  captureInfo.sizePx = {160, 96};
  captureInfo.outputPx = {320, 192};
  EXPECT_EQ(storedMotion(captureInfo, {3.0, -1.5}), glm::dvec2(3.0, -1.5));
  captureInfo.conventions.emplace();
  captureInfo.conventions->motion.unit = capture::ScreenUnit::Uv;
  captureInfo.conventions->motion.yAxis = capture::VerticalAxis::Up;
  EXPECT_EQ(storedMotion(captureInfo, {3.0, -1.5}), glm::dvec2(3.0 / 160.0, 1.5 / 96.0));
  captureInfo.conventions->motion = {};
  captureInfo.conventions->motion.direction = capture::MotionDirection::PreviousMinusCurrent;
  captureInfo.conventions->motion.pixelOf = capture::PixelOf::Output;
  EXPECT_EQ(storedMotion(captureInfo, {3.0, -1.5}), glm::dvec2(-6.0, 3.0));
  captureInfo.conventions->motion = {};
  captureInfo.conventions->motion.encoding = capture::MotionEncoding::Offset;
  captureInfo.conventions->motion.scale = {2.0, 2.0};
  captureInfo.conventions->motion.offset = {0.5, 0.5};
  EXPECT_EQ(storedMotion(captureInfo, {3.0, -1.5}), glm::dvec2(2.0, -0.25));
}

// Of each explanation but that all is right; ids of the table of faults are the table's.
TEST(MotionWords, NameEachExplanation) {
  std::set<std::string> ids;
  RegionEvidence evidence;
  evidence.pixels = 100;
  for (const MotionTrial& trial : motionTrials({160, 96})) {
    if (trial.kind == MotionKind::AsGiven) continue;
    const FaultWords fault = motionFault(&trial, Region(), evidence);
    EXPECT_FALSE(fault.name.empty() || fault.symptom.empty() || fault.change.empty()) << trialId(trial);
    ids.insert(fault.id);
  }
  for (const Fault fault :
       {Fault::MotionNegatedX, Fault::MotionNegatedY, Fault::MotionNegated, Fault::MotionSwapped,
        Fault::MotionDoubled, Fault::MotionHalved, Fault::MotionInUv, Fault::MotionInNdc,
        Fault::MotionJitterThis, Fault::MotionJitterLast, Fault::MotionJitterBoth, Fault::MotionWithoutCamera,
        Fault::MotionLingers})
    EXPECT_TRUE(ids.contains(std::string(faultInfo(fault).id))) << faultInfo(fault).id;
}

TEST(MotionWords, CallWhatIsZeroUnwritten) {
  RegionEvidence evidence;
  evidence.pixels = evidence.zero = 100;
  Region sky;
  sky.isSky = true;
  EXPECT_EQ(motionFault(nullptr, sky, evidence).id, "skyWithoutMotion");
  EXPECT_EQ(motionFault(nullptr, Region(), evidence).id, "motionZero");
  const MotionTrial ofCamera{MotionKind::OfCamera};
  EXPECT_EQ(motionFault(&ofCamera, Region(), evidence).id, "motionZero");
  evidence.zero = 0;
  evidence.ofCamera = 100;
  EXPECT_EQ(motionFault(nullptr, Region(), evidence).id, "motionCameraOnly");
  // What moves otherwise than given, and is not given as the camera's, has no name.
  evidence.ofCamera = 30;
  EXPECT_EQ(motionFault(nullptr, Region(), evidence).id, kUnknownMotionId);
}

TEST(MotionWords, NameTheFramesInWhichWhatMovesHasNoMotion) {
  RegionEvidence evidence;
  evidence.pixels = 600;
  evidence.zero = 300;
  for (int frame = 1; frame <= 6; ++frame)
    evidence.traces.push_back({frame, 100, frame % 2 == 0 ? 0.0 : 400.0, 0, 0.0, 0.0});
  const FaultWords words = motionFault(nullptr, Region(), evidence);
  EXPECT_EQ(words.id, "motionAtTimesZero");
  EXPECT_NE(words.change.find("frames 2, 4, 6 (3 of 6)"), std::string::npos) << words.change;
}

// A pane that writes its own motion before a wall was called a wrong matrix of the camera, surely.
TEST(MotionWords, BlameNoCameraThatIsRightElsewhere) {
  RegionEvidence evidence;
  for (int i = 0; i < 10; ++i) {
    evidence.offCamera.add({1.5, 0.0});
    evidence.offCameraByDistance.add({i % 2 == 0 ? 9.0 : -9.0, 0.0});
  }
  const MotionTrial ofCamera{MotionKind::OfCamera};
  EXPECT_EQ(motionFault(&ofCamera, {}, evidence).id, faultInfo(Fault::CameraTurned).id);
  EXPECT_EQ(motionFault(&ofCamera, {}, evidence, {}, true).id, "motionNotCameras");
}

TEST(MotionWords, TellDirectionAndAxesBesideAUnit) {
  const auto kindOf = [](const MotionTrial& trial, const CaptureInfo& captureInfo) {
    const auto axes = axesBesideUnit(trial, captureInfo);
    return axes ? axes->kind : MotionKind::AsGiven;
  };
  CaptureInfo own, engine;
  engine.conventions.emplace();
  const MotionTrial uv{MotionKind::OtherUnit, {-160.0f, 96.0f}};
  EXPECT_EQ(kindOf(uv, own), MotionKind::MirroredX);
  EXPECT_EQ(unitAlone(uv, {MotionKind::MirroredX}).factor, glm::vec2(160.0f, 96.0f));
  EXPECT_EQ(kindOf({MotionKind::OtherUnit, {-160.0f, -96.0f}}, engine), MotionKind::Opposite);
  // Device coordinates point up by themselves; an engine states its axes.
  const MotionTrial device{MotionKind::OtherUnit, {80.0f, -48.0f}, true};
  EXPECT_EQ(kindOf(device, own), MotionKind::AsGiven);
  EXPECT_EQ(kindOf(device, engine), MotionKind::MirroredY);
  EXPECT_EQ(kindOf({MotionKind::Opposite}, engine), MotionKind::AsGiven) << "no unit";
}

} // namespace taa::doctor
