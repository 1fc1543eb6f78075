// Verdicts where the answer is known: frames of flat colors in which history is poisoned, the light changes,
// an object is teleported or a mask is wrong, each in a place that is known. Every pixel of the maps is
// compared with what follows from that place, and pixels in and beside it are judged.
#include "core/inspect/Inspector.h"
#include "core/settings/Parameters.h"
#include "core/verdict/parts/VerdictMaps.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/capture/MadeCapture.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>

using taa::HistoryVerdict;
using taa::Inspector;
using taa::IntermediateId;
using taa::Stage;
using taa::VerdictKind;
using taa::test::MadeCapture;
using taa::test::MadePixel;

namespace {

constexpr std::uint32_t kWall = 1, kMover = 2;
constexpr int kSamples = 4; // of references, which are given
constexpr glm::vec3 kRed{0.8f, 0.1f, 0.1f};

using PixelSet = std::function<bool(const glm::ivec2&)>;

bool isInRect(const glm::ivec2& pixel, const glm::ivec2& corner, const glm::ivec2& sizePx) {
  const glm::ivec2 at = pixel - corner;
  return at.x >= 0 && at.y >= 0 && at.x < sizePx.x && at.y < sizePx.y;
}

/// An L, so that nothing mirrored or turned is the same.
bool isInMask(const glm::ivec2& pixel) {
  return isInRect(pixel, {6, 3}, {5, 11}) || isInRect(pixel, {11, 9}, {8, 5});
}

bool isNowhere(const glm::ivec2&) {
  return false;
}

/// The pixels whose eight neighbors are all in it as well.
PixelSet innerOf(const PixelSet& set) {
  return [set](const glm::ivec2& pixel) {
    bool isInner = true;
    for (int k = 0; k < 9; ++k) isInner = isInner && set(pixel + glm::ivec2(k % 3 - 1, k / 3 - 1));
    return isInner;
  };
}

/// Nothing but the exponential mean of what is reprojected, and what is changed of that.
taa::Settings plainly(std::initializer_list<const char*> changes = {}) {
  taa::Settings settings;
  for (const char* plain :
       {"rectify.method=none", "validate.depth=off", "history.filter=bilinear", "history.precision=full",
        "inputs.precision=full", "weight.source=constant", "weight.motion=none", "blend.tone=none",
        "weight.alpha=0.1", "dilate.method=none", "neighborhood.box=minMax", "current.filter=center"})
    taa::applyAssignment(settings, plain);
  for (const char* change : changes) taa::applyAssignment(settings, change);
  return settings;
}

class KnownAnswersTest : public taa::test::GlTest {
 protected:
  /// Written once for all tests of a name.
  static std::unique_ptr<Inspector> opened(const std::string& name, const MadeCapture& made,
                                           const taa::Settings& settings) {
    const auto folder = taa::test::temporaryFolder() / name;
    if (!std::filesystem::exists(folder)) writeCapture(folder, made);
    auto inspector = std::make_unique<Inspector>();
    inspector->shot().setSettings(settings);
    inspector->shot().open(folder.string());
    return inspector;
  }

  /// All of a row of verdicts: `isWithin` the pixels that have `verdict`, all others are rightly kept.
  static void expectRow(Inspector& inspector, IntermediateId row, int frame, HistoryVerdict verdict,
                        const PixelSet& isWithin) {
    expectRow(inspector, row, frame, [&](const glm::ivec2& pixel) {
      return isWithin(pixel) ? verdict : HistoryVerdict::RightlyKept;
    });
  }
  static void expectRow(Inspector& inspector, IntermediateId row, int frame,
                        const std::function<HistoryVerdict(const glm::ivec2&)>& expected) {
    inspector.shot().seek(frame);
    inspector.reference().makeRows({row}, kSamples);
    const taa::Image image = inspector.views().image(row);
    ASSERT_EQ(image.width, 32);
    ASSERT_EQ(image.height, 18);
    int others = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const auto found = static_cast<HistoryVerdict>(*image.at(x, y));
        if (found == expected({x, y})) continue;
        if (others++ == 0)
          ADD_FAILURE() << taa::intermediate(row).name << " of frame " << frame << " at " << x << ", " << y
                        << ": " << static_cast<int>(found) << ", not " << static_cast<int>(expected({x, y}));
      }
    EXPECT_EQ(others, 0);
  }

