// A row against the frame before, each pixel where it came from: in scenes that stand, move and are cut, of
// captures, and at probes.
#include "core/base/Light.h"
#include "core/inspect/ShownPicture.h"
#include "core/picture/ColorMap.h"
#include "tests/support/Paths.h"
#include "tests/support/SmallInspector.h"
#include "tests/support/capture/CapturedShot.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

using namespace taa;
using taa::test::small::expectSame;
using taa::test::small::fresh;
using taa::test::small::isSame;
using taa::test::small::kHeight;
using taa::test::small::kWidth;

namespace {

constexpr gl::Rect kWhole{0, 0, kWidth, kHeight};

PictureSource rowOf(IntermediateId id) {
  return {id, 0, {}};
}

PictureSource rowBefore(const Inspector& inspector, IntermediateId id) {
  OtherSide other;
  other.id = id;
  other.alongMotion = true;
  return otherSource(other, inspector.shot().frame(), inspector.shot().frameCount());
}

void keepFrameBefore(Inspector& inspector) {
  const PictureSource source = rowBefore(inspector, IntermediateId::color);
  if (source.frame) inspector.views().keepComparisonFrames({*source.frame});
}

PartialImage difference(Inspector& inspector, IntermediateId id) {
  keepFrameBefore(inspector);
  return inspector.views().values(rowOf(id), rowBefore(inspector, id), kWhole);
}

Absence absenceIn(const PartialImage& image, int x, int y) {
  return image.absence.empty() ? Absence::None
                               : static_cast<Absence>(static_cast<int>(*image.absence.at(x, y)));
}

void expectAllAbsent(const PartialImage& image, Absence absence) {
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_EQ(absenceIn(image, x, y), absence);
      ASSERT_TRUE(std::isnan(*image.values.at(x, y)));
    }
}

const Image& of(const std::vector<Image>& rows, IntermediateId id) {
  return rows[static_cast<std::size_t>(id)];
}

class AlongMotionTest : public taa::test::small::InspectorTest {
 protected:
  /// Looks to the right by 5 degrees a frame: what comes in was off screen.
  static std::unique_ptr<Inspector> turning() {
    auto inspector = opened();
    CameraTrack track;
    track.name = "turning";
    for (int frame = 0; frame < 10; ++frame) {
      track.poses.push_back(inspector->shot().cameraPose());
      track.poses.back().yaw += 5.0f * float(frame);
    }
    inspector->shot().setCameraTrack(track);
    return inspector;
  }
  static std::unique_ptr<Inspector> still() {
    auto inspector = opened();
    inspector->shot().open("builtin:fence");
    inspector->shot().setCamera("still");
    return inspector;
  }
};

} // namespace

TEST_F(AlongMotionTest, WhereNothingMovesRowsOfMotionDifferByExactlyNothing) {
  const auto inspector = still();
  inspector->shot().seek(5);
  for (const IntermediateId id :
       {IntermediateId::motion, IntermediateId::dilatedMotion, IntermediateId::speed,
        IntermediateId::historyPosition, IntermediateId::onScreen}) {
    const PartialImage rows = difference(*inspector, id);
    EXPECT_TRUE(rows.absence.empty()) << intermediate(id).name;
    for (const float value : rows.values.pixels) ASSERT_EQ(value, 0.0f) << intermediate(id).name;
  }
}

