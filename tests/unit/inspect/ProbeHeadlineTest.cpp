// What is said of a pixel in a few lines: of values made by hand, so that each sentence is there for its
// reason.
#include "core/explanation/ProbeHeadline.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Known.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

using namespace taa;
using Id = IntermediateId;

namespace {

/// A pixel of a wall that did not move, its history kept.
struct Pixel {
  twin::PixelRecord record{};
  Settings settings;

  Pixel() {
    for (const Id damping :
         {Id::alphaLumaFlicker, Id::alphaNearClamp, Id::alphaHistoryContrast, Id::alphaRelax,
          Id::alphaSampleDistance, Id::alphaFlicker, Id::onScreen, Id::sampleConfidence, Id::blurTrust})
      set(damping, 1.0f);
    set(Id::depthExpected, 8.0f);
    set(Id::historyDepth, 8.0f);
    set(Id::depthAllowed, 0.03f);
    set(Id::historyKeptLength, 7.0f);
    set(Id::alphaBase, 0.125f);
    set(Id::alphaFloor, 0.1f);
    setAlpha(0.125f);
    settings.space = {ColorSpace::Rgb, ToneSpace::Linear};
  }
  void set(Id id, float value) { twin::at(record, id).x = value; }
  void set(Id id, const glm::vec3& value) { twin::at(record, id) = glm::vec4(value, 0.0f); }
  void setMotion(Id id, const glm::vec2& value) { twin::at(record, id) = glm::vec4(value, 0.0f, 0.0f); }
  void setAlpha(float alpha) {
    for (const Id id : {Id::alphaFrameRate, Id::alpha, Id::blendFactor}) set(id, alpha);
  }
  std::vector<std::string> lines() const { return probeHeadline(record, settings, {}); }
  std::string first() const { return lines().at(0); }
  std::string alpha() const { return lines().at(1); }
};

} // namespace

TEST(ProbeHeadline, SaysWhoseMotionItIs) {
  Pixel pixel;
  EXPECT_EQ(pixel.first(), "Did not move, history kept as it was");
  pixel.setMotion(Id::motion, {1.5f, 0.0f});
  pixel.setMotion(Id::dilatedMotion, {1.5f, 0.0f});
  EXPECT_EQ(pixel.first(), "Moved (1.5, 0) px, history kept as it was");
  pixel.setMotion(Id::dilatedOffset, {1.0f, 0.0f});
  pixel.setMotion(Id::dilatedMotion, {1.51f, 0.0f});
  EXPECT_EQ(pixel.first(), "Moved (1.5, 0) px, history kept as it was") << "of a surface that leans";
  pixel.setMotion(Id::motion, {0.0f, 0.0f});
  pixel.setMotion(Id::dilatedMotion, {-3.49f, -1.89f});
  EXPECT_EQ(pixel.first(), "Did not move, but follows the neighbor at (1, 0), which moved (−3.49, −1.89) px, "
                           "history kept as it was");
  pixel.setMotion(Id::motion, {-3.49f, -1.89f});
  pixel.setMotion(Id::dilatedMotion, {0.0f, 0.0f});
  EXPECT_EQ(pixel.first(), "Moved (−3.49, −1.89) px, but follows the neighbor at (1, 0), which did not move, "
                           "history kept as it was");
  pixel.setMotion(Id::dilatedOffset, {0.0f, 0.0f});
  pixel.setMotion(Id::dilatedMotion, {65504.0f, 65504.0f});
  EXPECT_EQ(pixel.first(), "No previous position, history kept as it was");
}

// Drawn at half the size: a motion of 2 render pixels is one of 4 of the picture.
TEST(ProbeHeadline, ComparesMotionsInPixelsOfThePicture) {
  Pixel pixel;
  pixel.settings.inputs.renderScale = 0.5f;
  pixel.setMotion(Id::dilatedOffset, {0.0f, 1.0f});
  pixel.setMotion(Id::motion, {2.0f, 0.0f});
  pixel.setMotion(Id::dilatedMotion, {4.0f, 0.0f});
  EXPECT_EQ(pixel.first(), "Moved (4, 0) px, history kept as it was");
}

