// Each built-in scene looks as it did: a small golden picture of each.
#include "core/inspect/Inspector.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"
#include "tests/support/GlTest.h"
#include "tests/support/pictures/Golden.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

using taa::Image;
using taa::Inspector;
using taa::test::Limits;

namespace {

constexpr int kWidth = 160, kHeight = 90, kFrame = 12;

/// "builtin:NAME" with preset balanced, as a view shows it.
Image pictureOf(const std::string& scene, int frame) {
  Inspector inspector;
  inspector.shot().setSize(kWidth, kHeight);
  inspector.shot().setSettings(taa::preset("balanced").settings);
  inspector.shot().open("builtin:" + scene);
  inspector.shot().seek(frame);
  constexpr auto kId = taa::IntermediateId::output;
  const taa::Picture picture =
      inspector.views().picture(kId, taa::defaultStyle(taa::intermediate(kId)), {}, kWidth, kHeight);
  Image image(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int channel = 0; channel < 3; ++channel)
        image.at(x, y)[channel] =
            static_cast<float>(picture.rgba[(static_cast<std::size_t>(y) * kWidth + x) * 4 + channel]) /
            255.0f;
  return image;
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const taa::BuiltinScene& scene : taa::builtinScenes()) names.push_back(scene.id);
  return names;
}

} // namespace

class GoldenScenes : public taa::test::GlTest {
 protected:
  // llvmpipe of Mesa 22 and of Mesa 25 draw the same but for a few pixels on edges, which may have any color
  // of their neighborhood; a GPU filters textures and covers edges in its own way, which moves more pixels by
  // more. The mean finds what is wrong everywhere by little.
  static Limits limits() {
    Limits limits;
    limits.tolerance = isExact() ? 2.0f / 255.0f : 6.0f / 255.0f;
    limits.outliers = isExact() ? 0.01 : 0.08;
    limits.worst = 0.75f;
    limits.mean = isExact() ? 0.001 : 0.008;
    return limits;
  }
};

class GoldenOfScene : public GoldenScenes, public testing::WithParamInterface<std::string> {};

TEST_P(GoldenOfScene, LooksAsItDid) {
  EXPECT_EQ(taa::test::differenceFromGolden("scene-" + GetParam(), pictureOf(GetParam(), kFrame), limits()),
            "");
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenOfScene, testing::ValuesIn(sceneNames()),
                         [](const auto& scene) { return scene.param; });

TEST_F(GoldenScenes, AreThoseOfTheBuiltinScenes) {
  std::set<std::string> expected;
  for (const std::string& name : sceneNames()) expected.insert("scene-" + name);
  EXPECT_EQ(taa::test::goldenNames("scene-"), expected);
}

// The blades have moved on: the limits are narrow enough to see it.
TEST_F(GoldenScenes, AnotherFrameIsAnotherPicture) {
  EXPECT_FALSE(taa::test::compare(pictureOf("fan", kFrame + 3), pictureOf("fan", kFrame), limits()).agrees);
}
