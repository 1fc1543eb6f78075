// Rows of the frame before along a motion that is known, made by hand.
#include "core/measure/compare/FrameBefore.h"

#include "core/measure/compare/ComparedPixel.h"
#include "core/render/FrameInputs.h"
#include "tests/unit/compare/Pictures.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <utility>

using taa::Absence;
using taa::Image;
using taa::intermediate;
using taa::IntermediateId;
using taa::PartialImage;
using taa::PartialValue;
using namespace taa::test;

namespace {

constexpr int kWide = 12, kHigh = 6;
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

/// A row with the visual and channels that decide how it is read.
const taa::Intermediate& colors() {
  return intermediate(IntermediateId::resolved);
}

Image motionOf(const glm::vec2& motion) {
  Image image(kWide, kHigh, 2);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      for (int channel = 0; channel < 2; ++channel) image.at(x, y)[channel] = motion[channel];
  return image;
}

/// Pixel center minus motion, as the resolve has it.
Image positionsOf(const Image& motion) {
  Image image(motion.width, motion.height, 2);
  for (int y = 0; y < motion.height; ++y)
    for (int x = 0; x < motion.width; ++x) {
      image.at(x, y)[0] = float(x) + 0.5f - motion.at(x, y)[0];
      image.at(x, y)[1] = float(y) + 0.5f - motion.at(x, y)[1];
    }
  return image;
}

PartialImage before(const taa::Intermediate& row, const Image& picture, const Image& motion) {
  return taa::rowBefore(row, picture, positionsOf(motion), motion);
}

Absence absenceIn(const PartialImage& image, int x, int y) {
  return image.absence.empty() ? Absence::None
                               : static_cast<Absence>(static_cast<int>(*image.absence.at(x, y)));
}

Image numbers(const std::function<float(int x, int y)>& value) {
  Image image(kWide, kHigh, 1);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) *image.at(x, y) = value(x, y);
  return image;
}

} // namespace

TEST(FrameBefore, APictureThatMovesByWholePixelsDiffersByNothingAndComesFromOffScreen) {
  const Image then = pictureOf(kWide, kHigh, patternColor);
  const Image now = pictureOf(kWide, kHigh, [](int x, int y) { return patternColor(x - 3, y + 1); });
  const PartialImage difference =
      taa::differenceOf(colors(), {now, {}}, before(colors(), then, motionOf({3.0f, -1.0f})));
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) {
      const bool isInside = x >= 3 && y + 1 < kHigh;
      EXPECT_EQ(absenceIn(difference, x, y), isInside ? Absence::None : Absence::OffScreen) << x << " " << y;
      for (int channel = 0; channel < 3; ++channel) {
        const float value = difference.values.at(x, y)[channel];
        EXPECT_TRUE(isInside ? value == 0.0f : std::isnan(value)) << x << " " << y << ": " << value;
      }
    }
}

TEST(FrameBefore, AChangeOnTheWayIsTheDifference) {
  const Image then = numbers([](int x, int) { return float(x) / 8.0f; });
  const Image now = numbers([](int x, int y) { return float(x - 2) / 8.0f + (y == 4 ? 0.25f : 0.0f); });
  const taa::Intermediate& row = intermediate(IntermediateId::alpha);
  const PartialImage difference =
      taa::differenceOf(row, {now, {}}, before(row, then, motionOf({2.0f, 0.0f})));
  for (int y = 0; y < kHigh; ++y)
    for (int x = 2; x < kWide; ++x) EXPECT_EQ(*difference.values.at(x, y), y == 4 ? 0.25f : 0.0f);
}

TEST(FrameBefore, BetweenTexelsValuesAreReadBilinearly) {
  // In eighths, so that every product is exact: a ramp is read as itself, a bend as the mean of its sides.
  const Image ramp = numbers([](int x, int y) { return float(x) / 8.0f + float(y) / 4.0f; });
  const taa::Intermediate& row = intermediate(IntermediateId::alpha);
  const PartialImage read = before(row, ramp, motionOf({0.25f, 0.5f}));
  for (int y = 1; y < kHigh; ++y)
    for (int x = 1; x < kWide; ++x)
      EXPECT_EQ(*read.values.at(x, y), (float(x) - 0.25f) / 8.0f + (float(y) - 0.5f) / 4.0f);
  const Image step = numbers([](int x, int) { return x >= 6 ? 1.0f : 0.0f; });
  EXPECT_EQ(*before(row, step, motionOf({0.25f, 0.0f})).values.at(6, 2), 0.75f);
}

