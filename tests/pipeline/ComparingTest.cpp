// Comparing on a small picture: lanes that come and go, frames beside the one on show, differences.
#include "core/base/Light.h"
#include "core/picture/ColorMap.h"
#include "tests/support/SmallInspector.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

using taa::Image;
using taa::Inspector;
using taa::IntermediateId;
using taa::Picture;
using taa::PictureSource;
using taa::Settings;
using taa::ViewStyle;
using taa::test::otherJitter;
using taa::test::small::expectSame;
using taa::test::small::fresh;
using taa::test::small::isSame;
using taa::test::small::kHeight;
using taa::test::small::kWidth;
using taa::test::small::otherSettings;

using ComparingTest = taa::test::small::InspectorTest;

namespace {

constexpr taa::gl::Rect kWhole{0, 0, kWidth, kHeight};

Picture draw(Inspector& inspector, const PictureSource& source,
             const std::optional<PictureSource>& minus = {}, const ViewStyle& style = {}) {
  return inspector.views().picture(source, minus, style, {}, kWidth, kHeight);
}

int drawsOfTheScene(const taa::FrameProfile& profile) {
  int draws = 0;
  for (const taa::PassCost& pass : profile.passes)
    if (pass.name == "G-buffer") draws += pass.runs;
  return draws;
}

} // namespace

TEST_F(ComparingTest, ALaneThatComesGivesWhatItsPresetGivesAlone) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  inspector->shot().changeLanes({Settings{}, otherSettings()});
  EXPECT_EQ(inspector->shot().laneCount(), 2);
  EXPECT_TRUE(inspector->shot().isExact(0));
  EXPECT_FALSE(inspector->shot().isExact(1)) << "its history is yet to be replayed";
  EXPECT_FALSE(inspector->shot().areAllExact());
  inspector->shot().refine();
  EXPECT_TRUE(inspector->shot().areAllExact());
  expectSame(inspector->views().images(taa::allRows(), 0), fresh(Settings{}, 5));
  expectSame(inspector->views().images(taa::allRows(), 1), fresh(otherSettings(), 5));
  inspector->shot().changeLanes({Settings{}});
  EXPECT_EQ(inspector->shot().laneCount(), 1);
  EXPECT_TRUE(inspector->shot().areAllExact());
  expectSame(inspector->views().images(taa::allRows()), fresh(Settings{}, 5));
}

TEST_F(ComparingTest, TwoLanesOfTheSameInputsDrawTheSceneOnce) {
  const auto inspector = opened();
  inspector->shot().changeLanes({Settings{}, otherSettings(), otherJitter()});
  EXPECT_EQ(&inspector->views().inputs(0), &inspector->views().inputs(1));
  EXPECT_NE(&inspector->views().inputs(0), &inspector->views().inputs(2));
  inspector->shot().changeLanes({Settings{}, otherSettings()});
  inspector->profiler().setProfiling(true);
  inspector->shot().advance();
  const auto two = inspector->profiler().takeProfile();
  inspector->shot().changeLanes({Settings{}});
  inspector->shot().advance();
  const auto one = inspector->profiler().takeProfile();
  ASSERT_TRUE(one && two);
  EXPECT_GT(drawsOfTheScene(*one), 0);
  EXPECT_EQ(drawsOfTheScene(*two), drawsOfTheScene(*one));
}

TEST_F(ComparingTest, ALaneCanTakeOtherSettingsWithoutTheOthersNoticing) {
  const auto inspector = opened({Settings{}, otherSettings()});
  inspector->shot().seek(3);
  inspector->shot().changeLanes({Settings{}, otherJitter()});
  EXPECT_TRUE(inspector->shot().isExact(0));
  inspector->shot().refine();
  expectSame(inspector->views().images(taa::allRows(), 1), fresh(otherJitter(), 3));
}

TEST_F(ComparingTest, RefusesTooManyLanesAndStaysAsItWas) {
  const auto inspector = opened();
  EXPECT_THROW(inspector->shot().changeLanes(std::vector<Settings>(taa::kMaxLanes + 1)), taa::Error);
  EXPECT_EQ(inspector->shot().laneCount(), 1);
}