TEST(ProbeHeadline, NamesWhyHistoryWasRejected) {
  Pixel pixel;
  pixel.set(Id::rejectReason, 4.0f);
  pixel.set(Id::alphaInvalid, 1.0f);
  EXPECT_EQ(pixel.first(), "Did not move, history rejected: depth");
  EXPECT_EQ(pixel.alpha(), "α = 1: the current frame alone");
  pixel.set(Id::rejectReason, 6.0f);
  pixel.set(Id::alphaInvalid, 0.5f);
  pixel.set(Id::alpha, 0.5f);
  EXPECT_EQ(pixel.first(), "Did not move, history counts less: another object");
  EXPECT_EQ(pixel.alpha(), "N = 7 → α = max(1/(7 + 1), 0.1), at least 0.5 when rejected = 0.5");
  pixel.setAlpha(0.75f); // for another reason
  EXPECT_EQ(pixel.first(), "Did not move, history failed a test (another object), which changes nothing: it "
                           "counted no more before");
  EXPECT_EQ(meaningOf(Id::alphaInvalid, pixel.record, pixel.settings), "changes nothing");
}

// Nothing tests depth, and 90 % of the color is of the bar that passed.
TEST(ProbeHeadline, NamesAGhostThatNothingRejects) {
  Pixel pixel;
  pixel.settings.validate.depth = Switch::Off;
  pixel.set(Id::depthExpected, 8.6f);
  pixel.set(Id::historyDepth, 6.15f);
  pixel.set(Id::depthMismatch, 0.285f);
  pixel.set(Id::historyLength, 18.9f);
  pixel.set(Id::blendFactor, 0.1f);
  for (const Id id : {Id::neighborhoodMin, Id::boxMin}) pixel.set(id, glm::vec3(0.2f));
  for (const Id id : {Id::neighborhoodMax, Id::boxMax}) pixel.set(id, glm::vec3(0.4f));
  pixel.set(Id::historyRectified, glm::vec3(0.3f));
  EXPECT_EQ(historyDoubt(pixel.record, pixel.settings), HistoryDoubt::OtherSurface);
  EXPECT_EQ(pixel.first(),
            "Did not move, history kept as it was, although it is of another surface by its depth "
            "(6.15 m, expected 8.6 m); no depth test runs");
  pixel.set(Id::historyRectified, glm::vec3(0.9f, 0.3f, 0.3f));
  EXPECT_EQ(historyDoubt(pixel.record, pixel.settings), HistoryDoubt::Ghost);
  EXPECT_EQ(
      pixel.first(),
      "Did not move, history kept as it was, although it is a ghost, 90 % of the result: another surface by "
      "its "
      "depth (6.15 m, expected 8.6 m), and in a color that is none of those around; no depth test runs");
  EXPECT_EQ(pixel.lines().at(2), "N = 18.9 counts samples of the other surface, too");
  EXPECT_EQ(meaningOf(Id::depthMismatch, pixel.record, pixel.settings), "another surface, not tested");
  pixel.set(Id::historyDepth, 0.0f);
  EXPECT_NE(pixel.first().find("(the sky, expected 8.6 m)"), std::string::npos) << pixel.first();
  pixel.set(Id::depthMismatch, 0.01f);
  EXPECT_EQ(pixel.first(),
            "Did not move, history kept as it was, although its color is none of those around");
  pixel.set(Id::clipAmount, 0.5f);
  EXPECT_EQ(pixel.first(), "Did not move, history kept, pulled 50 % of the way to the current color");
  pixel.set(Id::onScreen, 0.0f);
  EXPECT_EQ(pixel.first(),
            "Did not move, history kept, pulled 50 % of the way to the current color, although it lies "
            "off the screen, where the border is read instead");
}

