// The line that convergence is seen beside: how far off as many samples are as there were frames since
// history started.
#include "core/inspect/MetricCursor.h"
#include "core/measure/Metrics.h"
#include "tests/support/SmallInspector.h"

#include <gtest/gtest.h>

#include <optional>

using taa::Image;
using taa::Inspector;
using taa::IntermediateId;
using taa::Metric;

namespace {

constexpr int kSamples = 32;

/// RMSE of a reference of so many samples against that of kSamples, which is there afterwards.
double errorOf(Inspector& inspector, int samples) {
  const auto made = [&](int count) {
    inspector.reference().refine(count);
    return inspector.views().image(IntermediateId::reference);
  };
  const Image few = made(samples);
  return taa::pictureError(few, made(kSamples)).rmse;
}

std::optional<double> lineOf(Inspector& inspector) {
  return inspector.metrics().measure({Metric::Supersampling}).at(Metric::Supersampling);
}

class SupersamplingTest : public taa::test::small::InspectorTest {};

} // namespace

TEST_F(SupersamplingTest, IsTheErrorOfTheMeanOfASampleAFrame) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  const double expected = errorOf(*inspector, 6);
  EXPECT_GT(expected, 0.0);
  EXPECT_EQ(lineOf(*inspector), expected);
  EXPECT_EQ(inspector->reference().samples(), kSamples) << "the reference stays";
}

TEST_F(SupersamplingTest, BeginsAnewWithHistory) {
  const auto inspector = opened();
  inspector->shot().setRestarts({2});
  inspector->shot().seek(5);
  const double expected = errorOf(*inspector, 4);
  EXPECT_EQ(lineOf(*inspector), expected);
}

TEST_F(SupersamplingTest, IsNothingFromAsManyAsTheReferenceHas) {
  const auto inspector = opened();
  inspector->shot().seek(kSamples - 1);
  EXPECT_FALSE(lineOf(*inspector)) << "there is no reference yet";
  inspector->reference().refine(kSamples);
  EXPECT_EQ(lineOf(*inspector), 0.0);
}

TEST_F(SupersamplingTest, IsTheSameBesideTheFrameOnShow) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  const double expected = errorOf(*inspector, 6);
  inspector->shot().seek(2);
  taa::MetricCursor cursor;
  const taa::FrameMetrics metrics =
      inspector->metrics().measureFrame(5, {Metric::Rmse, Metric::Supersampling}, kSamples, cursor);
  EXPECT_EQ(metrics.at(Metric::Supersampling), expected);
  EXPECT_EQ(inspector->shot().frame(), 2);
}
