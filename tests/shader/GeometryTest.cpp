// Rejection by what history was of: objects, classes, normals and motion (manual 12.2
// to 12.5, 12.7, 13.7).
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

using taa::Image;
using taa::IntermediateId;
using taa::Settings;
using taa::Switch;
using taa::test::difference;
using taa::test::Exposed;
using taa::test::FrameShape;

namespace {

constexpr int kWidth = 16, kHeight = 8;
constexpr float kKept = 0.0f, kOffScreen = 3.0f, kObject = 6.0f, kClass = 7.0f, kNormal = 8.0f,
                kVelocity = 9.0f;

FrameShape shape() {
  return {kWidth, kHeight, taa::Precision::Full, taa::Precision::Full};
}

using Value = std::function<float(int x, int y)>;

void fill(Image& image, int channel, const Value& value) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) image.at(x, y)[channel] = value(x, y);
}

Value all(float value) {
  return [value](int, int) { return value; };
}

/// One surface at rest whose history is of the same: object 1, class 1, facing the camera, N = 4.
taa::twin::Inputs sameAsBefore() {
  taa::twin::Inputs frame = taa::test::flatFrame(shape(), 1.0f);
  fill(frame.normal, 2, all(1.0f));
  fill(frame.normal, 3, all(1.0f));
  frame.historyColor = Image(kWidth, kHeight, 4);
  frame.historySurface = Image(kWidth, kHeight, 2);
  fill(frame.historySurface, 0, all(4.0f));
  fill(frame.historySurface, 1, all(5.0f));
  frame.historyObject = Image(kWidth, kHeight, 2);
  fill(frame.historyObject, 0, all(1.0f));
  fill(frame.historyObject, 1, all(1.0f));
  frame.historyNormal = Image(kWidth, kHeight, 4);
  fill(frame.historyNormal, 2, all(1.0f));
  frame.historyMotion = Image(kWidth, kHeight, 2);
  return frame;
}

Settings depthAlone() {
  Settings settings = taa::test::bareSettings();
  settings.validate.depth = Switch::On;
  return settings;
}

Settings everyTest() {
  Settings settings = depthAlone();
  settings.validate.object = settings.validate.objectClass = settings.validate.normal = Switch::On;
  settings.validate.velocity = taa::VelocityTest::Vector;
  settings.weight.velocityChange = Switch::On;
  return settings;
}

Image picture(const Value& value) {
  Image image(kWidth, kHeight, 1);
  fill(image, 0, value);
  return image;
}

} // namespace

class GeometryTest : public taa::test::ResolveTest {
 protected:
  static Image exposed(const taa::twin::Inputs& frame, const Settings& settings, IntermediateId id) {
    return expose(frame, shape(), settings).at(id);
  }
  static Image reasons(const taa::twin::Inputs& frame, const Settings& settings) {
    return exposed(frame, settings, IntermediateId::rejectReason);
  }
};

TEST_F(GeometryTest, KeepsWhatIsOfTheSame) {
  EXPECT_EQ(difference(reasons(sameAsBefore(), everyTest()), picture(all(kKept))), "");
}

// Techniques: 12.3.
TEST_F(GeometryTest, AnotherObjectAtTheSameDepthIsRejectedByItsNumber) {
  taa::twin::Inputs frame = sameAsBefore();
  fill(frame.objectId, 0, [](int x, int) { return x < 8 ? 1.0f : 2.0f; });
  EXPECT_EQ(difference(reasons(frame, depthAlone()), picture(all(kKept))), "") << "depth sees nothing";
  Settings settings = depthAlone();
  settings.validate.object = Switch::On;
  const Exposed seen = expose(frame, shape(), settings);
  EXPECT_EQ(difference(seen.at(IntermediateId::rejectReason),
                       picture([](int x, int) { return x < 8 ? kKept : kObject; })),
            "");
  EXPECT_EQ(difference(seen.at(IntermediateId::historyObjectId), picture(all(1.0f))), "");
  EXPECT_EQ(
      difference(seen.at(IntermediateId::alpha), picture([](int x, int) { return x < 8 ? 0.1f : 1.0f; })),
      "");
  EXPECT_EQ(*seen.at(IntermediateId::historyLength).at(9, 3), 1.0f);
}