TEST(ProbeHeadline, TellsAThinFeatureAtRestFromAnotherSurface) {
  Pixel pixel;
  pixel.set(Id::depthMismatch, 0.2f);
  pixel.set(Id::geometricFlicker, 1.0f);
  pixel.set(Id::alphaFlicker, 0.5f);
  pixel.set(Id::alpha, 0.0625f);
  EXPECT_EQ(historyDoubt(pixel.record, pixel.settings), HistoryDoubt::None);
  EXPECT_EQ(pixel.first(),
            "Did not move, history kept as it was; its depth differs as of a thin feature at rest, which "
            "single frames miss");
  EXPECT_EQ(pixel.alpha(), "N = 7 → α = max(1/(7 + 1), 0.1) × 0.5 = 0.0625");
  EXPECT_EQ(meaningOf(Id::depthMismatch, pixel.record, pixel.settings), "a thin feature at rest");
}

TEST(ProbeHeadline, SaysWhatIsAllowedForASlopeWhereItIsMuch) {
  Pixel pixel;
  pixel.set(Id::depthMismatch, 10.6f);
  pixel.set(Id::depthAllowed, 53.12f);
  EXPECT_EQ(pixel.first(),
            "Did not move, history kept as it was; its depth is off by 1060 %, and 5312 % are allowed "
            "where the surface recedes so");
  pixel.set(Id::depthMismatch, 0.05f);
  EXPECT_EQ(pixel.first(), "Did not move, history kept as it was");
}

TEST(ProbeHeadline, KnowsWhereThereIsNothingYet) {
  Pixel pixel;
  pixel.set(Id::rejectReason, 1.0f);
  pixel.set(Id::alphaInvalid, 1.0f);
  EXPECT_EQ(pixel.first(), "Did not move, there is no history yet");
  for (const Intermediate& row : kResolveRows)
    if (isOfHistory(row.id)) {
      EXPECT_FALSE(twin::isKnown(pixel.record, row.id)) << row.name;
      EXPECT_EQ(meaningOf(row.id, pixel.record, pixel.settings), "no history yet") << row.name;
    }
  EXPECT_TRUE(twin::isKnown(pixel.record, Id::resolved));
  EXPECT_TRUE(twin::isKnown(pixel.record, Id::rejectReason));
}

TEST(ProbeHeadline, GivesValuesAMeaning) {
  Pixel pixel;
  const auto meaning = [&](Id id, float value) {
    pixel.set(id, value);
    return meaningOf(id, pixel.record, pixel.settings);
  };
  EXPECT_EQ(meaning(Id::rejectReason, 0), rejectReasonText(0));
  EXPECT_EQ(meaning(Id::rejectReason, 3), rejectReasonText(3));
  EXPECT_EQ(meaning(Id::depth, 0), "sky");
  EXPECT_EQ(meaning(Id::motion, 65504), "no previous");
  EXPECT_EQ(meaning(Id::objectClass, 3), "deforms");
  EXPECT_EQ(meaning(Id::depthMismatch, 0.02f), "same surface");
  EXPECT_EQ(meaning(Id::depthMismatch, 0.04f), "another surface");
}

// The sentence is that of the source chosen, with every term that took part.
TEST(ProbeHeadline, TellsHowAlphaCameAbout) {
  Pixel pixel;
  EXPECT_EQ(pixel.alpha(), "N = 7 → α = max(1/(7 + 1), 0.1) = 0.125");
  pixel.settings.weight.source = AlphaSource::LumaDifference;
  pixel.set(Id::historyKeptLength, 1.3f);
  for (const Id id : {Id::alphaBase, Id::alphaFloor, Id::alpha}) pixel.set(id, 0.0625f);
  EXPECT_EQ(pixel.alpha(), "α = luma difference 0.0625");
  pixel.settings.weight.source = AlphaSource::Constant;
  EXPECT_EQ(pixel.alpha(), "α = constant 0.0625");
  pixel.set(Id::alphaBase, 1.0f);
  pixel.set(Id::alphaLumaFlicker, 0.5f);
  pixel.set(Id::alpha, 0.5f);
  EXPECT_EQ(pixel.alpha(), "α = constant 1 × 0.5 = 0.5") << "a product that ends like its value";
  pixel.set(Id::alphaBase, 0.0625f);
  pixel.set(Id::alphaFloor, 0.04f);
  pixel.set(Id::alpha, 0.04f);
  EXPECT_EQ(pixel.alpha(), "α = max(constant 0.0625 × 0.5, 0.04) = 0.04");
  pixel.set(Id::alphaFloor, 0.0f);
  pixel.set(Id::alphaMotion, 0.25f);
  pixel.set(Id::alpha, 0.2734375f);
  EXPECT_EQ(pixel.alpha(), "α = constant 0.0625 × 0.5 and 0.25 by motion = 0.2734");
  pixel.set(Id::alphaMask, 0.5f);
  pixel.set(Id::alpha, 0.5f);
  EXPECT_EQ(pixel.alpha(), "α = max(constant 0.0625 × 0.5 and 0.25 by motion, 0.5 by mask) = 0.5");
}

