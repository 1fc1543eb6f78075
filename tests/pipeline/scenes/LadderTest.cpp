// The steps of the sources' ladders: shader and twin agree on each, as on the whole pipelines
// (TwinOnScenesTest), but on one scene, small and for three frames; their choices are tested one by one
// elsewhere.
#include "tests/support/GlTest.h"
#include "tests/support/frames/Frames.h"

#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 36;

class LadderTest : public test::GlTest {};

TEST_F(LadderTest, ShaderAndTwinAgreeOnEveryStep) {
  const std::string camera = openScene("builtin:fan").shot.camera;
  TaaPass pass;
  for (const Preset& preset : builtinPresets()) {
    if (preset.step == 0) continue;
    test::Player player("builtin:fan", camera, kWidth, kHeight, preset.settings);
    ExposedRows exposedRows(ExposedLayout(allRows(), rowSources(preset.settings)), {0, 0, kWidth, kHeight});
    for (int frame = 0; frame < 3; ++frame) {
      player.step(pass, &exposedRows);
      if (frame == 1) continue;
      std::vector<Image> pictures;
      for (const IntermediateId id : allRows()) pictures.push_back(exposedRows.image(id));
      EXPECT_EQ(test::differenceFromTwin(test::twinInputs(player.inputs(), player.previous()),
                                         preset.settings, pictures, isExact()),
                "")
          << preset.id << ", frame " << frame;
    }
  }
}

} // namespace
} // namespace taa