TEST_F(GeometryTest, OneOfTheNineTexelsAroundIsEnough) {
  taa::twin::Inputs frame = sameAsBefore();
  fill(frame.objectId, 0, all(2.0f));
  frame.historyObject.at(5, 4)[0] = 2.0f;
  Settings settings = depthAlone();
  settings.validate.object = Switch::On;
  // As wide as the jitter, and to the left and above as to the right and below.
  const Image expected = picture([](int x, int y) {
    const bool isNear = std::abs(x - 5) <= 1 && std::abs(y - 4) <= 1;
    return isNear ? kKept : kObject;
  });
  EXPECT_EQ(difference(reasons(frame, settings), expected), "");
}

TEST_F(GeometryTest, TheDilatedSampleSaysWhoseAPixelIs) {
  taa::twin::Inputs frame = sameAsBefore();
  *frame.depth.at(8, 4) *= 1.001f; // a little nearer, so that the ring around it follows it
  *frame.objectId.at(8, 4) = 9.0f;
  fill(frame.historyObject, 0, all(9.0f));
  Settings settings = depthAlone();
  settings.validate.object = Switch::On;
  settings.dilate.method = taa::DilateMethod::Closest3x3;
  const Value isNear = [](int x, int y) {
    return std::abs(x - 8) <= 1 && std::abs(y - 4) <= 1 ? 1.0f : 0.0f;
  };
  EXPECT_EQ(difference(reasons(frame, settings),
                       picture([&](int x, int y) { return isNear(x, y) == 1.0f ? kKept : kObject; })),
            "");
  // And history keeps it so.
  const Image left = resolve(frame, shape(), settings).object.download();
  Image expected(kWidth, kHeight, 2);
  fill(expected, 0, [&](int x, int y) { return isNear(x, y) == 1.0f ? 9.0f : 1.0f; });
  fill(expected, 1, all(1.0f));
  EXPECT_EQ(difference(left, expected), "");
}

// Techniques: 12.2.
TEST_F(GeometryTest, AnotherClassIsRejectedWhateverItsNumber) {
  taa::twin::Inputs frame = sameAsBefore();
  fill(frame.objectId, 0, all(7.0f)); // another object of the same class is no matter
  fill(frame.normal, 3, [](int x, int) { return x < 4 ? 1.0f : 2.0f; });
  Settings settings = depthAlone();
  settings.validate.objectClass = Switch::On;
  EXPECT_EQ(difference(reasons(frame, settings), picture([](int x, int) { return x < 4 ? kKept : kClass; })),
            "");
}

TEST_F(GeometryTest, TheSkyMatchesTheSky) {
  taa::twin::Inputs frame = sameAsBefore();
  for (Image* image : {&frame.depth, &frame.normal, &frame.objectId, &frame.previousDepth,
                       &frame.historyObject, &frame.historyNormal})
    std::ranges::fill(image->pixels, 0.0f);
  fill(frame.historySurface, 1, all(0.0f));
  EXPECT_EQ(difference(reasons(frame, everyTest()), picture(all(kKept))), "");
  Settings settings = depthAlone();
  settings.validate.normal = Switch::On;
  fill(frame.historyNormal, 2, all(1.0f));
  EXPECT_EQ(difference(reasons(frame, settings), picture(all(kNormal))), "") << "and nothing else";
}

// Two walls meet; between the frames the edge went from column 10 to column 6.
TEST_F(GeometryTest, WhatFacedAnotherWayIsRejected) {
  taa::twin::Inputs frame = sameAsBefore();
  const auto walls = [](Image& normal, int edge) {
    fill(normal, 0, [edge](int x, int) { return x < edge ? 1.0f : 0.0f; });
    fill(normal, 2, [edge](int x, int) { return x < edge ? 0.0f : 1.0f; });
  };
  walls(frame.normal, 6);
  walls(frame.historyNormal, 10);
  Settings settings = depthAlone();
  settings.validate.normal = Switch::On;
  // Column 9 is kept: the next one of the four around it faced the same way.
  EXPECT_EQ(difference(reasons(frame, settings),
                       picture([](int x, int) { return x >= 6 && x < 9 ? kNormal : kKept; })),
            "");
}

