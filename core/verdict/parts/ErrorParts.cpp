#include "core/verdict/parts/ErrorParts.h"

#include "core/base/Say.h"
#include "core/taa/twin/HistoryTaps.h"

#include <cassert>
#include <cstddef>
#include <vector>

namespace taa {

namespace {

// Those that history carries, of a pixel side by side: it is read at many places.
constexpr std::size_t kCarried = kErrorParts - 1, kCarriedValues = 3 * kCarried;
using CarriedParts = std::array<float, kCarriedValues>;

constexpr std::size_t firstOf(ErrorPart part) {
  return 3 * static_cast<std::size_t>(part);
}

void addPart(CarriedParts& parts, ErrorPart part, const Image& image, std::size_t pixel) {
  for (std::size_t channel = 0; channel < 3; ++channel)
    parts[firstOf(part) + channel] += image.pixels[3 * pixel + channel];
}

CarriedParts readParts(const std::vector<CarriedParts>& before, const twin::HistoryTexels& texels,
                       int width) {
  CarriedParts sum{};
  for (const twin::HistoryTexels::Texel& texel : texels.all()) {
    const CarriedParts& there = before[static_cast<std::size_t>(texel.at.y) * width + texel.at.x];
    for (std::size_t value = 0; value < kCarriedValues; ++value) sum[value] += texel.weight * there[value];
  }
  return sum;
}

std::vector<CarriedParts> firstParts(const FrameErrors& errors, bool isStart) {
  std::vector<CarriedParts> parts(errors.error.pixels.size() / 3);
  for (std::size_t pixel = 0; pixel < parts.size(); ++pixel)
    addPart(parts[pixel], isStart ? ErrorPart::Aliasing : ErrorPart::Older,
            isStart ? errors.aliasing : errors.error, pixel);
  return parts;
}

CarriedParts historyParts(const FrameErrors& errors, const std::vector<CarriedParts>& before,
                          const HistorySettings& settings, std::size_t pixel) {
  const float* history = errors.history.pixels.data() + 4 * pixel;
  const int width = errors.error.width, height = errors.error.height;
  if (static_cast<HistoryReading>(history[2]) == HistoryReading::None) return {};
  const bool isOneTap = static_cast<HistoryReading>(history[2]) == HistoryReading::OneTap;
  CarriedParts parts = readParts(
      before, twin::historyTexels(settings, {history[0], history[1]}, {width, height}, isOneTap), width);
  const auto channels = static_cast<std::size_t>(errors.kept.channels);
  const float* kept = errors.kept.pixels.data() + channels * pixel;
  for (std::size_t value = 0; value < kCarriedValues; ++value)
    parts[value] *= kept[channels == 1 ? 0 : value % 3];
  addPart(parts, history[3] != 0.0f ? ErrorPart::Ghost : ErrorPart::Blur, errors.resampled, pixel);
  addPart(parts, ErrorPart::Lag, errors.lag, pixel);
  return parts;
}

std::vector<CarriedParts> nextParts(const FrameErrors& errors, const std::vector<CarriedParts>& before,
                                    const HistorySettings& settings) {
  std::vector<CarriedParts> parts(before.size());
  for (std::size_t pixel = 0; pixel < parts.size(); ++pixel) {
    parts[pixel] = historyParts(errors, before, settings, pixel);
    addPart(parts[pixel], ErrorPart::Aliasing, errors.aliasing, pixel);
  }
  return parts;
}

ErrorParts withRemainder(const std::vector<CarriedParts>& carried, const Image& error) {
  ErrorParts parts;
  parts.images.fill(Image(error.width, error.height, 3));
  for (std::size_t pixel = 0; pixel < carried.size(); ++pixel)
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const std::size_t at = 3 * pixel + channel;
      double sum = 0.0;
      for (std::size_t part = 0; part < kCarried; ++part) {
        parts.images[part].pixels[at] = carried[pixel][3 * part + channel];
        sum += static_cast<double>(carried[pixel][3 * part + channel]);
      }
      parts.at(ErrorPart::Rectification).pixels[at] =
          static_cast<float>(static_cast<double>(error.pixels[at]) - sum);
    }
  return parts;
}

} // namespace

ErrorParts errorParts(const PartsWindow& window, const HistorySettings& settings, const Progress& progress) {
  assert(!window.oldestFirst.empty());
  std::vector<CarriedParts> parts = firstParts(*window.oldestFirst.front(), window.startsHistory);
  const int count = static_cast<int>(window.oldestFirst.size());
  for (int index = 1; index < count; ++index) {
    report(progress, say<"Parts of the error">(), index, count);
    const FrameErrors& errors = *window.oldestFirst[static_cast<std::size_t>(index)];
    assert(errors.hasHistory());
    parts = nextParts(errors, parts, settings);
  }
  return withRemainder(parts, window.oldestFirst.back()->error);
}

} // namespace taa
