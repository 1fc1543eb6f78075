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
  std::optional<glm::dvec3> pixel; ///< its error, where the surface was seen
};

} // namespace

RemedyTrial::RemedyTrial(ShotPlayer& player, EvidenceFrames& evidence,
                         const std::vector<SurfaceMoment>& moments, int first)
    : player_(player), evidence_(evidence), moments_(moments), first_(first) {}

HistoryHandle RemedyTrial::historyBefore(const Progress& progress) {
  if (before_ || startsHistory(evidence_.state(), first_)) return before_;
  TraceCursor cursor;
  ShownFrame made = player_.makeInBackground(first_ - 1, cursor, progress, evidence_.lane());
  before_ = made.lanes[0].current;
  player_.maker().recycle(std::move(made));
  return before_;
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

TriedRemedy RemedyTrial::measure(const Remedy& remedy, const Progress& progress) {
  TriedRemedy tried{remedy, {}, {}};
  ShotState state = evidence_.state();
  state.lanes = {remedy.settings};
  SquareSums picture, pixel;
  std::optional<Measured> before;
  HistoryHandle history = historyBefore(progress);
  const int last = moments_.front().frame;
  for (int frame = first_; frame <= last; ++frame) {
    report(progress, say<"Trying remedies">(), frame - first_, last - first_ + 1);
    history = resolve(state, frame, history);
    if (frame <= last - kMeasuredFrames) continue;
    const Truth& should = truth(frame);
    Measured now{shownColors(history->color.download()), {}, {}};
    now.errors = shownErrors(now.shown, should.shown);
    const auto moment = std::ranges::find(moments_, frame, &SurfaceMoment::frame);
    if (moment != moments_.end()) now.pixel = pixelColorAt(now.errors, moment->pixel);
    picture.add(meanOfSquares(now.errors));
    if (now.pixel) pixel.add(meanOfSquares(*now.pixel));
    if (before) {
      const Image ghosts = ghostMap({now.shown, should.shown, before->shown, should.historyPositionPx});
      picture.add(meanOfSquares(shownErrors(now.errors, before->errors)), meanOfSquares(ghosts));
      if (now.pixel && before->pixel) pixel.add(meanOfSquares(*now.pixel - *before->pixel), 0.0);
    }
    if (frame == last && should.gradients > 0.0)
      tried.picture.sharpness = gradientSum(now.shown) / should.gradients;
    before = std::move(now);
  }
  picture.addTo(tried.picture);
  pixel.addTo(tried.pixel);
  return tried;
}

} // namespace taa