// Techniques: 12.4.
TEST_F(GeometryTest, NormalsMayDifferByTheAngleOfTheLimit) {
  for (const float degrees : {25.0f, 26.0f}) { // cos 25.84° = 0.9
    taa::twin::Inputs frame = sameAsBefore();
    const float angle = degrees * 3.14159265f / 180.0f;
    fill(frame.normal, 0, all(std::sin(angle)));
    fill(frame.normal, 2, all(std::cos(angle)));
    Settings settings = depthAlone();
    settings.validate.normal = Switch::On;
    EXPECT_EQ(difference(reasons(frame, settings), picture(all(degrees < 25.5f ? kKept : kNormal))), "");
    EXPECT_NEAR(*exposed(frame, settings, IntermediateId::normalAgreement).at(3, 3), std::cos(angle), 1e-3f);
  }
}

// Godot's numbers: beyond 2.5 px a hundredth for each.
// Techniques: 12.5.
TEST_F(GeometryTest, AChangeOfVelocityRejectsMoreTheLargerItIs) {
  Settings settings = depthAlone();
  settings.weight.alpha = 0.0f;
  settings.validate.velocity = taa::VelocityTest::Vector;
  for (const float change : {0.0f, 2.5f, 3.0f, 52.5f, 102.5f, 300.0f}) {
    taa::twin::Inputs frame = sameAsBefore();
    fill(frame.historyMotion, 1, all(change));
    const Exposed seen = expose(frame, shape(), settings);
    EXPECT_EQ(*seen.at(IntermediateId::velocityChange).at(2, 2), change);
    EXPECT_EQ(*seen.at(IntermediateId::rejectReason).at(2, 2), change > 2.5f ? kVelocity : kKept);
    const float share = std::min(std::max((change - 2.5f) * 0.01f, 0.0f), 1.0f);
    EXPECT_EQ(*seen.at(IntermediateId::alpha).at(2, 2), share);
    EXPECT_EQ(*seen.at(IntermediateId::alphaInvalid).at(2, 2), share);
  }
}

// Techniques: 12.5.
TEST_F(GeometryTest, OnlyLengthsCountWhereSoChosen) {
  taa::twin::Inputs frame = sameAsBefore();
  fill(frame.motion, 0, all(3.0f));
  fill(frame.motion, 1, all(-4.0f));
  fill(frame.historyMotion, 0, all(-5.0f));
  Settings settings = depthAlone();
  settings.validate.velocity = taa::VelocityTest::Length;
  EXPECT_EQ(*exposed(frame, settings, IntermediateId::velocityChange).at(8, 4), 0.0f);
  settings.validate.velocity = taa::VelocityTest::Vector;
  EXPECT_EQ(*exposed(frame, settings, IntermediateId::velocityChange).at(8, 4), std::sqrt(80.0f));
}

TEST_F(GeometryTest, WhatHasNoPreviousPositionHasNotChanged) {
  taa::twin::Inputs frame = sameAsBefore();
  for (const int channel : {0, 1}) fill(frame.historyMotion, channel, all(taa::kNoPreviousPosition));
  EXPECT_EQ(difference(reasons(frame, everyTest()), picture(all(kKept))), "");
}

// Techniques: 12.5.
TEST_F(GeometryTest, SoftRejectionKeepsTheHistory) {
  taa::twin::Inputs frame = sameAsBefore();
  fill(frame.objectId, 0, all(2.0f));
  fill(frame.motion, 0, [](int x, int) { return x < 2 ? 9.0f : 0.0f; }); // from beyond the left edge
  Settings settings = depthAlone();
  settings.validate.offScreen = taa::OffScreen::Reject;
  settings.validate.object = Switch::On;
  settings.validate.action = taa::RejectAction::RaiseAlpha;
  settings.validate.softAlpha = 0.5f;
  const Exposed seen = expose(frame, shape(), settings);
  EXPECT_EQ(difference(seen.at(IntermediateId::rejectReason),
                       picture([](int x, int) { return x < 2 ? kOffScreen : kObject; })),
            "");
  EXPECT_EQ(
      difference(seen.at(IntermediateId::alpha), picture([](int x, int) { return x < 2 ? 1.0f : 0.5f; })),
      "");
  // 1/(α² + (1 − α)²/N) with N = 4.
  EXPECT_EQ(difference(seen.at(IntermediateId::historyLength),
                       picture([](int x, int) { return x < 2 ? 1.0f : 1.0f / 0.3125f; })),
            "");
}