TEST(FrameBefore, AConstantStaysItselfHoweverItMoves) {
  const Image flat = numbers([](int, int) { return 0.1f; });
  const taa::Intermediate& row = intermediate(IntermediateId::alpha);
  const PartialImage read = before(row, flat, motionOf({0.3f, -0.7f}));
  for (int y = 0; y < kHigh - 1; ++y)
    for (int x = 1; x < kWide; ++x) EXPECT_EQ(*read.values.at(x, y), 0.1f);
}

TEST(FrameBefore, WhatLiesBesideAPictureIsItsBorder) {
  const Image step = numbers([](int x, int) { return float(x); });
  const taa::Intermediate& row = intermediate(IntermediateId::alpha);
  EXPECT_EQ(*before(row, step, motionOf({0.5f, 0.0f})).values.at(0, 2), 0.0f) << "at the edge itself";
  EXPECT_EQ(*before(row, step, motionOf({-0.5f, 0.0f})).values.at(kWide - 1, 2), float(kWide - 1));
  EXPECT_EQ(absenceIn(before(row, step, motionOf({0.75f, 0.0f})), 0, 2), Absence::OffScreen);
}

TEST(FrameBefore, IndicesAndMasksAreThoseOfTheNearestTexel) {
  const Image ids = numbers([](int x, int) { return x >= 6 ? 9.0f : 2.0f; });
  for (const IntermediateId id : {IntermediateId::objectId, IntermediateId::onScreen}) {
    const taa::Intermediate& row = intermediate(id);
    EXPECT_EQ(*before(row, ids, motionOf({0.25f, 0.0f})).values.at(6, 2), 9.0f) << row.name;
    EXPECT_EQ(*before(row, ids, motionOf({0.75f, 0.0f})).values.at(6, 2), 2.0f) << row.name;
  }
}

TEST(FrameBefore, TheSkyIsNoDepthToMixWith) {
  const Image depth = numbers([](int x, int) { return x >= 6 ? 8.0f : 0.0f; });
  const taa::Intermediate& row = intermediate(IntermediateId::depthView);
  EXPECT_EQ(*before(row, depth, motionOf({0.25f, 0.0f})).values.at(6, 2), 8.0f);
  EXPECT_EQ(*before(row, depth, motionOf({0.75f, 0.0f})).values.at(6, 2), 0.0f);
  EXPECT_EQ(*before(row, depth, motionOf({1.0f, 0.0f})).values.at(7, 2), 8.0f)
      << "its neighbor counts nothing";
}

TEST(FrameBefore, ATexelThatCountsNothingMayBeAnything) {
  const Image color = numbers([](int x, int) { return x == 5 ? kNoNumber : 1.0f; });
  const taa::Intermediate& row = intermediate(IntermediateId::alpha);
  const PartialImage read = before(row, color, motionOf({2.0f, 0.0f}));
  EXPECT_EQ(*read.values.at(6, 2), 1.0f);
  EXPECT_TRUE(std::isnan(*read.values.at(7, 2)));
  EXPECT_EQ(absenceIn(read, 7, 2), Absence::None) << "the row itself is NaN there";
}

