// What remedies are held against: the figures of the present settings are those of the metrics.
#include "core/inspect/overtime/MetricCursor.h"
#include "tests/support/SmallInspector.h"

#include <cmath>

using taa::Metric;
using namespace taa::test::small;

namespace {

constexpr int kFrame = 12;

/// Root of the mean square.
class MeanSquare {
 public:
  void add(double value) {
    sum_ += value * value;
    ++count_;
  }
  double root() const { return std::sqrt(sum_ / count_); }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

} // namespace

class RemediesOnScenesTest : public InspectorTest {};

// Of the last four frames, and of what happens between them. Without dilation history is read where the
// motion vectors point.
TEST_F(RemediesOnScenesTest, MeasureThePictureAsTheMetricsDo) {
  taa::Settings settings; // history is kept wherever it comes from
  for (const char* assignment :
       {"dilate.method=none", "rectify.method=none", "validate.depth=off", "output.sharpen=none"})
    taa::applyAssignment(settings, assignment);
  const auto inspector = opened();
  inspector->shot().setSettings(settings);
  inspector->shot().seek(kFrame);
  MeanSquare errors, ghosts;
  taa::MetricCursor cursor;
  for (int frame = kFrame - 3; frame <= kFrame; ++frame) {
    const taa::FrameMetrics metrics = inspector->metrics().measureFrame(
        frame, {Metric::Rmse, Metric::GhostEnergy}, taa::kVerdictSamples, cursor);
    errors.add(*metrics.at(Metric::Rmse));
    if (frame > kFrame - 3) ghosts.add(*metrics.at(Metric::GhostEnergy));
  }
  const taa::RemedyAnswer answer =
      inspector->verdicts().remedies({.frame = kFrame, .pixel = {kWidth / 2, kHeight / 2}}, {});
  ASSERT_TRUE(answer.picture);
  EXPECT_EQ(answer.tried, 0) << "nothing was said to be wrong";
  EXPECT_NEAR(answer.picture->error, errors.root(), 1e-6);
  EXPECT_NEAR(answer.picture->ghost, ghosts.root(), 1e-6);
  EXPECT_GT(answer.picture->ghost, 0.01) << "the blades leave trails";
}
