#include "tests/manual/ExamplePixel.h"

#include "core/settings/Presets.h"
#include "core/taa/twin/Traced.h"

#include <memory>
#include <utility>

namespace taa {

namespace {

constexpr int kSide = 7;
constexpr glm::ivec2 kMiddle{3, 3};

template <typename Value>
Image filled(int channels, Value value) {
  Image image(kSide, kSide, channels);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::vec4 texel = value(x, y);
      for (int channel = 0; channel < channels; ++channel) image.at(x, y)[channel] = texel[channel];
    }
  return image;
}

twin::Inputs exampleInputs() {
  const auto same = [](const glm::vec4& value) { return [value](int, int) { return value; }; };
  const auto colorAt = [](float silhouette) {
    return [silhouette](int x, int y) {
      const float light = static_cast<float>(x) < silhouette ? 0.75f : 0.125f;
      return glm::vec4(light, 0.5f * light + 0.0625f * static_cast<float>(y), 0.25f * light, 1.0f);
    };
  };
  constexpr float kMeters = 5.0f;
  twin::Inputs inputs;
  inputs.color = filled(4, colorAt(4.0f));
  inputs.historyColor = filled(4, colorAt(3.0f));
  inputs.depth = filled(1, same(glm::vec4(0.02f)));
  inputs.previousDepth = filled(1, same(glm::vec4(kMeters)));
  inputs.historySurface = filled(2, same({6.0f, kMeters, 0.0f, 0.0f}));
  inputs.motion = filled(2, same({1.25f, 0.0f, 0.0f, 0.0f}));
  inputs.historyMotion = inputs.motion;
  inputs.normal = filled(4, same({0.0f, 0.0f, 1.0f, 1.0f}));
  inputs.objectId = filled(1, same(glm::vec4(1.0f)));
  inputs.depthTerms = {0.0f, -0.1f, 1.0f, 0.0f}; // z = 0.1 / d
  inputs.jitterPx = {0.25f, -0.125f};
  inputs.frame = 7;
  return inputs;
}

} // namespace

std::vector<ExampleRow> exampleRows() {
  const twin::Inputs inputs = exampleInputs();
  const Settings& settings = builtinPresets().front().settings;
  twin::Details details;
  const twin::PixelRecord record = twin::resolvePixel(inputs, settings, kMiddle, details);
  details.trace = std::make_shared<const twin::Trace>(twin::traceOf(inputs, settings, kMiddle));
  std::vector<ExampleRow> rows;
  for (const Intermediate& row : kResolveRows) {
    if (isOfOutput(row.id)) continue;
    RowExplanation explanation = explainRow(row.id, {record, details, settings, {}, kMiddle});
    if (!explanation.formula.empty() || !explanation.because.empty())
      rows.push_back({row.id, std::move(explanation)});
  }
  return rows;
}

} // namespace taa