TEST(ProbeHeadline, TellsOfTheFramesTimeWhereItChangesAlpha) {
  Pixel pixel;
  pixel.settings.weight.source = AlphaSource::Constant;
  pixel.settings.weight.frameRate = Switch::On;
  EXPECT_EQ(pixel.alpha(), "α = constant 0.125") << "frames take what they are meant to take";
  FrameInfo info;
  info.stepSeconds = 1.0 / 30.0;
  pixel.set(Id::alpha, 0.234375f);
  EXPECT_EQ(probeHeadline(pixel.record, pixel.settings, info).at(1),
            "α = constant 0.125 by the frame's time = 0.2344");
}

TEST(ProbeHeadline, TellsOfWhatElseAlphaDependsOn) {
  Pixel pixel;
  pixel.settings.weight.source = AlphaSource::Constant;
  pixel.settings.inputs.renderScale = 0.5f;
  pixel.set(Id::sampleConfidence, 0.5f);
  pixel.set(Id::alpha, 0.0625f);
  EXPECT_EQ(pixel.alpha(), "α = κ 0.5 × (constant 0.125) = 0.0625");
  pixel.settings.inputs.renderScale = 1.0f;
  pixel.set(Id::alphaDivergence, 0.25f);
  pixel.set(Id::alpha, 0.34375f);
  EXPECT_EQ(pixel.alpha(), "α = constant 0.125 and 0.25 by divergence = 0.3438");
  pixel.settings.weight.source = AlphaSource::ContrastPerChannel;
  pixel.set(Id::alphaChannels, glm::vec3(0.5f, 0.25f, 0.125f));
  EXPECT_TRUE(pixel.alpha().ends_with("= 0.3438, of channels (0.5, 0.25, 0.125)")) << pixel.alpha();
}

TEST(ProbeHeadline, SaysWhatIsShownInsteadOfTheResolvedColor) {
  Pixel pixel;
  EXPECT_EQ(pixel.lines().size(), 3u);
  pixel.settings.output.sharpen = Sharpen::Laplacian;
  pixel.settings.output.motionBlur = Switch::On;
  EXPECT_EQ(pixel.lines().size(), 3u) << "neither changes anything here";
  pixel.set(Id::sharpenDetail, -0.25f);
  EXPECT_EQ(pixel.lines().back(), "Shown sharpened: 0.25 darker");
  pixel.set(Id::blurTrust, 0.6f);
  EXPECT_EQ(pixel.lines().back(), "Shown sharpened: 0.25 darker, 40 % motion blur");
  pixel.settings.output = {};
  pixel.set(Id::overlayAlpha, 0.5f);
  EXPECT_EQ(pixel.lines().back(), "Shown 50 % hidden by the overlay");
}

TEST(ProbeHeadline, SaysThatFaultsAreInjected) {
  Pixel pixel;
  const std::size_t healthy = pixel.lines().size();
  pixel.settings.fault.motionY = -1.0f;
  ASSERT_EQ(pixel.lines().size(), healthy + 1);
  EXPECT_EQ(pixel.lines().back(), "Faults are injected: fault.motionY=-1");
}
