// What a scene is said to take is what its meshes and textures are given.
#include "core/gl/Memory.h"
#include "core/render/SceneResources.h"
#include "core/scene/SceneCost.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/GlTest.h"

#include <cstddef>
#include <string>

namespace taa {
namespace {

using SceneBytesTest = test::GlTest;

/// Bytes of blocks of materials, which are not counted: a few hundred each.
std::size_t materialBytes() {
  std::size_t bytes = 0;
  for (const gl::MemoryUse& use : gl::memoryUse())
    if (use.label == "materials") bytes += use.bytes;
  return bytes;
}

TEST_F(SceneBytesTest, AreThoseOfTheScenesCost) {
  // Textures, skins, morph targets and caches; and alpha masks in the wind.
  for (const std::string source : {"builtin:gallery", "builtin:foliage"}) {
    const Scene scene = openScene(source);
    const std::size_t before = gl::memoryInUse() - materialBytes();
    const SceneResources resources(scene, {});
    EXPECT_EQ(gl::memoryInUse() - materialBytes() - before, costOf(scene).bytes) << source;
  }
}

} // namespace
} // namespace taa
