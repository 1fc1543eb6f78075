// Hand-made inputs of the CPU twin.
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Stages.h"

#include <array>
#include <cstddef>

namespace taa::test {
namespace {

void fill(Image& image, const glm::vec4& value) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int channel = 0; channel < image.channels; ++channel) image.at(x, y)[channel] = value[channel];
    }
  }
}

} // namespace

twin::Inputs constantInputs(int width, int height, const glm::vec3& color) {
  constexpr float kNear = 0.1f;
  twin::Inputs inputs;
  inputs.color = Image(width, height, 4);
  inputs.depth = Image(width, height, 1);
  inputs.motion = Image(width, height, 2);
  inputs.normal = Image(width, height, 4);
  inputs.objectId = Image(width, height, 1);
  inputs.previousDepth = Image(width, height, 1);
  fill(inputs.color, {color, 1.0f});
  fill(inputs.depth, glm::vec4(kNear)); // near / device depth: 1 m
  fill(inputs.previousDepth, glm::vec4(1.0f));
  inputs.depthTerms = {0.0f, kNear, -1.0f, 0.0f};
  return inputs;
}

void setHistory(twin::Inputs& inputs, const glm::vec3& color, float length) {
  inputs.historyColor = Image(inputs.outputWidth(), inputs.outputHeight(), 4);
  inputs.historySurface = Image(inputs.outputWidth(), inputs.outputHeight(), 2);
  fill(inputs.historyColor, {color, 1.0f});
  fill(inputs.historySurface, {length, 1.0f, 0.0f, 0.0f});
}

void setColor(Image& image, int x, int y, const glm::vec3& color) {
  for (int channel = 0; channel < 3; ++channel) image.at(x, y)[channel] = color[channel];
}

void setGrays(Image& image, const std::array<float, 9>& grays) {
  for (int k = 0; k < 9; ++k) setColor(image, k % 3, k / 3, glm::vec3(grays[static_cast<std::size_t>(k)]));
}

Settings plainSettings() {
  Settings settings;
  settings.dilate.method = DilateMethod::None;
  settings.history = {HistoryFilter::Bilinear, Switch::Off, Precision::Full};
  settings.current.filter = CurrentFilter::Center;
  settings.space = {ColorSpace::Rgb, ToneSpace::Linear};
  settings.neighborhood = {NeighborhoodShape::Square3x3, BoxKind::MinMax, 1.0f, Switch::Off};
  settings.rectify.method = RectifyMethod::None;
  settings.validate = {OffScreen::Keep, Switch::Off, 0.03f, 0.0f};
  settings.weight = {AlphaSource::Constant, 0.1f, 0.0f};
  settings.blend.tone = ToneWeight::None;
  return settings;
}

Settings averagingSettings(int period) {
  Settings settings = plainSettings();
  settings.jitter.period = period;
  settings.inputs.precision = Precision::Full;
  settings.weight = {AlphaSource::HistoryLength, 0.1f, 0.0f};
  return settings;
}

twin::PixelRecord advance(twin::Inputs& inputs, const Settings& settings, int x, int y) {
  using twin::at;
  Image color(inputs.outputWidth(), inputs.outputHeight(), 4);
  Image surface(inputs.outputWidth(), inputs.outputHeight(), 2);
  twin::PixelRecord asked{};
  for (int row = 0; row < inputs.outputHeight(); ++row) {
    for (int column = 0; column < inputs.outputWidth(); ++column) {
      const twin::PixelRecord record = twin::resolvePixel(inputs, settings, column, row);
      setColor(color, column, row, glm::vec3(at(record, IntermediateId::resolved)));
      color.at(column, row)[3] = 1.0f;
      surface.at(column, row)[0] = at(record, IntermediateId::historyLength).x;
      surface.at(column, row)[1] =
          twin::viewDepth(at(record, IntermediateId::dilatedDepth).x, inputs.depthTerms);
      if (column == x && row == y) asked = record;
    }
  }
  inputs.historyColor = color;
  inputs.historySurface = surface;
  return asked;
}

} // namespace taa::test
