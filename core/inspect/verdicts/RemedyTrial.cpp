#include "core/inspect/verdicts/RemedyTrial.h"

#include "core/base/Say.h"
#include "core/measure/Metrics.h"
#include "core/measure/compare/GhostEnergy.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace taa {

namespace {

/// What a frame shows less what it should, three channels.
Image shownErrors(const Image& shown, const Image& reference) {
  Image errors(shown.width, shown.height, 3);
  std::ranges::transform(shown.pixels, reference.pixels, errors.pixels.begin(), std::minus<float>());
  return errors;
}

/// Where the motion vectors of the inputs point, px of the picture.
Image historyPositions(const FrameInputs& inputs) {
  const Image motion = inputs.motion.download();
  const glm::vec2 perInput =
      glm::vec2(inputs.outputWidth(), inputs.outputHeight()) / glm::vec2(inputs.width(), inputs.height());
  Image positions(inputs.outputWidth(), inputs.outputHeight(), 2);
  for (int y = 0; y < positions.height; ++y)
    for (int x = 0; x < positions.width; ++x) {
      const glm::vec2 center(float(x) + 0.5f, float(y) + 0.5f), place = center / perInput;
      const float* way = motion.at(std::min(static_cast<int>(place.x), motion.width - 1),
                                   std::min(static_cast<int>(place.y), motion.height - 1));
      positions.at(x, y)[0] = center.x - way[0] * perInput.x;
      positions.at(x, y)[1] = center.y - way[1] * perInput.y;
    }
  return positions;
}

double meanOfSquares(const glm::dvec3& value) {
  return glm::dot(value, value) / 3.0;
}

/// Sum of the lengths of luma's differences to the right and below.
double gradientSum(const Image& shown) {
  const auto luma = [&](int x, int y) {
    return glm::dot(pixelColorAt(shown, {x, y}), glm::dvec3(0.2126, 0.7152, 0.0722));
  };
  double sum = 0.0;
  for (int y = 0; y + 1 < shown.height; ++y)
    for (int x = 0; x + 1 < shown.width; ++x)
      sum += std::hypot(luma(x + 1, y) - luma(x, y), luma(x, y + 1) - luma(x, y));
  return sum;
}

/// Sums up squares over frames.
struct SquareSums {
  double errors = 0.0, changes = 0.0, ghosts = 0.0;
  int errorCount = 0, changeCount = 0;
  void add(double error) {
    errors += error;
    ++errorCount;
  }
  void add(double change, double ghost) {
    changes += change;
    ghosts += ghost;
    ++changeCount;
  }
  void addTo(RemedyMeasure& measure) const {
    if (errorCount > 0) measure.error = std::sqrt(errors / errorCount);
    if (changeCount == 0) return;
    measure.flicker = std::sqrt(changes / changeCount);
    measure.ghost = std::sqrt(ghosts / changeCount);
  }
};

double meanOfSquares(const Image& values) {
  double sum = 0.0;
  for (const float value : values.pixels) sum += double(value) * double(value);
  return sum / static_cast<double>(values.pixels.size());
}

/// A frame that was measured, which the next one is held against.
struct Measured {
  Image shown, errors;
};

} // namespace

RemedyTrial::RemedyTrial(ShotPlayer& player, EvidenceFrames& evidence, int last, int first,
                         const Progress& progress)
    : player_(player), evidence_(evidence), last_(last), first_(first), progress_(progress) {}

HistoryHandle RemedyTrial::historyBefore() {
  if (before_ || startsHistory(evidence_.state(), first_)) return before_;
  TraceCursor cursor;
  ShownFrame made = player_.makeInBackground(first_ - 1, cursor, progress_, evidence_.lane());
  before_ = made.lanes[0].current;
  player_.maker().recycle(std::move(made));
  return before_;
}

void RemedyTrial::follow(const glm::ivec2& pixel) {
  moments_ = evidence_.moments(last_, pixel, std::min(kMeasuredFrames, last_ - first_ + 1));
  std::map<int, glm::ivec2> wanted;
  for (const SurfaceMoment& moment : moments_) wanted[moment.frame] = moment.pixel;
  parts_ = std::make_unique<PartlyResolved>(evidence_.state(), first_, wanted, progress_);
}

RemedyMeasure RemedyTrial::ofPixel(const Settings& settings) {
  const std::map<int, glm::dvec3> colors =
      parts_->colors(player_.maker().pass, historyBefore(), settings, progress_);
  SquareSums sums;
  std::optional<glm::dvec3> before;
  for (auto moment = moments_.rbegin(); moment != moments_.rend(); ++moment) {
    const glm::dvec3 reference = pixelColorAt(evidence_.reference(moment->frame), moment->pixel);
    const glm::dvec3 error = shownValue(colors.at(moment->frame)) - shownValue(reference);
    sums.add(meanOfSquares(error));
    if (before) sums.add(meanOfSquares(error - *before), 0.0);
    before = error;
  }
  RemedyMeasure measure;
  sums.addTo(measure);
  return measure;
}

HistoryHandle RemedyTrial::resolve(const ShotState& state, int frame, const HistoryHandle& previous) {
  InputsHandle& inputs = inputs_[frame];
  if (!inputs) inputs = std::make_shared<LazyInputs>();
  FrameMaker& maker = player_.maker();
  ShownFrame made = maker.take();
  maker.make(state, {frame, {previous}, {true}, false, {inputs}}, made);
  HistoryHandle left = made.lanes[0].current;
  maker.recycle(std::move(made));
  return left;
}

const RemedyTrial::Truth& RemedyTrial::truth(int frame) {
  const auto known = truths_.find(frame);
  if (known != truths_.end()) return known->second;
  Truth truth{shownColors(evidence_.wholeReference(frame)), historyPositions(inputs_.at(frame)->textures),
              0.0};
  truth.gradients = gradientSum(truth.shown);
  return truths_[frame] = std::move(truth);
}

RemedyMeasure RemedyTrial::ofPicture(const Settings& settings) {
  ShotState state = evidence_.state();
  state.lanes = {settings};
  RemedyMeasure measure;
  SquareSums sums;
  std::optional<Measured> before;
  HistoryHandle history = historyBefore();
  for (int frame = first_; frame <= last_; ++frame) {
    report(progress_, say<"Measuring what remedies cost">(), frame - first_, last_ - first_ + 1);
    history = resolve(state, frame, history);
    if (frame <= last_ - kMeasuredFrames) continue;
    const Truth& should = truth(frame);
    Measured now{shownColors(history->color.download()), {}};
    now.errors = shownErrors(now.shown, should.shown);
    sums.add(meanOfSquares(now.errors));
    if (before) {
      const Image ghosts = ghostMap({now.shown, should.shown, before->shown, should.historyPositionPx});
      sums.add(meanOfSquares(shownErrors(now.errors, before->errors)), meanOfSquares(ghosts));
    }
    if (frame == last_ && should.gradients > 0.0)
      measure.sharpness = gradientSum(now.shown) / should.gradients;
    before = std::move(now);
  }
  sums.addTo(measure);
  return measure;
}

} // namespace taa
