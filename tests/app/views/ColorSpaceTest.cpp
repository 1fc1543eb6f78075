// The color space plot: geometry of boxes and hull, projection, and turning it with mouse and keys.
#include "app/models/ColorSpaceMath.h"
#include "app/views/plots/ColorSpaceView.h"
#include "core/settings/Parameters.h"
#include "core/taa/twin/Color.h"

#include <QTest>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

struct Pixel {
  twin::PixelRecord record{};
  twin::Details details;
  Settings settings;

  Pixel() {
    details.isFirst = false;
    twin::Neighborhood& hood = details.neighborhood;
    for (std::size_t k = 0; k < 9; ++k)
      hood.samples[k] = {0.1f * static_cast<float>(k), 0.01f * static_cast<float>(k),
                         -0.02f * static_cast<float>(k)};
    hood.min = hood.samples[0];
    hood.max = hood.samples[8];
    std::swap(hood.min.z, hood.max.z);
    hood.mean = hood.samples[4];
    hood.deviation = glm::vec3(0.05f);
    hood.gamma = 2.0f;
    hood.boxMin = {0.3f, 0.0f, -0.1f};
    hood.boxMax = {0.5f, 0.08f, 0.0f};
    const auto set = [&](IntermediateId id, const glm::vec3& color) {
      twin::at(record, id) = glm::vec4(color, 0.0f);
    };
    set(IntermediateId::currentFiltered, {0.4f, 0.4f, 0.4f});
    set(IntermediateId::historyRaw, {0.9f, 0.2f, 0.1f});
    set(IntermediateId::historyRectified, {0.5f, 0.4f, 0.35f});
    set(IntermediateId::resolved, {0.48f, 0.4f, 0.36f});
    set(IntermediateId::clipAmount, glm::vec3(0.5f));
  }
  ColorScene scene(PlotSpace space, const std::vector<WhatIfRow>& rows = {}) const {
    return colorScene(record, details, settings, space, rows);
  }
};

void expectNear(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-5f)
      << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

} // namespace

TEST(ColorSpaceMath, ShowsBoxSpaceAsItIsAndAnotherTurned) {
  const Pixel pixel; // YCoCg by default
  const ColorScene own = pixel.scene(PlotSpace::YCoCg), rgb = pixel.scene(PlotSpace::Rgb);
  EXPECT_EQ(own.axes[0], "Y");
  EXPECT_EQ(rgb.axes[0], "R");
  const twin::Neighborhood& hood = pixel.details.neighborhood;
  expectNear(own.samples[5], hood.samples[5]);
  expectNear(own.box[0], hood.boxMin);
  expectNear(own.box[7], hood.boxMax);
  expectNear(own.variance[0], hood.mean - hood.gamma * hood.deviation);
  for (std::size_t k = 0; k < 9; ++k)
    expectNear(twin::toBox(rgb.samples[k], {ColorSpace::YCoCg, ToneSpace::Linear}), hood.samples[k]);
  ASSERT_TRUE(rgb.historyRaw);
  expectNear(*rgb.historyRaw, twin::compress({0.9f, 0.2f, 0.1f}, pixel.settings.space.tone));
}

// The printed way back belongs to the resolve, not to the plot.
TEST(ColorSpaceMath, CutsNothingOff) {
  Pixel pixel;
  pixel.settings.space = {ColorSpace::YCoCgAsPrinted, ToneSpace::Linear};
  twin::at(pixel.record, IntermediateId::historyRaw) = glm::vec4(4.0f, 2.0f, 1.0f, 0.0f);
  ASSERT_TRUE(pixel.scene(PlotSpace::Rgb).historyRaw);
  expectNear(*pixel.scene(PlotSpace::Rgb).historyRaw, {4.0f, 2.0f, 1.0f});
  expectNear(*pixel.scene(PlotSpace::YCoCg).historyRaw, {2.25f, 1.5f, -0.25f});
}

