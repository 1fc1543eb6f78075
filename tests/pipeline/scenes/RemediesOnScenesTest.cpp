// What is said of remedies: the figures of the present settings are those of the metrics, and those of a
// remedy what the program shows with it.
#include "core/inspect/MetricCursor.h"
#include "core/inspect/RemedyTrial.h"
#include "core/settings/Faults.h"
#include "tests/support/SmallInspector.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <future>
#include <string>

using taa::IntermediateId;
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

/// What the screen is sent less what it should be, of the frame on show.
taa::Image errorsOnShow(taa::Inspector& inspector) {
  inspector.reference().refine(taa::kVerdictSamples);
  taa::Image errors = taa::shownColors(inspector.views().image(IntermediateId::resolved));
  const taa::Image reference = taa::shownColors(inspector.views().image(IntermediateId::reference));
  std::ranges::transform(errors.pixels, reference.pixels, errors.pixels.begin(), std::minus<float>());
  return errors;
}

/// Against the reference: the picture of the last four frames and between them, its sharpness in the last
/// one, and a pixel of that.
struct Shown {
  double picture = 0.0, errorChange = 0.0, flicker = 0.0, ghost = 0.0, sharpness = 0.0, pixel = 0.0;
};

Shown shownWith(const taa::Settings& settings, const taa::VerdictQuestion& question) {
  const auto make = [&] {
    taa::Inspector inspector;
    inspector.shot().setSize(kWidth, kHeight);
    inspector.shot().setSettings(settings);
    inspector.shot().open("builtin:fan");
    inspector.overTime().setFrames(taa::kMeasuredFrames);
    MeanSquare errors, changes, ghosts;
    Shown shown;
    taa::Image before;
    taa::MetricCursor cursor;
    for (int frame = question.frame - 3; frame <= question.frame; ++frame) {
      const taa::FrameMetrics metrics = inspector.metrics().measureFrame(
          frame, {Metric::Rmse, Metric::GhostEnergy, Metric::Sharpness, Metric::Flicker},
          taa::kVerdictSamples, cursor);
      inspector.shot().seek(frame);
      const taa::Image now = errorsOnShow(inspector);
      for (std::size_t at = 0; at < before.pixels.size(); ++at)
        changes.add(double(now.pixels[at]) - double(before.pixels[at]));
      if (frame > question.frame - 3) ghosts.add(*metrics.at(Metric::GhostEnergy));
      errors.add(*metrics.at(Metric::Rmse));
      shown.sharpness = *metrics.at(Metric::Sharpness);
      shown.flicker = metrics.at(Metric::Flicker).value_or(0.0);
      before = now;
    }
    shown.picture = errors.root();
    shown.errorChange = changes.root();
    shown.ghost = ghosts.root();
    const taa::PixelError error = inspector.verdicts().of(question).error;
    const glm::dvec3 off = taa::shownValue(error.resolved) - taa::shownValue(error.reference);
    shown.pixel = std::sqrt(glm::dot(off, off) / 3.0);
    return shown;
  };
  return std::async(std::launch::async, make).get(); // a thread has one context
}

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
  inspector->overTime().setFrames(taa::kMeasuredFrames);
  MeanSquare errors, ghosts;
  double flicker = 0.0;
  taa::MetricCursor cursor;
  for (int frame = kFrame - 3; frame <= kFrame; ++frame) {
    const taa::FrameMetrics metrics = inspector->metrics().measureFrame(
        frame, {Metric::Rmse, Metric::GhostEnergy, Metric::Flicker}, taa::kVerdictSamples, cursor);
    flicker = metrics.at(Metric::Flicker).value_or(0.0);
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
  EXPECT_NEAR(answer.picture->flicker, flicker, 1e-6);
  EXPECT_GT(flicker, 0.001);
}

// History comes from half a picture away, everywhere; of the pixel that this harms most.
TEST_F(RemediesOnScenesTest, TakeAnInjectedFaultOut) {
  taa::Settings settings;
  taa::applyAssignment(settings, "fault.motionUnit=biased");
  const auto inspector = opened();
  inspector->shot().seek(kFrame);
  const taa::Image healthy = errorsOnShow(*inspector);
  inspector->shot().setSettings(settings);
  inspector->shot().seek(kFrame);
  const taa::Image faulty = errorsOnShow(*inspector);
  taa::VerdictQuestion question{.frame = kFrame};
  float most = 0.0f;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float harm = std::abs(faulty.at(x, y)[1]) - std::abs(healthy.at(x, y)[1]);
      if (harm <= most) continue;
      most = harm;
      question.pixel = {x, y};
    }
  EXPECT_GT(most, 0.1f);
  const taa::VerdictAnswer verdict = inspector->verdicts().of(question);
  const taa::RemedyAnswer answer = inspector->verdicts().remedies(question, verdict);
  ASSERT_FALSE(answer.best.empty()) << verdict.sentence;
  EXPECT_FALSE(taa::isFaulty(answer.best.front().remedy.settings))
      << testing::PrintToString(answer.best.front().remedy.changes);
}

// From frame 0 on in a program of its own, as `taa-batch metrics --set` measures it.
TEST_F(RemediesOnScenesTest, SayWhatTheProgramShowsWithThem) {
  taa::Settings settings; // a trail behind what moves
  settings.rectify.method = taa::RectifyMethod::None;
  settings.validate.depth = taa::Switch::Off;
  settings.dilate.method = taa::DilateMethod::None; // history is read where ghosts are looked for
  settings.output.sharpen = taa::Sharpen::None;
  const taa::VerdictQuestion question{.frame = 14, .pixel = {15, 6}};
  const auto inspector = opened({settings});
  const taa::VerdictAnswer verdict = inspector->verdicts().of(question);
  const taa::RemedyAnswer answer = inspector->verdicts().remedies(question, verdict);
  ASSERT_FALSE(answer.best.empty());
  const auto readsAsBefore = [&](const taa::TriedRemedy& one) {
    return one.remedy.settings.reproject.method == taa::ReprojectMethod::Motion &&
           one.remedy.settings.dilate.method == taa::DilateMethod::None;
  };
  const auto found = std::ranges::find_if(answer.best, readsAsBefore);
  ASSERT_NE(found, answer.best.end());
  const taa::TriedRemedy& first = *found;
  EXPECT_LT(first.pixel.latest, answer.pixel.latest);
  for (const std::string& change : first.remedy.changes) applyAssignment(settings, change);
  const Shown shown = shownWith(settings, question);
  ASSERT_TRUE(first.picture);
  EXPECT_NEAR(first.picture->error, shown.picture, 1e-6);
  EXPECT_NEAR(first.picture->errorChange, shown.errorChange, 1e-6);
  EXPECT_NEAR(first.picture->flicker, shown.flicker, 1e-6);
  EXPECT_NEAR(first.picture->sharpness, shown.sharpness, 1e-6);
  EXPECT_NEAR(first.pixel.latest, shown.pixel, 1e-6);
  EXPECT_NEAR(first.picture->ghost, shown.ghost, 1e-6);
}