TEST_F(AlongMotionTest, WhereNothingMovesItIsTheDifferenceOfBothFrames) {
  const auto inspector = still();
  inspector->shot().seek(4);
  const std::vector<Image> before = inspector->views().images(allRows());
  inspector->shot().seek(5);
  const std::vector<Image> now = inspector->views().images(allRows());
  int changed = 0;
  for (const IntermediateId id : allRows()) {
    const PartialImage rows = difference(*inspector, id);
    ASSERT_TRUE(rows.absence.empty()) << intermediate(id).name;
    for (std::size_t index = 0; index < rows.values.pixels.size(); ++index) {
      const float expected = of(now, id).pixels[index] - of(before, id).pixels[index];
      ASSERT_EQ(rows.values.pixels[index], expected) << intermediate(id).name;
      changed += expected != 0.0f ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 0) << "jitter and history go on";
}

TEST_F(AlongMotionTest, WhereItMovesEveryRowIsReadAtTheHistoryPosition) {
  const auto inspector = opened();
  inspector->shot().seek(7);
  const std::vector<Image> before = fresh(Settings{}, 6), now = fresh(Settings{}, 7);
  for (const IntermediateId id : allRows()) {
    const Intermediate& row = intermediate(id);
    const PartialImage there = taa::rowBefore(row, of(before, id), of(now, IntermediateId::historyPosition),
                                              of(now, IntermediateId::dilatedMotion));
    const PartialImage expected = differenceOf(row, {of(now, id), {}}, there);
    const PartialImage rows = difference(*inspector, id);
    EXPECT_TRUE(isSame(rows.values, expected.values)) << row.name;
    ASSERT_EQ(rows.absence.pixels, expected.absence.pixels) << row.name;
  }
}

TEST_F(AlongMotionTest, WhatComesFromOffScreenHasNothing) {
  const auto inspector = turning();
  inspector->shot().seek(7);
  const Image onScreen = inspector->views().image(IntermediateId::onScreen);
  const PartialImage rows = difference(*inspector, IntermediateId::color);
  int off = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool isOn = *onScreen.at(x, y) == 1.0f;
      off += isOn ? 0 : 1;
      EXPECT_EQ(absenceIn(rows, x, y) == Absence::None, isOn) << x << ", " << y;
      EXPECT_EQ(std::isnan(*rows.values.at(x, y)), !isOn) << x << ", " << y;
    }
  EXPECT_GT(off, 0);
}

TEST_F(AlongMotionTest, TheFirstFrameAndCutsHaveNoneBefore) {
  const auto inspector = opened();
  expectAllAbsent(difference(*inspector, IntermediateId::alpha), Absence::FirstFrame);
  inspector->shot().open("builtin:cut");
  inspector->shot().seek(60);
  expectAllAbsent(difference(*inspector, IntermediateId::alpha), Absence::Cut);
  inspector->shot().seek(61);
  EXPECT_EQ(absenceIn(difference(*inspector, IntermediateId::alpha), kWidth / 2, kHeight / 2), Absence::None);
  expectAllAbsent(difference(*inspector, IntermediateId::historyRawLength), Absence::NoHistory);
}

TEST_F(AlongMotionTest, ThingsMoveOnThroughARestartWithoutHistory) {
  const auto inspector = opened();
  inspector->shot().setRestarts({3});
  inspector->shot().seek(3);
  expectAllAbsent(difference(*inspector, IntermediateId::clipAmount), Absence::NoHistory);
  EXPECT_EQ(absenceIn(difference(*inspector, IntermediateId::color), kWidth / 2, kHeight / 2), Absence::None);
}

TEST_F(AlongMotionTest, AProbeHasBothSidesOfThePicture) {
  const auto inspector = turning();
  inspector->shot().seek(7);
  keepFrameBefore(*inspector);
  for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(kWidth - 1, kHeight - 1), glm::ivec2(20, 12)}) {
    const PixelRecord now = inspector->probes().probe(pixel.x, pixel.y);
    const ComparedPixel compared =
        inspector->probes().compared(pixel, rowBefore(*inspector, IntermediateId::color));
    EXPECT_EQ(compared.frame, 6);
    for (const IntermediateId id : allRows()) {
      const PartialImage rows = difference(*inspector, id);
      const PartialValue value = differenceOf(now, compared, id);
      ASSERT_EQ(value.absence, absenceIn(rows, pixel.x, pixel.y)) << intermediate(id).name;
      if (value.absence != Absence::None) continue;
      EXPECT_EQ(value.value, rows.values.texel(pixel.x, pixel.y)) << intermediate(id).name;
    }
  }
}

TEST_F(AlongMotionTest, AProbeComparesLanesAndFramesAtItsPixel) {
  const auto inspector = opened({Settings{}, taa::test::small::otherSettings()});
  inspector->shot().seek(5);
  inspector->views().keepComparisonFrames({2});
  const ComparedPixel lane = inspector->probes().compared({20, 12}, {.lane = 1});
  const ComparedPixel frame = inspector->probes().compared({20, 12}, {.frame = 2});
  const std::vector<Image> ofLane = fresh(taa::test::small::otherSettings(), 5),
                           ofFrame = fresh(Settings{}, 2);
  for (const IntermediateId id : allRows()) {
    EXPECT_EQ(lane.of(id).value, of(ofLane, id).texel(20, 12)) << intermediate(id).name;
    EXPECT_EQ(frame.of(id).value, of(ofFrame, id).texel(20, 12)) << intermediate(id).name;
  }
  EXPECT_EQ(frame.frame, 2);
  EXPECT_FALSE(lane.position || frame.position);
}

