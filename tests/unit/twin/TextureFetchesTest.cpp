// Texture fetches by the settings, against counts by hand and against what the twin's result really depends
// on.
#include "core/taa/TextureFetches.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/support/frames/TwinInputs.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace taa::twin {
namespace {

TEST(TextureFetches, AreThoseThatOneCountsByHand) {
  const std::pair<const char*, int> counted[] = {
      {"off", 1},
      {"source000-1", 1},              // the sample alone
      {"source000-2", 1 + 1},          // and history in place
      {"source000-3", 1 + 1 + 1},      // and where motion says
      {"source000-4", 9 + 1 + 1},      // a box of nine
      {"source000-9", 9 + 1 + 1},      // whose samples the filter takes, too
      {"source000-10", 9 + 1 + 1 + 9}, // nine depths
      {"source000-11", 9 + 1 + 5 + 9}, // five taps of history
      {"source001-4", 1 + 1 + 9 + 9},  // nine taps, nine depths
      {"urp-verylow", 5 + 1 + 1},      // a cross
      {"urp-low", 5 + 1 + 1 + 5},      // and a cross of depths
      {"falcor", 9 + 9 + 9},           // nine motions in place of depths, nine taps
      // Nine where the pixels' centers landed, the sample among them; a cross for the Laplacian; five depths.
      {"source002", 9 + 5 + 1 + 1 + 5},
      // One sample, motion, history; own depth, four for its slope, the last one; object and normal now; 3×3
      // of N with depth, of objects and of normals in history.
      {"source004", 1 + 1 + 1 + (1 + 4 + 1) + 2 + 3 * 9},
  };
  for (const auto& [id, fetches] : counted)
    EXPECT_EQ(textureFetches(preset(id).settings).sum(), fetches) << id;
}

constexpr int kSide = 9;
constexpr glm::ivec2 kPixel{4, 4};

void put(Image& image, int x, int y, const glm::vec4& value) {
  for (int channel = 0; channel < image.channels; ++channel) image.at(x, y)[channel] = value[channel];
}

/// Every color, depth, motion and history of its own, history far outside of any box.
Inputs variedInputs() {
  Inputs inputs = test::constantInputs(kSide, kSide, glm::vec3(0.25f));
  test::setHistory(inputs, glm::vec3(5.0f), 4.0f);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float wave = 0.01f * static_cast<float>((3 * x + 5 * y) % 7);
      test::setColor(inputs.color, x, y, {0.25f + wave, 0.2f - wave, 0.3f + 0.5f * wave});
      const float column = static_cast<float>(x), row = static_cast<float>(y);
      test::setColor(inputs.historyColor, x, y,
                     {5.0f + 0.3f * column + 0.1f * row * row, 6.0f - 0.2f * column * row, 4.0f + wave});
      const glm::vec2 motion = glm::vec2(0.4f, 0.3f) + wave;
      put(inputs.motion, x, y, {motion, 0.0f, 0.0f});
    }
  return inputs;
}

/// How many texels of a picture the pixel's color depends on: each is changed, up and down.
int texelsThatCount(const Inputs& inputs, Texels Inputs::*picture, const Settings& settings, float low,
                    float high) {
  const glm::vec4 own = at(resolvePixel(inputs, settings, kPixel.x, kPixel.y), IntermediateId::resolved);
  int count = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      bool isRead = false;
      for (const float value : {low, high}) {
        Inputs other = inputs;
        put(other.*picture, x, y, glm::vec4(value));
        isRead =
            isRead || at(resolvePixel(other, settings, kPixel.x, kPixel.y), IntermediateId::resolved) != own;
      }
      count += isRead ? 1 : 0;
    }
  return count;
}

/// What a tap reads of history between its texels: four, and of five or nine taps those that are theirs.
int texelsOf(int taps) {
  return taps == 1 ? 4 : (taps == 5 ? 12 : 16);
}

bool comparesSurfaces(const ValidateSettings& validate) {
  return isOn(validate.depth) || isOn(validate.object) || isOn(validate.objectClass) ||
         isOn(validate.normal) || validate.velocity != VelocityTest::None;
}

// Counted the other way round: by what the result depends on.
TEST(TextureFetches, AreWhatTheColorOfAPixelDependsOn) {
  int seen = 0;
  for (const Preset& preset : builtinPresets()) {
    Settings settings = preset.settings;
    const bool isShifted =
        isOn(settings.neighborhood.unjitter) || settings.current.filter == CurrentFilter::Unjitter;
    if (ladderOf(preset.id).empty() || comparesSurfaces(settings.validate) || isShifted) continue;
    ++seen;
    settings.weight.motion = MotionAlpha::None; // so small a picture moves too fast for any history
    const Inputs inputs = variedInputs();
    const TextureFetches fetches = textureFetches(settings);
    EXPECT_EQ(texelsThatCount(inputs, &Inputs::color, settings, 0.0f, 40.0f), fetches.color) << preset.id;
    if (fetches.history == 0) continue; // nothing is averaged
    // Rectified history is that of the box, whatever was read: not here.
    settings.rectify.method = RectifyMethod::None;
    settings.weight.source = AlphaSource::Constant;
    settings.weight.alpha = 0.1f;
    const bool isAtRest = settings.reproject.method == ReprojectMethod::InPlace;
    EXPECT_EQ(texelsThatCount(inputs, &Inputs::historyColor, settings, 1.0f, 9.0f),
              isAtRest ? 1 : texelsOf(fetches.history))
        << preset.id;
    if (isAtRest) continue;
    EXPECT_EQ(texelsThatCount(inputs, &Inputs::motion, settings, 0.05f, 1.6f), fetches.motion) << preset.id;
    const bool isByDepth = preset.settings.dilate.method != DilateMethod::None && fetches.motion == 1;
    EXPECT_EQ(texelsThatCount(inputs, &Inputs::depth, settings, 0.01f, 0.9f), isByDepth ? fetches.depth : 0)
        << preset.id;
  }
  EXPECT_GT(seen, 30);
}

} // namespace
} // namespace taa::twin