TEST(ColorSpaceMath, TheWayLeadsToWhatTheMethodAimsAt) {
  Pixel pixel;
  const twin::Neighborhood& hood = pixel.details.neighborhood;
  pixel.settings.rectify.method = RectifyMethod::ClipToCenter;
  ASSERT_TRUE(pixel.scene(PlotSpace::YCoCg).target);
  expectNear(*pixel.scene(PlotSpace::YCoCg).target, 0.5f * (hood.boxMin + hood.boxMax));
  pixel.settings.rectify.method = RectifyMethod::Clamp;
  EXPECT_FALSE(pixel.scene(PlotSpace::YCoCg).target) << "the nearest point has no ray";
  pixel.details.isFirst = true;
  EXPECT_FALSE(pixel.scene(PlotSpace::YCoCg).historyRaw);
}

TEST(ColorSpaceMath, TheHullOfACubeIsItsEdges) {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? 1.0f : 0.0f, i & 2 ? 1.0f : 0.0f, i & 4 ? 1.0f : 0.0f);
  std::set<std::array<int, 6>> edges; // of several planes that share an edge, once
  const auto directions = twin::slabDirections(RectifyMethod::ClipToHull, ColorSpace::YCoCg);
  for (const auto& [a, b] : hullEdges(corners, directions)) {
    const auto whole = [](float x) { return static_cast<int>(std::lround(x)); };
    EXPECT_NEAR(glm::distance(a, b), 1.0f, 1e-4f);
    const bool isOrdered = std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    const glm::vec3 p = isOrdered ? a : b, q = isOrdered ? b : a;
    edges.insert({whole(p.x), whole(p.y), whole(p.z), whole(q.x), whole(q.y), whole(q.z)});
  }
  EXPECT_EQ(edges.size(), 12u);
}

TEST(ColorSpaceMath, EveryPointOfTheHullIsInsideItsSlabs) {
  Pixel pixel;
  pixel.settings.rectify.method = RectifyMethod::ClipToHull;
  const ColorScene scene = pixel.scene(PlotSpace::YCoCg);
  EXPECT_FALSE(scene.hull.empty());
  for (const auto& edge : scene.hull)
    for (const glm::vec3& point : {edge.first, edge.second}) {
      EXPECT_GE(point.x, -1e-4f);
      EXPECT_LE(point.x, 0.8f + 1e-4f);
    }
}

TEST(ColorSpaceMath, TheSolidOfBothBoxesLiesInTheOneAndTheOther) {
  Pixel pixel;
  pixel.settings.space = {ColorSpace::YCoCg, ToneSpace::Linear};
  pixel.settings.rectify.method = RectifyMethod::ClipToBoth;
  for (const PlotSpace space : {PlotSpace::YCoCg, PlotSpace::Rgb}) {
    const ColorScene scene = pixel.scene(space);
    EXPECT_FALSE(scene.hull.empty());
    glm::vec3 low = scene.current, high = low;
    for (const glm::vec3& sample : scene.samples) low = glm::min(low, sample), high = glm::max(high, sample);
    for (const auto& edge : scene.hull)
      for (const glm::vec3& point : {edge.first, edge.second})
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_GE(point[axis], low[axis] - 1e-4f);
          EXPECT_LE(point[axis], high[axis] + 1e-4f);
        }
    ASSERT_TRUE(scene.target);
    expectNear(*scene.target, scene.current);
  }
}

TEST(ColorSpaceMath, ShowsTheTapsThatTheBoxIsOf) {
  Pixel pixel;
  EXPECT_TRUE(pixel.scene(PlotSpace::YCoCg).taps.empty());
  pixel.settings.neighborhood.shape = NeighborhoodShape::Varying;
  const glm::vec3 color(0.5f, 0.25f, 0.125f);
  pixel.details.neighborhood.members.assign(4, {color, 2});
  const ColorScene scene = pixel.scene(PlotSpace::YCoCg);
  ASSERT_EQ(scene.taps.size(), 4u);
  expectNear(scene.taps[3], twin::toBox(color, pixel.settings.space));
}

