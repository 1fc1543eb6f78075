// Numbers of settings that are compared, written by hand.
#include "app/models/alternatives/SweepSeries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

using taa::FrameMetrics;
using taa::LaneMetrics;
using taa::Metric;
using taa::app::Curve;
using taa::app::ScatterPoint;
using taa::app::SweepSeries;

namespace {

FrameMetrics frame(int number, std::optional<double> rmse, double psnr) {
  FrameMetrics made{.frame = number, .values = {}};
  made.at(Metric::Rmse) = rmse;
  made.at(Metric::Psnr) = psnr;
  return made;
}

/// Four settings of which three are measured, on one scene.
SweepSeries series() {
  SweepSeries made;
  made.begin({"first", "second, with a comma", "third", "fourth"}, {"Fan"}, {Metric::Rmse, Metric::Psnr});
  made.add(0, {frame(4, 0.25, 20), frame(5, 0.75, 30)});
  made.add(1, {frame(4, std::nullopt, 40), frame(5, 0.25, 50)});
  made.add(3, {frame(4, 1.0, 10), frame(5, 1.0, 10)});
  return made;
}

/// Two settings on two scenes: the second has less error on the first scene and more on the other.
SweepSeries onTwoScenes() {
  SweepSeries made;
  made.begin({"one", "other"}, {"Fan", "Fence, far"}, {Metric::Rmse, Metric::Psnr});
  made.add(0, {frame(4, 0.5, 20)});
  made.add(1, {frame(4, 0.25, 30)});
  made.add(2, {frame(4, 2.0, 10)});
  made.add(3, {frame(4, 4.0, 5)});
  return made;
}

} // namespace

TEST(SweepSeries, KnowsMeansOfTheFramesThatHaveThem) {
  const SweepSeries all = series();
  EXPECT_EQ(all.measuredCount(), 3u);
  EXPECT_EQ(all.mean(0, Metric::Rmse), 0.5);
  EXPECT_EQ(all.mean(1, Metric::Rmse), 0.25);
  EXPECT_EQ(all.mean(1, Metric::Psnr), 45.0);
  EXPECT_FALSE(all.mean(2, Metric::Rmse));
  EXPECT_FALSE(all.isMeasured(2));
}

TEST(SweepSeries, DrawsACurveForEachThatIsMeasured) {
  const std::vector<Curve> curves = series().curves(Metric::Rmse);
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0].points, (std::vector<QPointF>{{4, 0.25}, {5, 0.75}}));
  EXPECT_TRUE(std::isnan(curves[1].points[0].y())) << "a gap";
  EXPECT_EQ(curves[2].name, "fourth");
  EXPECT_NE(curves[0].color, curves[1].color);
}

TEST(SweepSeries, TellsCurvesApartWhenThePaletteIsAtItsEnd) {
  SweepSeries many;
  many.begin(std::vector<QString>(20, QStringLiteral("one")), {"Fan"}, {Metric::Rmse});
  for (std::size_t index = 0; index < many.count(); ++index) many.add(index, {frame(0, 1.0, 1.0)});
  const std::vector<Curve> curves = many.curves(Metric::Rmse);
  for (std::size_t a = 0; a < curves.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_TRUE(curves[a].color != curves[b].color || curves[a].dash != curves[b].dash)
          << a << " and " << b;
}

// The second has less error and more PSNR than all others.
TEST(SweepSeries, MarksTheFrontByWhatIsBetter) {
  const std::vector<ScatterPoint> points = series().tradeOff(Metric::Rmse, Metric::Psnr);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[1].value, QPointF(0.25, 45));
  EXPECT_EQ(points[2].index, 3u);
  EXPECT_FALSE(points[0].isOnFront);
  EXPECT_TRUE(points[1].isOnFront);
  EXPECT_FALSE(points[2].isOnFront);
}

TEST(SweepSeries, LeavesOutWhatHasNoPlace) {
  SweepSeries infinite = series();
  infinite.add(2, {frame(4, 0.0, std::numeric_limits<double>::infinity())});
  EXPECT_EQ(infinite.tradeOff(Metric::Rmse, Metric::Psnr).size(), 3u);
  EXPECT_EQ(infinite.tradeOff(Metric::Rmse, Metric::Rmse).size(), 4u);
}

