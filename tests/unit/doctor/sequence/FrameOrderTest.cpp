// Frames that do not follow each other as they are numbered are named by number, and the rest is examined
// without them: on painted frames put in another order.
#include "core/doctor/sequence/FrameOrder.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace taa::doctor {
namespace {

using test::idsOf;

constexpr int kFrames = 14;

/// Frame n of the shot is what frame `placeOf(n)` of a healthy engine is.
Diagnosis diagnosisInOrder(const std::function<int(int)>& placeOf, const test::PaintedShot& shot = {}) {
  Examination examination = test::paintedExamination(shot, kFrames);
  examination.read = [read = examination.read, placeOf](int frame) {
    DoctorFrame out = read(placeOf(frame));
    out.frame = frame;
    out.startsHistory = frame == 0;
    return out;
  };
  return examine(examination);
}

} // namespace

TEST(FrameOrder, OfHealthyFramesIsRight) {
  EXPECT_EQ(idsOf(diagnosisInOrder([](int frame) { return frame; })), "");
}

TEST(FrameOrder, NamesFramesInEachOthersPlaceAndNothingElse) {
  const Diagnosis diagnosis = diagnosisInOrder([](int frame) {
    return frame == 6 ? 7 : frame == 7 ? 6 : frame;
  });
  ASSERT_EQ(idsOf(diagnosis), "framesSwapped");
  EXPECT_NE(diagnosis.findings[0].reason.find("frame 6 continues frame 7"), std::string::npos)
      << diagnosis.findings[0].reason;
}

TEST(FrameOrder, NamesAFrameThatIsThereTwice) {
  const Diagnosis diagnosis = diagnosisInOrder([](int frame) { return frame < 8 ? frame : frame - 1; });
  ASSERT_EQ(idsOf(diagnosis), "frameDoubled");
  EXPECT_NE(diagnosis.findings[0].reason.find("In frame 8 "), std::string::npos)
      << diagnosis.findings[0].reason;
}

// A ring of three pictures that nobody has waited for: motion is right, and color alone is an old one.
TEST(FrameOrder, NamesAnOldFrameThatIsShownAgain) {
  Examination examination = test::paintedExamination({}, kFrames);
  examination.read = [read = examination.read](int frame) {
    DoctorFrame out = read(frame);
    if (frame == 7) out.luma = read(4).luma;
    return out;
  };
  const Diagnosis diagnosis = examine(examination);
  ASSERT_EQ(idsOf(diagnosis), "frameOlder");
  EXPECT_NE(diagnosis.findings[0].reason.find("Frame 7 has in each pixel the color of frame 4"),
            std::string::npos)
      << diagnosis.findings[0].reason;
}

// What comes back to where it was, under a jitter that does, too, shows what it has shown.
TEST(FrameOrder, OfWhatRepeatsIsNotOld) {
  Examination examination = test::paintedExamination({}, kFrames);
  examination.read = [read = examination.read](int frame) {
    constexpr int kTurn = 4; // there and back again
    const int place = frame <= kTurn ? frame : std::max(0, 2 * kTurn - frame);
    DoctorFrame out = read(place);
    if (frame > kTurn && place < kTurn) { // it goes the way of the frame after, the other way
      out.motionPx = read(place + 1).motionPx;
      for (float& motion : out.motionPx.pixels) motion = -motion;
    }
    out.frame = frame;
    out.startsHistory = frame == 0;
    return out;
  };
  EXPECT_EQ(idsOf(examine(examination)).find("frameOlder"), std::string::npos);
}

// A picture that rests is the same in each frame, and nothing is wrong with that.
TEST(FrameOrder, OfWhatRestsIsNotDoubled) {
  test::PaintedShot shot;
  shot.cameraPx = shot.boardPx = glm::dvec2(0.0);
  shot.isJittered = false;
  EXPECT_EQ(idsOf(diagnosisInOrder([](int frame) { return frame; }, shot)).find("frameDoubled"),
            std::string::npos);
}

TEST(FrameOrder, NamesACutThatNobodyStates) {
  Examination examination = test::paintedExamination({}, kFrames);
  examination.read = [read = examination.read](int frame) {
    DoctorFrame out = read(frame);
    if (frame < 7) return out;
    // Somewhere else: the same ground from the other end.
    std::reverse(out.luma.pixels.begin(), out.luma.pixels.end());
    std::reverse(out.depth.pixels.begin(), out.depth.pixels.end());
    std::reverse(out.depthView.pixels.begin(), out.depthView.pixels.end());
    std::reverse(out.previousDepthView.pixels.begin(), out.previousDepthView.pixels.end());
    std::reverse(out.objectId.begin(), out.objectId.end());
    Image turned = out.motionPx;
    const std::size_t pixels = turned.pixels.size() / 2;
    for (std::size_t i = 0; i < pixels; ++i)
      for (std::size_t channel = 0; channel < 2; ++channel)
        turned.pixels[2 * i + channel] = -out.motionPx.pixels[2 * (pixels - 1 - i) + channel];
    out.motionPx = std::move(turned);
    out.jitterPx = -out.jitterPx;
    out.depthJitterPx = -out.depthJitterPx;
    out.previousClipFromClip.reset();
    return out;
  };
  examination.known.camera = false;
  const Diagnosis diagnosis = examine(examination);
  ASSERT_EQ(idsOf(diagnosis), "cutNotStated");
  EXPECT_NE(diagnosis.findings[0].reason.find("In frame 7 "), std::string::npos)
      << diagnosis.findings[0].reason;
}

// All lights go out but one: nothing is as bright as it was, and all of it is there again.
TEST(FrameOrder, OfAnotherLightIsNoCut) {
  Examination examination = test::paintedExamination({}, kFrames);
  examination.read = [read = examination.read](int frame) {
    DoctorFrame out = read(frame);
    for (int y = 0; y < out.luma.height && frame >= 7; ++y)
      for (int x = 0; x < out.luma.width; ++x)
        *out.luma.at(x, y) *= 0.1f + 0.5f * static_cast<float>(x) / static_cast<float>(out.luma.width);
    return out;
  };
  EXPECT_EQ(idsOf(examine(examination)).find("cutNotStated"), std::string::npos);
}

TEST(FrameOrder, NamesTheSizeOfWhatIsDrawnWhereThatChanges) {
  Examination examination = test::paintedExamination({}, kFrames);
  // From frame 5 to 8 the last fourth of each side keeps what was there.
  examination.read = [read = examination.read](int frame) {
    DoctorFrame out = read(frame);
    const DoctorFrame kept = read(4);
    if (frame < 5 || frame > 8) return out;
    for (int y = 0; y < out.luma.height; ++y)
      for (int x = 0; x < out.luma.width; ++x)
        if (4 * x >= 3 * out.luma.width || 4 * y >= 3 * out.luma.height)
          *out.luma.at(x, y) = *kept.luma.at(x, y);
    return out;
  };
  const Diagnosis diagnosis = examine(examination);
  ASSERT_FALSE(diagnosis.findings.empty());
  EXPECT_EQ(diagnosis.findings[0].id, "drawnPartChanges");
  EXPECT_NE(diagnosis.findings[0].reason.find("120 × 72 px are drawn in frames 5 to 8"), std::string::npos)
      << diagnosis.findings[0].reason;
}

} // namespace taa::doctor