TEST(ColorSpaceMath, ProjectsAlongTheAxesAndKeepsLengths) {
  const SpaceTurn front{0, 0};
  const Projected up = projected({1, 0, 0}, front), right = projected({0, 1, 0}, front);
  EXPECT_NEAR(up.place.y, 1, 1e-12);
  EXPECT_NEAR(right.place.x, 1, 1e-12);
  EXPECT_NEAR(projected({0, 0, 1}, front).nearness, 1, 1e-12);
  EXPECT_NEAR(projected({0, 0, 1}, {std::numbers::pi / 2, 0}).place.x, 1, 1e-12);
  EXPECT_NEAR(projected({1, 0, 0}, {0.3, std::numbers::pi / 2}).nearness, 1, 1e-12) << "seen from above";
  for (const SpaceTurn& turn : {SpaceTurn{0.4, 0.2}, SpaceTurn{-2.0, 1.0}}) {
    const Projected some = projected({0.3, -0.5, 0.7}, turn);
    EXPECT_NEAR(glm::dot(some.place, some.place) + some.nearness * some.nearness, 0.83, 1e-12);
  }
  EXPECT_NEAR(turned({}, {0, 1e6}).pitch, std::numbers::pi / 2, 1e-12) << "no farther than from above";
}

TEST(ColorSpaceMath, TheRangeHoldsEverything) {
  Pixel pixel;
  WhatIfRow far;
  far.resolved = glm::vec3(9.0f);
  const ColorScene scene = pixel.scene(PlotSpace::Rgb, {far});
  const ColorRange range = rangeOf(scene);
  for (const glm::vec3& point : {scene.samples[0], scene.box[7], *scene.historyRaw, scene.variants.at(0)}) {
    const glm::dvec3 unit = range.unit(point);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(unit[axis], -1.0);
      EXPECT_LE(unit[axis], 1.0);
    }
  }
}

TEST(ColorSpaceView, TurnsWithMouseAndKeysAndTurnsBack) {
  ColorSpaceView view;
  view.resize(380, 560);
  view.setScene(Pixel().scene(PlotSpace::YCoCg));
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  const SpaceTurn first = view.turn();
  const glm::vec3 color = *view.scene()->historyRaw;
  const QPointF before = view.placeOf(color);
  QTest::mousePress(&view, Qt::LeftButton, {}, {150, 100});
  QTest::mouseMove(&view, {190, 90});
  QTest::mouseRelease(&view, Qt::LeftButton, {}, {190, 90});
  EXPECT_NEAR(view.turn().yaw, first.yaw + 0.4, 1e-9);
  EXPECT_NEAR(view.turn().pitch, first.pitch - 0.1, 1e-9);
  EXPECT_NE(view.placeOf(color), before);
  QTest::mouseMove(&view, {10, 10});
  EXPECT_NEAR(view.turn().yaw, first.yaw + 0.4, 1e-9) << "let go";
  QTest::mouseDClick(&view, Qt::LeftButton, {}, {150, 100});
  EXPECT_EQ(view.turn(), first);
  QTest::keyClick(&view, Qt::Key_Left);
  EXPECT_NEAR(view.turn().yaw, first.yaw - 5 * std::numbers::pi / 180, 1e-9);
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_NEAR(view.turn().yaw, first.yaw, 1e-9);
}

TEST(ColorSpaceView, NamesWhatIsUnderTheMouse) {
  ColorSpaceView view;
  view.resize(380, 560);
  view.setScene(Pixel().scene(PlotSpace::YCoCg));
  const QString text = view.textAt(view.placeOf(*view.scene()->historyRaw));
  EXPECT_TRUE(text.startsWith(QStringLiteral("history ("))) << text.toStdString();
  EXPECT_EQ(view.textAt({-100, -100}), QString());
  view.setScene({});
  EXPECT_EQ(view.textAt({100, 100}), QString());
}

TEST(ColorSpaceView, LabelsOfItsAxesStandApartHoweverItIsTurned) {
  ColorSpaceView view;
  view.resize(380, 560);
  EXPECT_TRUE(view.axisLabels().empty());
  view.setScene(Pixel().scene(PlotSpace::YCoCg));
  for (double yaw = -3.0; yaw < 3.0; yaw += 0.25)
    for (const double pitch : {-1.0, -0.3, 0.3, 1.0}) {
      view.setTurn({yaw, pitch});
      const std::vector<ChartLabel> labels = view.axisLabels();
      ASSERT_GT(labels.size(), 6u);
      EXPECT_EQ(labels[0].text + labels[1].text + labels[2].text, "YCoCg");
      for (std::size_t one = 3; one < labels.size(); ++one)
        for (std::size_t other = 0; other < one; ++other)
          EXPECT_FALSE(labels[one].place.intersects(labels[other].place))
              << labels[one].text.toStdString() << " and " << labels[other].text.toStdString();
    }
}

