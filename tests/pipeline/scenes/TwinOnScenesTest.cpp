// Real frames: every intermediate of every pixel is what the CPU twin says, with every preset.
#include "tests/support/CompareImages.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/Frames.h"
#include "tests/support/frames/ResolveTest.h"

#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <string>
#include <vector>

namespace taa {
namespace {

class TwinOnScenesTest : public test::GlTest, public testing::WithParamInterface<const char*> {};

constexpr int kWidth = 192;
constexpr int kHeight = 108;

TEST_P(TwinOnScenesTest, AgreesOnWholeFramesWithEveryPreset) {
  const std::string source = std::string("builtin:") + GetParam();
  const std::string camera = openScene(source).shot.camera;
  TaaPass pass;
  for (const Preset& preset : wholePresets()) {
    test::Player player(source, camera, kWidth, kHeight, preset.settings);
    ExposedRows exposedRows(ExposedLayout(allRows(), rowSources(preset.settings)), {0, 0, kWidth, kHeight});
    for (int frame = 0; frame < 12; ++frame) {
      player.step(pass, &exposedRows);
      if (frame != 0 && frame != 1 && frame != 11) continue; // no history, the least, a usual one
      std::vector<Image> pictures;
      for (const IntermediateId id : allRows()) pictures.push_back(exposedRows.image(id));
      EXPECT_EQ(test::differenceFromTwin(test::twinInputs(player.inputs(), player.previous()),
                                         preset.settings, pictures, isExact()),
                "")
          << source << ", " << preset.id << ", frame " << frame;
    }
  }
}

TEST_P(TwinOnScenesTest, ShowsOnePixelAsItShowsTheWholePicture) {
  const std::string source = std::string("builtin:") + GetParam();
  TaaPass pass;
  const Settings settings = preset("balanced").settings;
  test::Player player(source, openScene(source).shot.camera, kWidth, kHeight, settings);
  ExposedRows whole(ExposedLayout(allRows(), rowSources(settings)), {0, 0, kWidth, kHeight});
  for (int frame = 0; frame < 6; ++frame) player.step(pass, &whole);
  for (const gl::Rect& region :
       {gl::Rect{0, 0, 1, 1}, gl::Rect{97, 41, 1, 1}, gl::Rect{kWidth - 9, kHeight - 9, 9, 9}}) {
    ExposedRows some(allRows(), region);
    pass.expose(player.inputs(), player.previous(), player.history(), settings, some);
    for (const IntermediateId id : allRows()) {
      const Image all = whole.image(id);
      const Image part = some.image(id);
      ASSERT_EQ(part.width, region.width);
      for (int y = 0; y < part.height; ++y) {
        for (int x = 0; x < part.width; ++x) {
          EXPECT_EQ(part.texel(x, y), all.texel(region.x + x, region.y + y)) << intermediate(id).name;
        }
      }
    }
  }
}

TEST_P(TwinOnScenesTest, LookingChangesNoHistoryWithEveryPreset) {
  const std::string source = std::string("builtin:") + GetParam();
  const std::string camera = openScene(source).shot.camera;
  constexpr int kSmallWidth = 80;
  constexpr int kSmallHeight = 45;
  TaaPass pass;
  for (const Preset& preset : wholePresets()) {
    test::Player player(source, camera, kSmallWidth, kSmallHeight, preset.settings);
    test::Accumulator blind;
    test::Accumulator glancing;
    test::Accumulator staring;
    const gl::Rect all{0, 0, kSmallWidth, kSmallHeight};
    ExposedRows one({IntermediateId::alpha}, all);
    ExposedRows everything(ExposedLayout(allRows(), rowSources(preset.settings)), all);
    for (int frame = 0; frame < 32; ++frame) {
      player.draw();
      blind.resolve(pass, player.inputs(), preset.settings);
      glancing.resolve(pass, player.inputs(), preset.settings, &one);
      staring.resolve(pass, player.inputs(), preset.settings, &everything);
      const Image color = blind.history().color.download();
      const Image surface = blind.history().surface.download();
      for (const test::Accumulator* looked : {&glancing, &staring}) {
        ASSERT_EQ(test::difference(color, looked->history().color.download()), "")
            << preset.id << " " << frame;
        ASSERT_EQ(test::difference(surface, looked->history().surface.download()), "")
            << preset.id << " " << frame;
      }
    }
  }
}

/// Ways to treat what is blended, and what the masks ask for.
std::vector<Settings> policies() {
  std::vector<Settings> all(4);
  all[0].inputs.blended = BlendedAs::Before;
  all[0].inputs.mask = MaskSource::Material;
  all[0].weight.mask = MaskAlpha::Responsive;
  all[1].inputs.blended = BlendedAs::BeforeWithMotion;
  all[1].inputs.mask = MaskSource::Opacity;
  all[1].neighborhood.maskRelax = Switch::On;
  all[1].weight.mask = MaskAlpha::Reactive;
  all[2].inputs.blended = BlendedAs::Before;
  all[2].inputs.mask = MaskSource::AutoReactive;
  all[2].weight.mask = MaskAlpha::Reactive;
  all[3].inputs.blended = BlendedAs::After;
  all[3].inputs.mask = MaskSource::Material;
  all[3].weight.mask = MaskAlpha::Exclude;
  return all;
}

class TwinOnGlassTest : public test::GlTest {};

TEST_F(TwinOnGlassTest, AgreesWithMasksAndOverlay) {
  TaaPass pass;
  for (const Settings& settings : policies()) {
    test::Player player("builtin:glass", "gltf:front", kWidth, kHeight, settings);
    ExposedRows exposedRows(ExposedLayout(allRows(), rowSources(settings)), {0, 0, kWidth, kHeight});
    for (int frame = 0; frame < 6; ++frame) player.step(pass, &exposedRows);
    std::vector<Image> pictures;
    for (const IntermediateId id : allRows()) pictures.push_back(exposedRows.image(id));
    const auto most = [&](IntermediateId id) {
      return std::ranges::max(pictures[static_cast<std::size_t>(id)].pixels);
    };
    const bool isAfter = settings.inputs.blended == BlendedAs::After;
    EXPECT_GT(most(IntermediateId::responsive), 0.9f);
    EXPECT_EQ(most(IntermediateId::reactive) > 0.5f, settings.weight.mask == MaskAlpha::Reactive);
    EXPECT_EQ(most(IntermediateId::overlayAlpha) > 0.5f, isAfter);
    EXPECT_GT(most(IntermediateId::alphaMask), 0.2f);
    EXPECT_EQ(test::differenceFromTwin(test::twinInputs(player.inputs(), player.previous()), settings,
                                       pictures, isExact()),
              "")
        << static_cast<int>(settings.inputs.blended) << " " << static_cast<int>(settings.inputs.mask);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, TwinOnScenesTest, testing::Values("fan", "fence"));

} // namespace
} // namespace taa