TEST_F(ComparingTest, AComparisonFrameIsThatFrameAndTheOneOnShowStays) {
  const auto inspector = opened();
  inspector->shot().seek(6);
  const std::vector<Image> before = inspector->views().images(taa::allRows());
  const PictureSource compared{IntermediateId::alpha, 0, 2};
  EXPECT_FALSE(inspector->views().isCached(compared));
  inspector->views().keepComparisonFrames({2, 9});
  EXPECT_TRUE(inspector->views().isCached(compared) && inspector->views().isExact(compared));
  EXPECT_TRUE(inspector->views().isCached({.frame = 9}));
  const std::vector<Image> expected = fresh(Settings{}, 2);
  for (std::size_t index = 0; index < taa::allRows().size(); ++index)
    EXPECT_TRUE(
        isSame(inspector->views().values({taa::allRows()[index], 0, 2}, {}, kWhole).values, expected[index]))
        << taa::kIntermediates[index].name;
  EXPECT_EQ(inspector->shot().frame(), 6);
  EXPECT_TRUE(inspector->shot().areAllExact());
  expectSame(inspector->views().images(taa::allRows()), before);
  inspector->views().keepComparisonFrames({9});
  EXPECT_FALSE(inspector->views().isCached(compared));
  inspector->shot().setSettings(otherSettings());
  EXPECT_FALSE(inspector->views().isCached({.frame = 9})) << "it was drawn with other settings";
}

TEST_F(ComparingTest, AComparisonFrameCanBeGivenUp) {
  const auto inspector = opened();
  inspector->shot().seek(4);
  EXPECT_THROW(
      inspector->views().keepComparisonFrames({40}, [](std::string_view, int done, int) { return done < 3; }),
      taa::Cancelled);
  EXPECT_FALSE(inspector->views().isCached({.frame = 40}));
  EXPECT_EQ(inspector->shot().frame(), 4);
  expectSame(inspector->views().images(taa::allRows()), fresh(Settings{}, 4));
}

TEST_F(ComparingTest, DifferencesAreThoseOfTheValues) {
  const auto inspector = opened({Settings{}, otherSettings()});
  inspector->shot().seek(5);
  inspector->views().keepComparisonFrames({1});
  const PictureSource resolved{IntermediateId::resolved, 0, {}};
  const PictureSource others[] = {
      {IntermediateId::color, 0, {}}, {IntermediateId::resolved, 1, {}}, {IntermediateId::resolved, 0, 1}};
  for (const PictureSource& other : others) {
    const Image a = inspector->views().values(resolved, {}, kWhole).values,
                b = inspector->views().values(other, {}, kWhole).values;
    const Image difference = inspector->views().values(resolved, other, kWhole).values;
    ViewStyle style;
    style.map = taa::ColorMap::Gray;
    style.low = -1.0f;
    const Picture picture = draw(*inspector, resolved, other, style);
    int different = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        float most = 0.0f;
        for (int channel = 0; channel < 3; ++channel) {
          const float each = a.at(x, y)[channel] - b.at(x, y)[channel];
          ASSERT_EQ(difference.at(x, y)[channel], each);
          if (std::abs(each) > std::abs(most)) most = each;
        }
        different += most != 0.0f ? 1 : 0;
        const int shown = picture.rgba[(static_cast<std::size_t>(y) * kWidth + x) * 4];
        const auto place = taa::mapColor(taa::ColorMap::Gray, 0.5f + 0.5f * most);
        // 1: the driver's pow() where the encoded value lies half way between two bytes.
        ASSERT_NEAR(shown, 255.0f * taa::srgbEncoded(place[0]), 1.0f) << x << ", " << y;
      }
    EXPECT_GT(different, 0);
  }
}

TEST_F(ComparingTest, OverlaysOfARowCanBeLookedAtWithoutBeingWatched) {
  const auto inspector = opened();
  inspector->shot().seek(3);
  ViewStyle style;
  const Picture bare = draw(*inspector, {IntermediateId::resolved}, {}, style);
  style.markRejected = style.outlineObjects = true;
  const Picture over = draw(*inspector, {IntermediateId::resolved}, {}, style);
  const Image reasons = inspector->views().image(IntermediateId::rejectReason);
  const Image objects = inspector->views().image(IntermediateId::objectId);
  int tinted = 0, outlined = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const std::size_t at = (static_cast<std::size_t>(y) * kWidth + x) * 4;
      const bool isEdge = (x > 0 && *objects.at(x - 1, y) != *objects.at(x, y)) ||
                          (y > 0 && *objects.at(x, y - 1) != *objects.at(x, y));
      const bool isTinted = *reasons.at(x, y) != 0.0f;
      outlined += isEdge ? 1 : 0;
      tinted += isTinted ? 1 : 0;
      const bool isSamePixel = std::equal(over.rgba.begin() + static_cast<std::ptrdiff_t>(at),
                                          over.rgba.begin() + static_cast<std::ptrdiff_t>(at) + 3,
                                          bare.rgba.begin() + static_cast<std::ptrdiff_t>(at));
      if (!isEdge && !isTinted) {
        EXPECT_TRUE(isSamePixel) << x << ", " << y;
      } else if (isEdge) {
        EXPECT_EQ(over.rgba[at], (x + y) / 4 % 2 == 0 ? 255 : 0) << x << ", " << y;
      }
    }
  EXPECT_GT(tinted, 0);
  EXPECT_GT(outlined, 0);
}