// Techniques: 13.7.
TEST_F(GeometryTest, AChangeOfVelocityIsJoinedToAlpha) {
  taa::twin::Inputs frame = sameAsBefore();
  fill(frame.historyMotion, 0, all(2.0f));
  Settings settings = depthAlone();
  settings.weight.alpha = 0.5f;
  settings.weight.velocityChange = Switch::On;
  settings.weight.velocityChangeSpeed = 8.0f;
  const Exposed seen = expose(frame, shape(), settings);
  EXPECT_EQ(*seen.at(IntermediateId::alphaVelocityChange).at(3, 3), 0.25f);
  EXPECT_EQ(*seen.at(IntermediateId::alpha).at(3, 3), 1.0f - 0.5f * 0.75f);
  EXPECT_EQ(*seen.at(IntermediateId::rejectReason).at(3, 3), kKept);
}

// The left half goes left, the right half right; then all go alike.
// Techniques: 12.7.
TEST_F(GeometryTest, MotionThatPartsRaisesAlpha) {
  Settings settings = depthAlone();
  settings.validate.depth = Switch::Off;
  settings.weight.alpha = 0.5f;
  settings.weight.divergence = Switch::On;
  settings.weight.divergenceSpeed = 8.0f;
  taa::twin::Inputs frame = sameAsBefore();
  fill(frame.motion, 0, [](int x, int) { return x < 8 ? -4.0f : 4.0f; });
  const Exposed seen = expose(frame, shape(), settings);
  // At the border the cosine is −1, so the difference to 1 is bounded to 1; the speed is half of the full
  // one.
  const auto isBorder = [](int x) { return x == 7 || x == 8; };
  EXPECT_EQ(difference(seen.at(IntermediateId::alphaDivergence),
                       picture([&](int x, int) { return isBorder(x) ? 0.5f : 0.0f; })),
            "");
  EXPECT_EQ(difference(seen.at(IntermediateId::alpha),
                       picture([&](int x, int) { return isBorder(x) ? 0.75f : 0.5f; })),
            "");
  fill(frame.motion, 0, all(4.0f));
  EXPECT_EQ(difference(exposed(frame, settings, IntermediateId::alphaDivergence), picture(all(0.0f))), "");
  fill(frame.motion, 0, [](int x, int) { return x < 8 ? 0.0f : 4.0f; }); // what hardly moves does not part
  EXPECT_EQ(difference(exposed(frame, settings, IntermediateId::alphaDivergence),
                       picture([](int x, int) { return x == 8 ? 0.5f : 0.0f; })),
            "");
}

TEST_F(GeometryTest, WhatHistoryDoesNotKeepAgrees) {
  taa::twin::Inputs frame = sameAsBefore();
  fill(frame.objectId, 0, all(5.0f));
  fill(frame.normal, 2, all(-1.0f));
  fill(frame.motion, 0, all(0.5f));
  fill(frame.historyMotion, 0, all(90.0f));
  EXPECT_FALSE(taa::test::agree(reasons(frame, everyTest()), picture(all(kKept))));
  frame.historyObject = frame.historyNormal = frame.historyMotion = {};
  EXPECT_EQ(difference(reasons(frame, everyTest()), picture(all(kKept))), "");
  EXPECT_EQ(difference(exposed(frame, everyTest(), IntermediateId::alphaVelocityChange), picture(all(0.0f))),
            "");
}

namespace {

Image ofPixels(const taa::twin::Inputs& frame, const Settings& settings, int channels,
               const std::function<glm::vec4(const taa::twin::KeptLayers&)>& value) {
  Image image(frame.width(), frame.height(), channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      taa::twin::KeptLayers kept;
      taa::twin::resolvePixel(frame, settings, x, y, &kept);
      const glm::vec4 texel = value(kept);
      for (int channel = 0; channel < channels; ++channel) image.at(x, y)[channel] = texel[channel];
    }
  return image;
}

Image wholeSteps(Image lumas) {
  for (float& value : lumas.pixels) value = std::floor(value * 255.0f + 0.5f);
  return lumas;
}

} // namespace

