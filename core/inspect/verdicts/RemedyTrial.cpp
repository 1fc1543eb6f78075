#include "core/inspect/verdicts/RemedyTrial.h"

#include "core/base/Say.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace taa {

namespace {

/// What a frame shows less what it should, three channels, as a screen is sent it.
Image shownErrors(const Image& resolved, const Image& reference) {
  Image errors(resolved.width, resolved.height, 3);
  for (int y = 0; y < errors.height; ++y)
    for (int x = 0; x < errors.width; ++x) {
      const glm::dvec3 error =
          shownValue(pixelColorAt(resolved, {x, y})) - shownValue(pixelColorAt(reference, {x, y}));
      for (int channel = 0; channel < 3; ++channel)
        errors.at(x, y)[channel] = static_cast<float>(error[channel]);
    }
  return errors;
}

double meanOfSquares(const glm::dvec3& value) {
  return glm::dot(value, value) / 3.0;
}

/// Sum of the lengths of luma's differences to the right and below, as shown.
double gradientSum(const Image& linear) {
  const auto luma = [&](int x, int y) {
    return glm::dot(shownValue(pixelColorAt(linear, {x, y})), glm::dvec3(0.2126, 0.7152, 0.0722));
  };
  double sum = 0.0;
  for (int y = 0; y + 1 < linear.height; ++y)
    for (int x = 0; x + 1 < linear.width; ++x)
      sum += std::hypot(luma(x + 1, y) - luma(x, y), luma(x, y + 1) - luma(x, y));
  return sum;
}

/// Sums up squares over frames.
struct SquareSums {
  double errors = 0.0, changes = 0.0;
  int errorCount = 0, changeCount = 0;
  void addTo(RemedyMeasure& measure) const {
    if (errorCount > 0) measure.error = std::sqrt(errors / errorCount);
    if (changeCount > 0) measure.flicker = std::sqrt(changes / changeCount);
  }
};

void addPicture(SquareSums& sums, const Image& errors, const std::optional<Image>& before) {
  double error = 0.0, change = 0.0;
  for (int y = 0; y < errors.height; ++y)
    for (int x = 0; x < errors.width; ++x) {
      error += meanOfSquares(pixelColorAt(errors, {x, y}));
      if (before) change += meanOfSquares(pixelColorAt(errors, {x, y}) - pixelColorAt(*before, {x, y}));
    }
  const double pixels = double(errors.width) * errors.height;
  sums.errors += error / pixels;
  ++sums.errorCount;
  if (!before) return;
  sums.changes += change / pixels;
  ++sums.changeCount;
}

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

TriedRemedy RemedyTrial::measure(const Remedy& remedy, const Progress& progress) {
  TriedRemedy tried{remedy, {}, {}};
  ShotState state = evidence_.state();
  state.lanes = {remedy.settings};
  SquareSums picture, pixel;
  std::optional<Image> errorsBefore;
  std::optional<glm::dvec3> pixelBefore;
  HistoryHandle history = historyBefore(progress);
  const int last = moments_.front().frame;
  FrameMaker& maker = player_.maker();
  for (int frame = first_; frame <= last; ++frame) {
    report(progress, say<"Trying remedies">(), frame - first_, last - first_ + 1);
    InputsHandle& inputs = inputs_[frame];
    if (!inputs) inputs = std::make_shared<LazyInputs>();
    ShownFrame made = maker.take();
    maker.make(state, {frame, {history}, {true}, false, {inputs}}, made);
    history = made.lanes[0].current;
    maker.recycle(std::move(made));
    if (frame <= last - kMeasuredFrames) continue;
    const Image resolved = history->color.download();
    const Image reference = evidence_.wholeReference(frame);
    Image errors = shownErrors(resolved, reference);
    addPicture(picture, errors, errorsBefore);
    const auto moment = std::ranges::find(moments_, frame, &SurfaceMoment::frame);
    if (moment != moments_.end()) {
      const glm::dvec3 error = pixelColorAt(errors, moment->pixel);
      pixel.errors += meanOfSquares(error);
      ++pixel.errorCount;
      if (pixelBefore) {
        pixel.changes += meanOfSquares(error - *pixelBefore);
        ++pixel.changeCount;
      }
      pixelBefore = error;
    }
    errorsBefore = std::move(errors);
    if (frame < last) continue;
    const double should = gradientSum(reference);
    tried.picture.sharpness = should > 0.0 ? gradientSum(resolved) / should : 1.0;
  }
  picture.addTo(tried.picture);
  pixel.addTo(tried.pixel);
  return tried;
}

} // namespace taa
