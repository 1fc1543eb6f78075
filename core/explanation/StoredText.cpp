// What storing the resolved color does to it: rounded to halves or to steps, to the nearest or at random.
#include "core/explanation/RowFormatter.h"

#include "core/base/Say.h"
#include "core/taa/twin/Random.h"
#include "core/taa/twin/Stages.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace taa::explanation {

namespace {

/// Steps of 1 that the history can hold, less one; 0: it holds floats.
int stepsOf(const HistorySettings& history) {
  return history.precision == Precision::Unorm8 ? 255 : history.precision == Precision::Unorm10 ? 1023 : 0;
}

/// Of one channel, or of all (`channel` −1), as a number or a tuple.
template <typename Text>
std::string each(int channel, Text text) {
  if (channel >= 0) return text(channel);
  return "(" + text(0) + ", " + text(1) + ", " + text(2) + ")";
}

/// Where a dithered color is rounded up (manual 14.7): 0 to 1 of a step.
float randomOf(const RowFormatter& t, int channel) {
  const std::uint32_t number =
      twin::randomBits(t.probed.pixel, t.probed.info.frame, static_cast<std::uint32_t>(channel));
  return (static_cast<float>(number) + 0.5f) / 8192.0f;
}

/// Half floats of x are whole numbers over 2 to this.
int halfPlaces(float x) {
  constexpr int kFraction = 10, kMin = 24;
  return x < 0x1p-14f ? kMin : kFraction - std::ilogb(x);
}

std::string ditheredHalf(const RowFormatter& t, const std::string& expression, int channel) {
  const glm::vec3 mixed = mixedColor(t);
  const auto scale = [&](int i) {
    const int places = halfPlaces(mixed[i]);
    return "2^" + (places < 0 ? "(−" + std::to_string(-places) + ")" : std::to_string(places));
  };
  // Bits are added to those that are cut off: of normal numbers without the half step that keeps the mean.
  const auto random = [&](int i) {
    const float half = mixed[i] < 0x1p-14f ? 0.0f : 0.5f / 8192.0f;
    return t.number(static_cast<double>(randomOf(t, i) - half));
  };
  return "floor((" + expression + ") × " + each(channel, scale) + " + " + each(channel, random) + ") / " +
         each(channel, scale);
}

} // namespace

glm::vec3 mixedColor(const RowFormatter& t) {
  Settings settings = t.settings();
  settings.history.precision = Precision::Full;
  twin::BlendInputs mix;
  mix.current = t.color(Id::currentFiltered);
  mix.history = t.color(Id::historyRectified);
  mix.alpha = t.value(Id::alpha);
  mix.channels = t.color(Id::alphaChannels);
  mix.historyLength = t.value(Id::historyKeptLength);
  mix.confidence = t.value(Id::sampleConfidence);
  mix.motion = t.pair(Id::dilatedMotion);
  return twin::blend(settings, mix).resolved;
}

std::string storedWords(const RowFormatter& t, const std::string& words) {
  const HistorySettings& history = t.settings().history;
  if (history.precision == Precision::Full) return words;
  const int bits = history.precision == Precision::Unorm8 ? 8 : 10;
  const bool isHalf = history.precision == Precision::Half;
  if (isOn(history.dither))
    return isHalf ? say<"%1, rounded up or down at random to a half float">(words)
                  : say<"%1, rounded up or down at random to the %2 bits it is stored with">(words, bits);
  return isHalf ? say<"%1, rounded to a half float">(words)
                : say<"%1, rounded to the %2 bits it is stored with">(words, bits);
}

std::string storedText(const RowFormatter& t, const std::string& expression, int channel) {
  const HistorySettings& history = t.settings().history;
  if (history.precision == Precision::Full) return expression;
  if (history.precision == Precision::Half)
    return isOn(history.dither) ? ditheredHalf(t, expression, channel) : "half(" + expression + ")";
  const std::string steps = std::to_string(stepsOf(history));
  const std::string up =
      isOn(history.dither) ? each(channel, [&](int i) { return t.number(randomOf(t, i)); }) : t.number(0.5);
  return "floor(" + steps + " × clamp(" + expression + ", 0, 1) + " + up + ") / " + steps;
}

} // namespace taa::explanation
