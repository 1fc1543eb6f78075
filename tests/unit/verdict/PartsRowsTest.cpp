// Rows of parts of the error, from rows of a resolve made by hand, and metrics of them.
#include "core/verdict/parts/PartsRows.h"

#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

using taa::ErrorPart;
using taa::ErrorParts;
using taa::Image;
using taa::IntermediateId;
using taa::Metric;
using taa::RowImages;

namespace {

Image filled(int channels, float value) {
  Image image(2, 1, channels);
  std::ranges::fill(image.pixels, value);
  return image;
}

RowImages resolveRows() {
  RowImages rows;
  for (const IntermediateId id :
       {IntermediateId::resolved, IntermediateId::currentFiltered, IntermediateId::alphaChannels,
        IntermediateId::historyRaw, IntermediateId::historyRectified})
    rows[id] = filled(3, 0.5f);
  for (const IntermediateId id : {IntermediateId::depthEdge, IntermediateId::rejectReason})
    rows[id] = filled(1, 0.0f);
  rows[IntermediateId::historyPosition] = filled(2, 0.5f);
  rows[IntermediateId::blendFactor] = filled(1, 0.25f);
  rows[IntermediateId::toneWeightCurrent] = filled(1, 0.5f);
  rows[IntermediateId::toneWeightHistory] = filled(1, 0.25f);
  return rows;
}

} // namespace

TEST(PartsRows, TakeTheShareOfTheCurrentColorAsItWasBlended) {
  taa::Settings settings;
  EXPECT_EQ(taa::partsInputs(resolveRows(), settings).alpha.pixels, filled(1, 0.25f).pixels);
  taa::applyAssignment(settings, "weight.source=contrastPerChannel");
  taa::applyAssignment(settings, "blend.tone=none");
  EXPECT_EQ(taa::partsInputs(resolveRows(), settings).alpha.pixels, filled(3, 0.5f).pixels);
  taa::applyAssignment(settings, "blend.tone=luma");
  // ½·½ / (½·½ + ½·¼)
  EXPECT_EQ(taa::partsInputs(resolveRows(), settings).alpha.pixels, filled(3, 0.25f / 0.375f).pixels);
}

TEST(PartsRows, AreTheLumaOfEachPartAndBothMaps) {
  ErrorParts parts;
  for (std::size_t part = 0; part < taa::kErrorParts; ++part)
    parts.images[part] = filled(3, static_cast<float>(part) / 8.0f);
  const RowImages rows = taa::partsRows(parts, resolveRows(), filled(3, 0.9f), {});
  const auto value = [&](IntermediateId id) { return rows.at(id).pixels[0]; };
  EXPECT_EQ(value(IntermediateId::errorGhost), 0.0f);
  EXPECT_FLOAT_EQ(value(IntermediateId::errorLag), 1.0f / 8.0f);
  EXPECT_FLOAT_EQ(value(IntermediateId::errorBlur), 2.0f / 8.0f);
  EXPECT_FLOAT_EQ(value(IntermediateId::errorAliasing), 3.0f / 8.0f);
  EXPECT_FLOAT_EQ(value(IntermediateId::errorOlder), 4.0f / 8.0f);
  EXPECT_FLOAT_EQ(value(IntermediateId::errorRectification), 5.0f / 8.0f);
  EXPECT_EQ(value(IntermediateId::verdictMap), 2.0f) << "history is off and was kept";
  EXPECT_EQ(value(IntermediateId::geometryVerdict), 0.0f) << "history starts";
  for (const taa::Intermediate& row : taa::kIntermediates)
    EXPECT_EQ(rows.contains(row.id), taa::overTime(row.id) == taa::OverTime::Parts) << row.name;
}

TEST(PartsRows, MetricsAreMeansOfAmountsAndSharesOfCategories) {
  RowImages rows;
  rows[IntermediateId::errorGhost] = Image(4, 1, 1);
  rows[IntermediateId::errorGhost].pixels = {-0.5f, 0.25f, 0.0f, 0.25f};
  EXPECT_EQ(taa::metricOverTime(Metric::ErrorGhost, rows), 0.25);
  rows[IntermediateId::verdictMap] = Image(8, 1, 1);
  rows[IntermediateId::verdictMap].pixels = {0, 1, 2, 2, 3, 0, 2, 0};
  EXPECT_EQ(taa::metricOverTime(Metric::RightlyKept, rows), 37.5);
  EXPECT_EQ(taa::metricOverTime(Metric::HistoryRemoved, rows), 12.5);
  EXPECT_EQ(taa::metricOverTime(Metric::HistoryLetThrough, rows), 37.5);
  EXPECT_EQ(taa::metricOverTime(Metric::HistoryThrownAway, rows), 12.5);
  rows[IntermediateId::geometryVerdict] = Image(4, 1, 1);
  rows[IntermediateId::geometryVerdict].pixels = {1, 1, 3, 0};
  EXPECT_EQ(taa::metricOverTime(Metric::GeometryKept, rows), 25.0);
  EXPECT_EQ(taa::metricOverTime(Metric::GeometryRemoved, rows), 50.0);
  EXPECT_EQ(taa::metricOverTime(Metric::GeometryLetThrough, rows), 0.0);
  EXPECT_EQ(taa::metricOverTime(Metric::GeometryThrownAway, rows), 25.0);
}

TEST(PartsRows, EachPartHasItsMetric) {
  for (const taa::Intermediate& row : taa::kIntermediates) {
    if (!taa::isOverTime(row.id)) continue;
    const bool isPart = taa::overTime(row.id) == taa::OverTime::Parts && row.visual == taa::Visual::Signed;
    const bool isShown = row.id == IntermediateId::flicker || row.id == IntermediateId::deviationOverTime ||
                         row.id == IntermediateId::ghost;
    const auto number = taa::metricOfMap(row.id);
    ASSERT_EQ(number.has_value(), isPart || isShown) << row.name;
    if (!number) continue;
    EXPECT_EQ(taa::metricInfo(*number).row, row.name);
    EXPECT_EQ(taa::overTimeOf(*number), taa::overTime(row.id));
  }
}