TEST(SweepSeries, CopiesExactNumbers) {
  EXPECT_EQ(series().csv(),
            "settings,rmse,psnr\nfirst,0.5,25\n\"second, with a comma\",0.25,45\nfourth,1,10\n");
}

TEST(SweepSeries, ForgetsWhatWasKnown) {
  SweepSeries all = series();
  all.begin({"other"}, {"Fan"}, {Metric::Psnr});
  EXPECT_EQ(all.measuredCount(), 0u);
  EXPECT_EQ(all.csv(), "settings,psnr\n");
}

TEST(SweepSeries, KnowsTheSettingsAndTheSceneOfEachEntry) {
  const SweepSeries all = onTwoScenes();
  ASSERT_EQ(all.count(), 4u);
  EXPECT_EQ(all.settingsOf(2), 0u);
  EXPECT_EQ(all.sceneOf(2), 1u);
  EXPECT_EQ(all.name(2), "one");
  EXPECT_EQ(all.sceneName(all.sceneOf(2)), "Fence, far");
}

// 2 and 4 would be beaten by 0.25, which is of another scene.
TEST(SweepSeries, HasAFrontForEachScene) {
  const std::vector<ScatterPoint> points = onTwoScenes().tradeOff(Metric::Rmse, Metric::Psnr);
  ASSERT_EQ(points.size(), 4u);
  const bool expected[] = {false, true, true, false};
  for (std::size_t place = 0; place < 4; ++place) {
    EXPECT_EQ(points[place].isOnFront, expected[place]) << place;
    EXPECT_EQ(points[place].scene, place / 2);
    EXPECT_EQ(points[place].color, points[place % 2].color) << "the same settings, the same color";
  }
  EXPECT_EQ(points[2].name, "Fence, far · one");
  EXPECT_EQ(points[2].sceneName, "Fence, far");
}

TEST(SweepSeries, ShowsOneSceneByItself) {
  const SweepSeries all = onTwoScenes();
  const std::vector<ScatterPoint> points = all.tradeOff(Metric::Rmse, Metric::Psnr, 1);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].index, 2u);
  EXPECT_TRUE(points[0].isOnFront);
  const std::vector<Curve> curves = all.curves(Metric::Rmse, 1);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].name, "one");
  EXPECT_EQ(curves[0].points, (std::vector<QPointF>{{4, 2.0}}));
}

TEST(SweepSeries, TellsCurvesOfScenesApartByTheirDashes) {
  const std::vector<Curve> curves = onTwoScenes().curves(Metric::Rmse);
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(curves[2].name, "Fence, far · one");
  EXPECT_EQ(curves[0].color, curves[2].color);
  EXPECT_NE(curves[0].dash, curves[2].dash);
}

TEST(SweepSeries, NamesTheSceneOfEachLineWhereThereAreSeveral) {
  EXPECT_EQ(onTwoScenes().csv(), "scene,settings,rmse,psnr\nFan,one,0.5,20\nFan,other,0.25,30\n"
                                 "\"Fence, far\",one,2,10\n\"Fence, far\",other,4,5\n");
}

// Of the first settings of a scene it is known, and it is that of all.
TEST(SweepSeries, PutsTheLineOfSupersamplingBesideRmse) {
  SweepSeries all = onTwoScenes();
  FrameMetrics with = frame(4, 0.5, 20);
  with.at(Metric::Supersampling) = 0.125;
  all.add(0, {with});
  const std::vector<Curve> curves = all.curves(Metric::Rmse);
  ASSERT_EQ(curves.size(), 5u);
  EXPECT_EQ(curves[0].name, "Fan · supersampling");
  EXPECT_EQ(curves[0].points, (std::vector<QPointF>{{4, 0.125}}));
  EXPECT_EQ(curves[1].points, (std::vector<QPointF>{{4, 0.5}}));
  EXPECT_EQ(all.curves(Metric::Rmse, 0)[0].name, "supersampling");
  EXPECT_EQ(all.curves(Metric::Rmse, 1).size(), 2u) << "it is not known of that scene";
  EXPECT_EQ(all.curves(Metric::Psnr).size(), 4u);
}
