// The warp test on real models (invariant 17): the previous frame at pixel − motion is what the pixel was.
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

namespace taa {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 320, kHeight = 180;

/// Pixels of objects whose previous depth is that of the previous frame's picture at pixel − motion, of those
/// that had a place there.
struct Warp {
  int pixels = 0, agree = 0;
};

Warp warp(const Scene& scene, int frame) {
  FrameRequest asked;
  asked.camera = "still";
  asked.width = kWidth;
  asked.height = kHeight;
  asked.inputs.precision = Precision::Full;
  asked.jitter.sequence = JitterSequence::None;
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameInputs before, now;
  renderer.draw(asked, frame - 1, before);
  renderer.draw(asked, frame, now);
  const Image motion = now.motion.download(), expected = now.previousDepth.download(),
              ids = now.objectId.download(), previousIds = before.objectId.download(),
              previousDepth = before.depth.download();
  const glm::vec4 terms = before.block.depthTerms;
  const auto viewDepth = [&](const glm::ivec2& p) {
    const float d = previousDepth.texel(p.x, p.y).x;
    return (d * terms.x - terms.y) / (d * terms.z - terms.w);
  };
  // Off disocclusions and silhouettes: all nine previous pixels around belong to the same object.
  const auto isInside = [&](const glm::ivec2& p, float id) {
    if (p.x < 1 || p.y < 1 || p.x >= kWidth - 1 || p.y >= kHeight - 1) return false;
    for (int i = 0; i < 9; ++i)
      if (previousIds.texel(p.x + i % 3 - 1, p.y + i / 3 - 1).x != id) return false;
    return true;
  };
  const auto agrees = [&](const glm::vec2& place, float depth, float id) {
    const glm::ivec2 p(glm::floor(place));
    if (!isInside(p, id)) return false;
    float least = viewDepth(p), most = least; // the place lies somewhere between these pixels
    for (int i = 0; i < 9; ++i) {
      const float d = viewDepth(p + glm::ivec2(i % 3 - 1, i / 3 - 1));
      least = std::min(least, d);
      most = std::max(most, d);
    }
    return depth >= least * (1.0f - 1e-5f) && depth <= most * (1.0f + 1e-5f);
  };
  Warp result;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float id = ids.texel(x, y).x;
      const glm::vec2 here(float(x) + 0.5f, float(y) + 0.5f), v(motion.texel(x, y));
      if (id == 0.0f || glm::length(v) < 0.02f || !isInside(glm::ivec2(glm::floor(here - v)), id)) continue;
      ++result.pixels;
      result.agree += agrees(here - v, expected.texel(x, y).x, id);
    }
  return result;
}

class WarpTest : public test::GlTest, public testing::WithParamInterface<const char*> {};

TEST_P(WarpTest, ThePreviousFrameAtPixelMinusMotionIsWhatThePixelWas) {
  const fs::path folder = fs::path(TAA_SHARED_DATA) / "models" / GetParam();
  if (!fs::exists(folder)) GTEST_SKIP() << "no shared data at " << folder;
  fs::path file;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb") file = entry.path();
  const Scene scene = openScene(file.string());
  int pixels = 0, agree = 0;
  for (const int frame : {7, 20, 41}) {
    const Warp result = warp(scene, frame);
    pixels += result.pixels;
    agree += result.agree;
  }
  EXPECT_GT(pixels, 300) << "hardly anything moves";
  // What folds over itself (an arm before the chest) is one object with two depths.
  EXPECT_GT(agree, 0.97 * pixels) << agree << " of " << pixels;
}

INSTANTIATE_TEST_SUITE_P(Models, WarpTest,
                         testing::Values("CesiumMan", "Fox", "RiggedSimple", "RecursiveSkeletons",
                                         "AnimatedMorphCube", "MorphStressTest"),
                         [](const auto& model) { return std::string(model.param); });

} // namespace
} // namespace taa
