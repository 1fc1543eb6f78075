// Plays scenes for tests and compares them with the CPU twin.
#include "tests/support/frames/Frames.h"

#include "core/probe/TwinInputs.h"
#include "core/report/VerificationReport.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/CompareImages.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace taa::test {
namespace {

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

Verification verified(twin::Inputs inputs, const Settings& settings, const std::vector<Image>& pictures) {
  inputs.resolved = pictures[static_cast<std::size_t>(IntermediateId::resolved)];
  FrameVerifier verifier;
  verifier.add(inputs, settings, 0, allRows(), pictures);
  return verifier.verification();
}

std::string outsideText(const Verification& verification) {
  std::string text;
  for (const std::string& line : outsideSentences(verification)) text += line + "\n";
  return text;
}

std::string differenceFromTwin(twin::Inputs inputs, const Settings& settings,
                               const std::vector<Image>& pictures, bool exact) {
  if (!exact) return outsideText(verified(std::move(inputs), settings, pictures));
  inputs.resolved = pictures[static_cast<std::size_t>(IntermediateId::resolved)];
  const std::vector<Image> expected = twinPictures(inputs, settings);
  std::string first, others;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::string name(kResolveRows[i].name);
    if (compare(pictures[i], expected[i]).agrees) continue;
    if (first.empty())
      first = name + ": " + difference(pictures[i], expected[i]);
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