  static taa::VerdictAnswer answerOf(Inspector& inspector, int frame, const glm::ivec2& pixel) {
    return inspector.verdicts().of({.frame = frame, .pixel = pixel, .samples = kSamples});
  }
  static void expectNothing(Inspector& inspector, int frame,
                            const std::initializer_list<glm::ivec2>& pixels) {
    for (const glm::ivec2& pixel : pixels) {
      const taa::VerdictAnswer answer = answerOf(inspector, frame, pixel);
      EXPECT_EQ(answer.verdict.kind, VerdictKind::None)
          << pixel.x << ", " << pixel.y << ": " << answer.sentence;
    }
  }
};

// Poisoned history: the samples of one frame are wrong, the truth is not.

constexpr int kPoisoned = 13;

MadeCapture poisoned() {
  MadeCapture made;
  made.frames = 18;
  made.objects = {{kWall, "wall"}};
  made.pixel = [](int frame, const glm::ivec2& pixel) {
    MadePixel shown;
    if (frame == kPoisoned && isInMask(pixel)) shown.sample = glm::vec3(0.9f);
    return shown;
  };
  return made;
}

// A light that changes.

constexpr int kChanged = 6;

MadeCapture litUntil(int changed, bool isMasked = false) {
  MadeCapture made;
  made.frames = 30;
  made.objects = {{kWall, "wall"}};
  made.pixel = [changed, isMasked](int frame, const glm::ivec2& pixel) {
    MadePixel shown;
    if (frame < changed && isInMask(pixel)) shown.color = glm::vec3(0.8f);
    if (isMasked && isInMask(pixel - glm::ivec2(3, 0))) shown.responsive = 1.0f; // beside what changes
    return shown;
  };
  return made;
}

// An object that jumps, with the motion that leads there.

constexpr int kJumped = 6;
constexpr glm::ivec2 kFrom{4, 3}, kTo{18, 8}, kMoverPx{7, 6};

bool isInFrom(const glm::ivec2& pixel) {
  return isInRect(pixel, kFrom, kMoverPx);
}
bool isInTo(const glm::ivec2& pixel) {
  return isInRect(pixel, kTo, kMoverPx);
}

MadeCapture jumping(bool isFollowed) {
  MadeCapture made;
  made.frames = 18;
  made.objects = {{kWall, "wall"}, {kMover, "red box"}};
  made.pixel = [isFollowed](int frame, const glm::ivec2& pixel) {
    MadePixel shown;
    if (!(frame < kJumped ? isInFrom(pixel) : isInTo(pixel))) return shown;
    shown.color = kRed;
    shown.object = kMover;
    shown.depth = 5.0f;
    if (isFollowed && frame == kJumped) shown.motionPx = glm::vec2(kTo - kFrom);
    return shown;
  };
  return made;
}

} // namespace

TEST_F(KnownAnswersTest, PoisonedHistoryIsLetThroughWhereItIsPoisoned) {
  const auto inspector = opened("poisoned", poisoned(), plainly());
  for (const IntermediateId row : {IntermediateId::verdictMap, IntermediateId::geometryVerdict})
    expectRow(*inspector, row, kPoisoned, HistoryVerdict::LetThrough, isNowhere);
  for (const int frame : {kPoisoned + 1, kPoisoned + 3})
    expectRow(*inspector, IntermediateId::verdictMap, frame, HistoryVerdict::LetThrough, isInMask);
  expectRow(*inspector, IntermediateId::geometryVerdict, kPoisoned + 1, HistoryVerdict::LetThrough,
            isNowhere);
}

TEST_F(KnownAnswersTest, PoisonedHistoryIsRemovedByTheColorsAround) {
  const auto inspector = opened("poisoned", poisoned(), plainly({"rectify.method=clamp"}));
  // In the poisoned frame itself the box around a pixel holds good history only where it holds a good sample.
  expectRow(*inspector, IntermediateId::verdictMap, kPoisoned, HistoryVerdict::ThrownAway, innerOf(isInMask));
  expectRow(*inspector, IntermediateId::verdictMap, kPoisoned + 1, HistoryVerdict::Removed, isInMask);
  expectRow(*inspector, IntermediateId::verdictMap, kPoisoned + 2, HistoryVerdict::Removed, isNowhere);
}