TEST(FrameBefore, WhatHasNoPreviousPositionHasNoDifference) {
  const glm::vec2 none(taa::kNoPreviousPosition);
  const taa::Intermediate& row = intermediate(IntermediateId::motion);
  EXPECT_EQ(taa::absenceAt({-65503.5f, -65503.5f}, none, {kWide, kHigh}), Absence::NoPreviousPosition);
  EXPECT_EQ(taa::absenceAt({3.5f, 3.5f}, none, {kWide, kHigh}), Absence::None) << "history is read in place";
  EXPECT_EQ(taa::absenceAt({kNoNumber, 1.0f}, {}, {kWide, kHigh}), Absence::OffScreen);
  const PartialValue known{{2.0f, 0.0f, 0.0f, 0.0f}}, unknown{{none, 0.0f, 0.0f}};
  for (const auto& [now, other] :
       {std::pair(known, unknown), std::pair(unknown, known), std::pair(unknown, unknown)}) {
    const PartialValue difference = taa::differenceOf(row, now, other);
    EXPECT_EQ(difference.absence, Absence::NoPreviousPosition);
    EXPECT_TRUE(std::isnan(difference.value.x));
  }
  EXPECT_EQ(taa::differenceOf(row, known, known).value, glm::vec4(0.0f));
}

TEST(FrameBefore, SaysWhyThereIsNothing) {
  const taa::PartialValue known{glm::vec4(1.0f)};
  EXPECT_EQ(taa::absenceText(Absence::None), "");
  EXPECT_EQ(taa::absenceText(Absence::FirstFrame), "no frame before");
  EXPECT_EQ(taa::absenceText(Absence::Cut), "the shot is cut here");
  for (const Absence absence : {Absence::FirstFrame, Absence::Cut, Absence::NoHistory, Absence::OffScreen}) {
    EXPECT_EQ(taa::differenceOf(colors(), known, taa::absentValue(absence)).absence, absence);
    const PartialImage none = taa::absentImage(colors(), {2, 1}, absence);
    EXPECT_EQ(absenceIn(none, 1, 0), absence);
    EXPECT_TRUE(std::isnan(none.values.at(1, 0)[2]));
  }
}

TEST(FrameBefore, APartOfItIsThatPart) {
  const Image then = pictureOf(kWide, kHigh, patternColor);
  const PartialImage whole = before(colors(), then, motionOf({1.5f, 0.0f}));
  const PartialImage part = taa::partOf(whole, {1, 2}, {4, 3});
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) {
      EXPECT_EQ(absenceIn(part, x, y), absenceIn(whole, x + 1, y + 2));
      if (absenceIn(part, x, y) == Absence::None) {
        EXPECT_EQ(part.values.texel(x, y), whole.values.texel(x + 1, y + 2));
      }
    }
}

TEST(ComparedPixel, ReadsRecordsAsPicturesAreRead) {
  const Image then = pictureOf(kWide, kHigh, patternColor);
  const glm::vec2 position(6.25f, 3.75f);
  std::array<taa::twin::PixelRecord, 4> taps{};
  const glm::ivec2 first = taa::firstTap(position);
  for (int tap = 0; tap < 4; ++tap)
    taa::twin::at(taps[static_cast<std::size_t>(tap)], IntermediateId::resolved) =
        then.texel(first.x + tap % 2, first.y + tap / 2);
  const PartialValue read =
      taa::valueBetween(std::span<const taa::twin::PixelRecord, 4>(taps), position, IntermediateId::resolved);
  const Image motion = motionOf(glm::vec2(6.5f, 3.5f) - position);
  EXPECT_EQ(read.value, before(colors(), then, motion).values.texel(6, 3));
}

TEST(ComparedPixel, TellsNothingOfWhatARecordDoesNot) {
  taa::twin::PixelRecord record{};
  taa::twin::at(record, IntermediateId::rejectReason).x = 1.0f; // no history
  taa::twin::at(record, IntermediateId::flip).x = kNoNumber;
  EXPECT_EQ(taa::valueIn(record, IntermediateId::historyRaw).absence, Absence::NoHistory);
  EXPECT_EQ(taa::valueIn(record, IntermediateId::flip).absence, Absence::NoReference);
  EXPECT_EQ(taa::valueIn(record, IntermediateId::color).absence, Absence::None);
  taa::ComparedPixel compared;
  taa::twin::PixelRecord now{};
  taa::twin::at(now, IntermediateId::alpha).x = 0.75f;
  compared.other[static_cast<std::size_t>(IntermediateId::alpha)] = {{0.5f, 0.0f, 0.0f, 0.0f}};
  EXPECT_EQ(differenceOf(now, compared, IntermediateId::alpha).value.x, 0.25f);
}