// History (0.9, 0.2, 0.1) and a box from (0.3, 0, −0.1) to (0.5, 0.08, 0), by hand: the nearest point of the
// box; and from its middle (0.4, 0.04, −0.05) a fifth of the way, what is below 0 made 0.
TEST(ColorSpace, ShowsWhereEachMethodPutsHistory) {
  Pixel pixel;
  pixel.settings.space = {ColorSpace::Rgb, ToneSpace::Linear};
  const auto pointOf = [](const ColorScene& scene, RectifyMethod method) {
    const std::string label(parameter("rectify.method").choices[static_cast<std::size_t>(method)].label);
    for (const RectifiedPoint& each : scene.byMethod)
      for (std::size_t at = each.methods.find(label); at != std::string::npos;
           at = each.methods.find(label, at + 1)) {
        const std::size_t end = at + label.size();
        if (end == each.methods.size() || each.methods[end] == ',') return each.point;
      }
    ADD_FAILURE() << label;
    return glm::vec3(-1.0f);
  };
  for (const RectifyMethod chosen : {RectifyMethod::Clamp, RectifyMethod::None}) {
    pixel.settings.rectify.method = chosen;
    const ColorScene scene = pixel.scene(PlotSpace::Rgb);
    expectNear(pointOf(scene, RectifyMethod::Clamp), {0.5f, 0.08f, 0.0f});
    expectNear(pointOf(scene, RectifyMethod::ClipToCenter), {0.5f, 0.072f, 0.0f});
  }
  pixel.details.isFirst = true;
  EXPECT_TRUE(pixel.scene(PlotSpace::Rgb).byMethod.empty()) << "there is no history";
}

TEST(ColorSpace, SamplesKeepTheirOwnColors) {
  Pixel pixel;
  pixel.settings.space = {ColorSpace::YCoCg, ToneSpace::Linear};
  const ColorScene scene = pixel.scene(PlotSpace::Rgb);
  for (int k = 0; k < 9; ++k) {
    const float y = 0.1f * static_cast<float>(k), co = 0.01f * static_cast<float>(k),
                cg = -0.02f * static_cast<float>(k);
    expectNear(scene.sampleColors[static_cast<std::size_t>(k)], {y + co - cg, y + cg, y - co - cg});
  }
}

TEST(ColorSpace, TicksAreRoundNumbersOnEachAxis) {
  const auto ticks = ticksOf(ColorRange{{0.0f, -0.25f, 0.0f}, {1.0f, 0.25f, 0.25f}}, 4);
  EXPECT_EQ(ticks[0].size(), 3u) << "0, 0.5, 1";
  ASSERT_EQ(ticks[1].size(), 3u);
  EXPECT_NEAR(ticks[1][0], -0.2, 1e-12);
  EXPECT_NEAR(ticks[1][1], 0.0, 1e-12);
  ASSERT_EQ(ticks[2].size(), 3u) << "0, 0.1, 0.2";
  EXPECT_NEAR(ticks[2][2], 0.2, 1e-12);
}

// Labels of ticks stand beside it, on the side away from the middle.
TEST(ColorSpace, TicksStandAtTheOutsideOfTheRangeHoweverItIsTurned) {
  const ColorRange range{{0.0f, -0.25f, 0.0f}, {1.0f, 0.25f, 0.25f}};
  for (const SpaceTurn turn : {SpaceTurn{}, SpaceTurn{2.0, 0.3}, SpaceTurn{-1.0, -0.5}, SpaceTurn{0.0, 0.0}})
    for (int axis = 0; axis < 3; ++axis) {
      const glm::vec3 begin = outerEdge(range, turn, axis);
      glm::vec3 end = begin;
      end[axis] = range.high[axis];
      const glm::dvec2 a = projected(range.unit(begin), turn).place;
      const glm::dvec2 b = projected(range.unit(end), turn).place;
      const auto side = [&](const glm::dvec2& of) {
        return (b.x - a.x) * (of.y - a.y) - (b.y - a.y) * (of.x - a.x);
      };
      const double middle = side({0.0, 0.0});
      for (const glm::vec3& corner : cornersOf(range))
        EXPECT_GE(side(projected(range.unit(corner), turn).place) * middle, -1e-6)
            << "axis " << axis << " at " << turn.yaw << ", " << turn.pitch;
    }
}