TEST_F(KnownAnswersTest, PoisonedPixelsAreOffByTheSamplesOfThatFrame) {
  const auto inspector = opened("poisoned", poisoned(), plainly());
  const int frame = kPoisoned + 3;
  inspector->shot().seek(frame);
  for (const glm::ivec2& pixel : {glm::ivec2(6, 3), glm::ivec2(8, 8), glm::ivec2(18, 13)}) {
    const taa::VerdictAnswer answer = answerOf(*inspector, frame, pixel);
    EXPECT_EQ(answer.verdict.kind, VerdictKind::Aliasing) << answer.sentence;
    EXPECT_EQ(answer.verdict.stage, Stage::BlendWeight) << answer.sentence;
    EXPECT_EQ(answer.verdict.since, kPoisoned);
    // α of the poison, taken along by 1 − α three times.
    EXPECT_NEAR(answer.error.error().x, 0.1 * 0.7 * 0.9 * 0.9 * 0.9, 1e-6);
  }
  expectNothing(*inspector, frame, {{5, 3}, {11, 8}, {19, 13}, {31, 17}});
}

TEST_F(KnownAnswersTest, ALightThatChangedIsLagWhereItShone) {
  const auto inspector = opened("lit", litUntil(kChanged), plainly());
  expectRow(*inspector, IntermediateId::verdictMap, kChanged - 1, HistoryVerdict::LetThrough, isNowhere);
  for (const int frame : {kChanged, kChanged + 4})
    expectRow(*inspector, IntermediateId::verdictMap, frame, HistoryVerdict::LetThrough, isInMask);
  expectRow(*inspector, IntermediateId::geometryVerdict, kChanged, HistoryVerdict::LetThrough, isNowhere);
  // The second is older than all frames that are followed at first.
  for (const int frame : {kChanged + 3, kChanged + 21}) {
    inspector->shot().seek(frame);
    for (const glm::ivec2& pixel : {glm::ivec2(6, 3), glm::ivec2(9, 6), glm::ivec2(18, 9)}) {
      const taa::VerdictAnswer answer = answerOf(*inspector, frame, pixel);
      EXPECT_EQ(answer.verdict.kind, VerdictKind::Lag) << frame << ": " << answer.sentence;
      EXPECT_EQ(answer.verdict.since, kChanged) << answer.sentence;
      EXPECT_EQ(answer.verdict.stage, Stage::RectifyHistory);
      EXPECT_FALSE(answer.verdict.causeObject);
    }
    expectNothing(*inspector, frame, {{5, 3}, {11, 8}, {19, 9}});
  }
}

TEST_F(KnownAnswersTest, ATeleportedObjectIsLetThroughWhereItWas) {
  const auto inspector = opened("jumping", jumping(true), plainly());
  for (const IntermediateId row : {IntermediateId::verdictMap, IntermediateId::geometryVerdict}) {
    expectRow(*inspector, row, kJumped - 1, HistoryVerdict::LetThrough, isNowhere);
    expectRow(*inspector, row, kJumped, HistoryVerdict::LetThrough, isInFrom);
  }
  expectRow(*inspector, IntermediateId::verdictMap, kJumped + 3, HistoryVerdict::LetThrough, isInFrom);
  expectRow(*inspector, IntermediateId::geometryVerdict, kJumped + 3, HistoryVerdict::LetThrough, isNowhere);
}

// The test looks at the eight neighbors as well: it finds the wall beside the object's silhouette.
TEST_F(KnownAnswersTest, ATeleportedObjectIsFoundOutByItsNumberButAtItsRim) {
  const auto inspector = opened("jumping", jumping(true), plainly({"validate.object=on"}));
  const PixelSet isInner = innerOf(isInFrom);
  const auto expected = [&](const glm::ivec2& pixel) {
    if (!isInFrom(pixel)) return HistoryVerdict::RightlyKept;
    return isInner(pixel) ? HistoryVerdict::Removed : HistoryVerdict::LetThrough;
  };
  for (const IntermediateId row : {IntermediateId::verdictMap, IntermediateId::geometryVerdict})
    expectRow(*inspector, row, kJumped, expected);
}