TEST_F(AlongMotionTest, LookingChangesNothing) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  inspector->views().watch({IntermediateId::resolved, IntermediateId::historyPosition});
  for (int frame = 6; frame < 8; ++frame) {
    inspector->shot().advance();
    difference(*inspector, IntermediateId::resolved);
    const ViewStyle style = differenceStyle(intermediate(IntermediateId::resolved));
    inspector->views().picture(rowOf(IntermediateId::resolved),
                               rowBefore(*inspector, IntermediateId::resolved), style, {}, kWidth, kHeight);
    expectSame(inspector->views().images(allRows()), fresh(Settings{}, frame));
  }
}

TEST_F(AlongMotionTest, IsTheSameHoweverTheFrameIsReached) {
  const auto inspector = opened();
  inspector->shot().seek(9);
  const PartialImage straight = difference(*inspector, IntermediateId::resolved);
  inspector->shot().seek(12);
  inspector->shot().seek(8);
  difference(*inspector, IntermediateId::resolved);
  inspector->shot().advance();
  const PartialImage again = difference(*inspector, IntermediateId::resolved);
  EXPECT_TRUE(isSame(again.values, straight.values));
  EXPECT_EQ(again.absence.pixels, straight.absence.pixels);
}

TEST_F(AlongMotionTest, FollowsSettings) {
  const auto inspector = opened();
  inspector->shot().seek(6);
  difference(*inspector, IntermediateId::resolved);
  inspector->shot().setSettings(taa::test::small::otherSettings());
  inspector->shot().refine();
  const PartialImage rows = difference(*inspector, IntermediateId::resolved);
  const std::vector<Image> before = fresh(taa::test::small::otherSettings(), 5),
                           now = fresh(taa::test::small::otherSettings(), 6);
  const Intermediate& row = intermediate(IntermediateId::resolved);
  const PartialImage there = taa::rowBefore(row, of(before, row.id), of(now, IntermediateId::historyPosition),
                                            of(now, IntermediateId::dilatedMotion));
  EXPECT_TRUE(isSame(rows.values, differenceOf(row, {of(now, row.id), {}}, there).values));
}

TEST_F(AlongMotionTest, OfACaptureItIsThatOfTheSceneItWasTakenOf) {
  const std::filesystem::path folder = taa::test::temporaryFolder() / "along-motion";
  std::async(std::launch::async, [&] {
    const gl::Context context;
    taa::test::CapturedShot("builtin:fan", {kWidth, kHeight}, Settings{}, 5).write(folder, false);
  }).get();
  std::vector<PartialImage> ofScene;
  {
    const auto scene = opened();
    scene->shot().seek(4);
    for (const IntermediateId id : allRows()) ofScene.push_back(difference(*scene, id));
  }
  const auto capture = opened();
  capture->shot().open(folder.string());
  capture->shot().seek(4);
  for (const IntermediateId id : allRows()) {
    const PartialImage rows = difference(*capture, id);
    EXPECT_TRUE(isSame(rows.values, ofScene[static_cast<std::size_t>(id)].values)) << intermediate(id).name;
    EXPECT_EQ(rows.absence.pixels, ofScene[static_cast<std::size_t>(id)].absence.pixels);
  }
}

TEST_F(AlongMotionTest, ThePictureHasTheMapsMiddleForNothingChangedAndCheckersForNothingThere) {
  const auto inspector = turning();
  inspector->shot().seek(7);
  const PartialImage rows = difference(*inspector, IntermediateId::onScreen);
  const ViewStyle style = differenceStyle(intermediate(IntermediateId::onScreen));
  const Picture picture =
      inspector->views().picture(rowOf(IntermediateId::onScreen),
                                 rowBefore(*inspector, IntermediateId::onScreen), style, {}, kWidth, kHeight);
  const auto byteOf = [](float linear) {
    return static_cast<int>(std::lround(255.0f * srgbEncoded(linear)));
  };
  int absent = 0, unchanged = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int shown = picture.rgba[(static_cast<std::size_t>(y) * kWidth + x) * 4];
      if (absenceIn(rows, x, y) != Absence::None) {
        ++absent;
        const int cell = x / int(kNothingSide) + y / int(kNothingSide);
        EXPECT_EQ(shown, byteOf(kNothingLight[cell % 2 == 0 ? 0 : 1])) << x << ", " << y;
      } else if (*rows.values.at(x, y) == 0.0f) {
        ++unchanged;
        EXPECT_EQ(shown, byteOf(mapColor(style.map, 0.5f)[0])) << x << ", " << y;
      }
    }
  EXPECT_TRUE(absent > 0 && unchanged > 0);
}
