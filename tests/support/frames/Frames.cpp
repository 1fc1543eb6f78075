// Plays scenes for tests and compares them with the CPU twin.
#include "tests/support/frames/Frames.h"

#include "core/probe/TwinInputs.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/CompareImages.h"

#include <algorithm>
#include <cstddef>
#include <memory>

namespace taa::test {
namespace {

/// On a GPU one value of as many pixels may be decided differently by a comparison.
constexpr double kPixelsPerOutlier = 500.0;

Limits limitsOfRow(const Intermediate& row, bool isExact) {
  Limits limits = limitsOf(isExact, row.tolerance);
  if (!isExact) limits.outliers = 1.0 / (kPixelsPerOutlier * row.channels);
  return limits;
}

/// What the twin says of every pixel, in the table's order.
std::vector<Image> twinPictures(const twin::Inputs& inputs, const Settings& settings) {
  std::vector<Image> images;
  for (const Intermediate& row : kResolveRows)
    images.emplace_back(inputs.outputWidth(), inputs.outputHeight(), row.channels);
  for (int y = 0; y < inputs.outputHeight(); ++y)
    for (int x = 0; x < inputs.outputWidth(); ++x) {
      const twin::PixelRecord record = twin::resolvePixel(inputs, settings, x, y);
      for (std::size_t row = 0; row < images.size(); ++row)
        std::copy_n(&record[row].x, images[row].channels, images[row].at(x, y));
    }
  return images;
}

} // namespace

twin::Inputs twinInputs(const FrameInputs& inputs, const History* previous) {
  return taa::twinInputs(inputs, previous, TwinReading::Whole);
}

std::string differenceFromTwin(twin::Inputs inputs, const Settings& settings,
                               const std::vector<Image>& pictures, bool exact) {
  inputs.resolved = pictures[static_cast<std::size_t>(IntermediateId::resolved)];
  const std::vector<Image> expected = twinPictures(inputs, settings);
  std::string first, others;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Intermediate& row = kResolveRows[i];
    const Limits limits = limitsOfRow(row, exact);
    if (compare(pictures[i], expected[i], limits).agrees) continue;
    const std::string name(row.name);
    if (first.empty())
      first = name + ": " + difference(pictures[i], expected[i], limits);
    else
      others += " " + name;
  }
  return others.empty() ? first : first + "; other rows that differ:" + others;
}

void Accumulator::resolve(TaaPass& pass, const FrameInputs& inputs, const Settings& settings,
                          ExposedRows* exposedRows) {
  hadHistory_ = !inputs.info.startsHistory;
  current_ = 1 - current_;
  fitHistory(histories_[current_], inputs.outputWidth(), inputs.outputHeight(), settings);
  pass.resolve(inputs, previous(), settings, histories_[current_], exposedRows);
}

Player::Player(const std::string& source, const std::string& camera, int width, int height,
               const Settings& settings)
    : settings_(settings), renderer_(std::make_shared<const Scene>(openScene(source))) {
  request_.camera = camera;
  request_.width = width;
  request_.height = height;
  request_.jitter = settings.jitter;
  request_.inputs = settings.inputs;
}

void Player::draw() {
  renderer_.draw(request_, ++frame_, inputs_);
}

void Player::step(TaaPass& pass, ExposedRows* exposedRows) {
  draw();
  accumulator_.resolve(pass, inputs_, settings_, exposedRows);
}

} // namespace taa::test