TEST_F(KnownAnswersTest, ATeleportedObjectIsNamedWhereItWas) {
  const auto inspector = opened("jumping", jumping(true), plainly());
  for (const int frame : {kJumped, kJumped + 3}) {
    inspector->shot().seek(frame);
    for (const glm::ivec2& pixel : {kFrom, kFrom + kMoverPx / 2, kFrom + kMoverPx - 1}) {
      const taa::VerdictAnswer answer = answerOf(*inspector, frame, pixel);
      EXPECT_EQ(answer.verdict.kind, VerdictKind::Ghost) << answer.sentence;
      EXPECT_EQ(answer.verdict.stage, Stage::ValidateHistory) << answer.sentence;
      EXPECT_EQ(answer.verdict.since, kJumped);
      EXPECT_EQ(answer.verdict.causeFrame, kJumped - 1) << answer.sentence;
      EXPECT_EQ(answer.object, "red box");
    }
    expectNothing(*inspector, frame, {kFrom - 1, kFrom + kMoverPx, kTo, kTo + kMoverPx - 1, kTo - 1});
  }
}

TEST_F(KnownAnswersTest, AnObjectWithoutMotionLetsTheWallThrough) {
  const auto inspector = opened("appearing", jumping(false), plainly());
  const auto isInEither = [](const glm::ivec2& pixel) { return isInFrom(pixel) || isInTo(pixel); };
  for (const IntermediateId row : {IntermediateId::verdictMap, IntermediateId::geometryVerdict})
    expectRow(*inspector, row, kJumped, HistoryVerdict::LetThrough, isInEither);
  const int frame = kJumped + 3;
  inspector->shot().seek(frame);
  for (const glm::ivec2& pixel : {kTo, kTo + kMoverPx / 2}) {
    const taa::VerdictAnswer answer = answerOf(*inspector, frame, pixel);
    EXPECT_EQ(answer.verdict.kind, VerdictKind::Ghost) << answer.sentence;
    EXPECT_EQ(answer.object, "wall");
    EXPECT_EQ(answer.verdict.causeFrame, kJumped - 1) << answer.sentence;
  }
}

TEST_F(KnownAnswersTest, AMaskThatIsNotUsedIsSmearedUnder) {
  const auto inspector = opened("masked", litUntil(kChanged, true), plainly());
  expectRow(*inspector, IntermediateId::verdictMap, kChanged, HistoryVerdict::LetThrough, isInMask);
  const int frame = kChanged + 3;
  inspector->shot().seek(frame);
  for (const glm::ivec2& pixel : {glm::ivec2(9, 3), glm::ivec2(10, 12)}) { // changes, and is marked
    const taa::VerdictAnswer answer = answerOf(*inspector, frame, pixel);
    EXPECT_EQ(answer.verdict.kind, VerdictKind::MaskSmear) << answer.sentence;
    EXPECT_EQ(answer.verdict.stage, Stage::BlendWeight);
  }
}

TEST_F(KnownAnswersTest, AMaskBesideWhatChangesMendsOnlyWhatItMarks) {
  const auto inspector =
      opened("masked", litUntil(kChanged, true), plainly({"weight.mask=responsive", "weight.maskAlpha=1"}));
  const int frame = kChanged + 3;
  inspector->shot().seek(frame);
  expectNothing(*inspector, frame, {{9, 3}, {10, 12}});                   // changes, and is marked
  expectNothing(*inspector, frame, {{12, 3}, {21, 13}});                  // is marked alone
  for (const glm::ivec2& pixel : {glm::ivec2(6, 3), glm::ivec2(8, 13)}) { // changes alone
    const taa::VerdictAnswer answer = answerOf(*inspector, frame, pixel);
    EXPECT_EQ(answer.verdict.kind, VerdictKind::Lag) << answer.sentence;
    EXPECT_EQ(answer.verdict.since, kChanged);
  }
}
