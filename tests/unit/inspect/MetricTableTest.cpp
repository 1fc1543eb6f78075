// The table of metrics and what is derived from it.
#include "core/measure/MetricTable.h"

#include "core/base/Error.h"
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

using taa::IntermediateId;
using taa::kMetrics;
using taa::Metric;
using taa::MetricInfo;

TEST(MetricTable, SaysWhatTheyAre) {
  std::set<std::string_view> ids, labels;
  for (std::size_t index = 0; index < kMetrics.size(); ++index) {
    const MetricInfo& info = kMetrics[index];
    EXPECT_EQ(static_cast<std::size_t>(info.metric), index) << info.id;
    EXPECT_TRUE(ids.insert(info.id).second) << info.id;
    EXPECT_TRUE(labels.insert(info.label).second) << info.label;
    EXPECT_TRUE(info.description.ends_with('.')) << info.id;
    EXPECT_LT(info.low, info.high) << info.id;
  }
}

TEST(MetricTable, NeedsWhatItsRowsNeed) {
  for (const MetricInfo& info : kMetrics) {
    if (info.row.empty()) {
      EXPECT_TRUE(info.needsReference && !info.isOverTime) << info.id << ": what else is it made of?";
      continue;
    }
    const auto id = taa::findIntermediate(info.row);
    ASSERT_TRUE(id) << info.row;
    EXPECT_EQ(taa::intermediate(*id).channels, 1) << info.row;
    EXPECT_EQ(taa::isOfReference(*id), info.isOverTime || info.needsReference) << info.row;
    EXPECT_EQ(taa::needsReference(*id), info.needsReference) << info.row;
    EXPECT_EQ(taa::isOverTime(*id), info.isOverTime) << info.row;
    EXPECT_EQ(taa::overTimeOf(info.metric), taa::overTime(*id)) << info.row;
  }
}

TEST(MetricTable, IsFoundByItsId) {
  for (const MetricInfo& info : kMetrics) {
    EXPECT_EQ(taa::findMetric(info.id), info.metric);
    EXPECT_EQ(taa::metricNamed(info.id), info.metric);
  }
  EXPECT_FALSE(taa::findMetric("mse"));
  try {
    taa::metricNamed("mse");
    FAIL();
  } catch (const taa::Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("\"mse\""), std::string::npos) << text;
    EXPECT_NE(text.find("relativeMse"), std::string::npos) << text;
  }
}

// Whoever orders pictures by a metric asks the table.
TEST(MetricTable, SaysOfWhichMoreIsBetter) {
  std::set<std::string_view> better;
  for (const MetricInfo& info : kMetrics)
    if (info.isHigherBetter) better.insert(info.id);
  EXPECT_EQ(better, (std::set<std::string_view>{"psnr", "rightlyKept", "ssim", "sharpness", "geometryKept"}));
}

TEST(MetricTable, AMapHasOneNumber) {
  EXPECT_EQ(taa::metricOfMap(IntermediateId::flip), Metric::Flip);
  EXPECT_EQ(taa::metricOfMap(IntermediateId::ssimMap), Metric::Ssim);
  EXPECT_EQ(taa::metricOfMap(IntermediateId::relativeError), Metric::RelativeMse);
  EXPECT_EQ(taa::metricOfMap(IntermediateId::ghost), Metric::GhostEnergy);
  EXPECT_EQ(taa::metricOfMap(IntermediateId::flicker), Metric::Flicker);
  EXPECT_FALSE(taa::metricOfMap(IntermediateId::framesFollowed));
  EXPECT_FALSE(taa::metricOfMap(IntermediateId::alpha)) << "that is not of the reference";
}

TEST(MetricTable, StandsInTheManual) {
  const std::string page = taa::readFile("resources/manual/metrics.md");
  for (const MetricInfo& info : kMetrics) {
    EXPECT_NE(page.find("`" + std::string(info.id) + "`"), std::string::npos) << info.id;
    if (!info.row.empty()) {
      EXPECT_NE(page.find("`" + std::string(info.row) + "`"), std::string::npos) << info.row;
    }
  }
}