TEST_F(GeometryTest, HistoryKeepsWhatTheTwinSays) {
  const FrameShape random;
  for (const bool isWild : {false, true}) {
    const taa::twin::Inputs frame = taa::test::randomFrame(random, isWild ? 71 : 70, isWild);
    Settings settings = everyTest();
    settings.dilate.method = taa::DilateMethod::Closest3x3;
    settings.rectify.locks = settings.rectify.instability = Switch::On;
    settings.history.precision = random.history;
    taa::twin::Inputs next = frame;
    taa::test::downloadHistory(resolve(frame, random, settings), next);
    using taa::twin::KeptLayers;
    EXPECT_EQ(difference(next.historyObject,
                         ofPixels(frame, settings, 2,
                                  [](const KeptLayers& kept) { return glm::vec4(kept.object, 0.0f, 0.0f); })),
              "");
    EXPECT_EQ(difference(next.historyNormal,
                         ofPixels(frame, settings, 4, [](const KeptLayers& kept) { return kept.normal; })),
              "");
    EXPECT_EQ(difference(next.historyMotion,
                         ofPixels(frame, settings, 2,
                                  [](const KeptLayers& kept) { return glm::vec4(kept.motion, 0.0f, 0.0f); })),
              "");
    taa::test::Limits limits = taa::test::limitsOf(isExact(), 1e-3f); // as the twin's test
    limits.mayLoseFinite = !isExact() && isWild;
    limits.outliers /= 4.0; // one pixel in a hundred by one of its channels
    EXPECT_EQ(difference(next.historyLock,
                         ofPixels(frame, settings, 2,
                                  [](const KeptLayers& kept) { return glm::vec4(kept.lock, 0.0f, 0.0f); }),
                         limits),
              "");
    EXPECT_EQ(difference(
                  wholeSteps(next.historyLumas),
                  wholeSteps(ofPixels(frame, settings, 4, [](const KeptLayers& kept) { return kept.lumas; })),
                  limits),
              "");
  }
}

TEST_F(GeometryTest, HistoryKeepsNothingThatIsNotAskedFor) {
  const std::size_t bare = kWidth * kHeight * (8 + 8);
  Settings none;
  none.validate.flicker = Switch::Off;
  none.validate.depthFootprint = taa::DepthFootprint::Square3x3;
  taa::History history;
  taa::fitHistory(history, kWidth, kHeight, none);
  EXPECT_EQ(history.bytes(), bare);
  EXPECT_EQ(taa::historyTargets(none), taa::kHistoryTargets);
  struct Case {
    std::string_view what;
    std::size_t bytes;
    void (*turnOn)(Settings&);
  };
  for (const Case& asked :
       {Case{"object", 8, [](Settings& s) { s.validate.object = Switch::On; }},
        Case{"class", 8, [](Settings& s) { s.validate.objectClass = Switch::On; }},
        Case{"normal", 8, [](Settings& s) { s.validate.normal = Switch::On; }},
        Case{"velocity", 8, [](Settings& s) { s.validate.velocity = taa::VelocityTest::Length; }},
        Case{"velocity change", 8, [](Settings& s) { s.weight.velocityChange = Switch::On; }},
        Case{"flicker", 8, [](Settings& s) { s.validate.flicker = Switch::On; }},
        Case{"what rests", 8,
             [](Settings& s) { s.validate.depthFootprint = taa::DepthFootprint::ReadInMotion; }},
        Case{"locks", 8, [](Settings& s) { s.rectify.locks = Switch::On; }},
        Case{"instability", 4, [](Settings& s) { s.rectify.instability = Switch::On; }},
        Case{"divergence", 0, [](Settings& s) { s.weight.divergence = Switch::On; }}}) {
    Settings settings = none;
    asked.turnOn(settings);
    taa::fitHistory(history, kWidth, kHeight, settings);
    EXPECT_EQ(history.bytes(), bare + kWidth * kHeight * asked.bytes) << asked.what;
    EXPECT_EQ(taa::historyTargets(settings), taa::kHistoryTargets + (asked.bytes > 0 ? 1u : 0u));
    const unsigned color = history.color.id();
    taa::fitHistory(history, kWidth, kHeight, none);
    EXPECT_EQ(history.bytes(), bare) << "freed, " << asked.what;
    EXPECT_EQ(history.color.id(), color) << "the rest is used again";
  }
}
