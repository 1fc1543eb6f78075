// Plays scenes for tests and compares them with the CPU twin.
#include "tests/support/frames/Frames.h"

#include "core/probe/TwinInputs.h"
#include "core/scene/SceneSource.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>

namespace taa::test {
namespace {

/// On a GPU one pixel in this many may be decided differently by a comparison.
constexpr std::size_t kPixelsPerOutlier = 500;

bool agrees(float is, float want, float tolerance, bool exact) {
  if (std::isnan(is) && std::isnan(want)) return true;
  if (exact) return std::bit_cast<std::uint32_t>(is) == std::bit_cast<std::uint32_t>(want);
  return is == want || std::fabs(is - want) <= tolerance * std::max(1.0f, std::fabs(want));
}

std::string describe(const Intermediate& row, int x, int y, int channel, float is, float want) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), "%.*s channel %d at (%d, %d) is %.9g (%a), the twin says %.9g (%a)",
                static_cast<int>(row.name.size()), row.name.data(), channel, x, y, static_cast<double>(is),
                static_cast<double>(is), static_cast<double>(want), static_cast<double>(want));
  return text.data();
}

} // namespace

twin::Inputs twinInputs(const FrameInputs& inputs, const History* previous) {
  return taa::twinInputs(inputs, previous, TwinReading::Whole);
}

std::string differenceFromTwin(twin::Inputs inputs, const Settings& settings,
                               const std::vector<Image>& pictures, bool exact) {
  inputs.resolved = pictures[static_cast<std::size_t>(IntermediateId::resolved)];
  std::string first;
  std::array<std::size_t, kResolveRowCount> outliers{};
  for (int y = 0; y < inputs.outputHeight(); ++y) {
    for (int x = 0; x < inputs.outputWidth(); ++x) {
      const twin::PixelRecord record = twin::resolvePixel(inputs, settings, x, y);
      for (std::size_t i = 0; i < kResolveRowCount; ++i) {
        const Intermediate& row = kResolveRows[i];
        for (int channel = 0; channel < row.channels; ++channel) {
          const float is = pictures[i].at(x, y)[channel];
          const float want = record[i][channel];
          if (agrees(is, want, row.tolerance, exact)) continue;
          if (outliers[i]++ == 0 && first.empty()) first = describe(row, x, y, channel, is, want);
        }
      }
    }
  }
  const std::size_t pixels = static_cast<std::size_t>(inputs.outputWidth()) * inputs.outputHeight();
  const std::size_t allowed = exact ? 0 : pixels / kPixelsPerOutlier;
  std::string counts;
  for (std::size_t i = 0; i < kResolveRowCount; ++i) {
    if (outliers[i] <= allowed) continue;
    counts += " " + std::string(kResolveRows[i].name) + ": " + std::to_string(outliers[i]);
  }
  return counts.empty() ? "" : first + "; values that differ:" + counts;
}

void Accumulator::resolve(TaaPass& pass, const FrameInputs& inputs, const Settings& settings,
                          Exposure* exposure) {
  hadHistory_ = !inputs.info.startsHistory;
  current_ = 1 - current_;
  fitHistory(histories_[current_], inputs.outputWidth(), inputs.outputHeight(), settings);
  pass.resolve(inputs, previous(), settings, histories_[current_], exposure);
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

void Player::step(TaaPass& pass, Exposure* exposure) {
  draw();
  accumulator_.resolve(pass, inputs_, settings_, exposure);
}

} // namespace taa::test
