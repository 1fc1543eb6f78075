// What is drawn of a part of a frame is what the whole frame holds there, bit for bit, one sample of a
// reference after another; little else is drawn for it.
#include "core/base/Error.h"
#include "core/render/ReferencePoints.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/GlTest.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>

namespace taa {
namespace {

namespace fs = std::filesystem;

constexpr std::array kTextures{
    &FrameInputs::color,  &FrameInputs::depth,    &FrameInputs::motion,
    &FrameInputs::normal, &FrameInputs::objectId, &FrameInputs::mask,
    &FrameInputs::fog,    &FrameInputs::overlay,  &FrameInputs::previousDepth,
};

/// Bit for bit, −0 and what is no number too.
bool isSamePart(const gl::Texture& part, const gl::Texture& whole, const gl::Rect& place) {
  if (!part || !whole) return !part && !whole;
  const Image a = part.download(place), b = whole.download(place);
  return std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

FrameRequest requestOf(const Scene& scene, int width, int height) {
  FrameRequest request;
  request.camera = scene.shot.camera;
  request.width = width;
  request.height = height;
  request.inputs.mask = MaskSource::Material;
  request.inputs.blended = BlendedAs::BeforeWithMotion;
  return request;
}

class FramePartsTest : public test::GlTest {
 protected:
  /// Three samples of a frame, drawn whole and then part after part.
  void expectPartsOf(SceneRenderer& renderer, FrameRequest asked, int frame, const std::string& what) {
    for (std::size_t sample = 0; sample < wholes_.size(); ++sample) {
      asked.jitterPx = referencePointPx(int(sample));
      renderer.draw(asked, frame, wholes_[sample]);
    }
    const int x = asked.width / 2, y = asked.height / 2;
    for (const gl::Rect& part : {gl::Rect{0, 0, 1, 1}, gl::Rect{x, y, 4, 4}, gl::Rect{x - 20, y - 9, 20, 10},
                                 gl::Rect{x + 9, y + 2, 13, 21}}) {
      asked.part = part;
      for (std::size_t sample = 0; sample < wholes_.size(); ++sample) {
        asked.jitterPx = referencePointPx(int(sample));
        renderer.draw(asked, frame, part_);
        EXPECT_EQ(part_.block.jitterPx, *asked.jitterPx);
        for (const auto texture : kTextures)
          EXPECT_TRUE(isSamePart(part_.*texture, wholes_[sample].*texture, part))
              << what << ", frame " << frame << ", sample " << sample << " at " << part.x << ", " << part.y;
      }
    }
  }
  /// Triangles that are drawn for 8×8 pixels of a picture of 960×540, for each that is drawn for all of it.
  static double shareOfTriangles(const std::string& source, int x, int y) {
    const auto scene = std::make_shared<const Scene>(openScene(source));
    SceneRenderer renderer(scene);
    FrameRequest asked = requestOf(*scene, 960, 540);
    FrameInputs drawn;
    renderer.draw(asked, 20, drawn);
    const auto all = static_cast<double>(renderer.counts().triangles);
    asked.part = gl::Rect{x, y, 8, 8};
    renderer.draw(asked, 20, drawn);
    EXPECT_GT(renderer.counts().triangles, 0u);
    return static_cast<double>(renderer.counts().triangles) / all;
  }

 private:
  std::array<FrameInputs, 3> wholes_;
  FrameInputs part_;
};

/// Nothing when the file is refused, which GltfModelsTest looks after.
std::shared_ptr<const Scene> openModel(const fs::path& file) {
  try {
    return std::make_shared<const Scene>(openScene(file.string()));
  } catch (const Error&) {
    return nullptr;
  }
}

TEST_F(FramePartsTest, AreThoseOfWholeFramesWhereSurfacesAreDense) {
  for (const char* source : {"builtin:crowd", "builtin:foliage"}) {
    const auto scene = std::make_shared<const Scene>(openScene(source));
    SceneRenderer renderer(scene);
    for (const int frame : {0, 61}) expectPartsOf(renderer, requestOf(*scene, 160, 90), frame, source);
  }
}

// Skins, morph targets, mirrored nodes, cut-outs and what is blended among them.
TEST_F(FramePartsTest, AreThoseOfWholeFramesOfEveryModel) {
  const fs::path folder = fs::path(TAA_SHARED_DATA) / "models";
  if (!fs::exists(folder)) GTEST_SKIP() << "no shared data at " << TAA_SHARED_DATA;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".gltf" && entry.path().extension() != ".glb") continue;
    const std::shared_ptr<const Scene> scene = openModel(entry.path());
    if (!scene) continue;
    SceneRenderer renderer(scene);
    expectPartsOf(renderer, requestOf(*scene, 96, 64), 37, entry.path().filename().string());
  }
}

TEST_F(FramePartsTest, DrawFewTrianglesForFewPixels) {
  EXPECT_LT(shareOfTriangles("builtin:crowd", 700, 200), 0.02);
  EXPECT_LT(shareOfTriangles("builtin:foliage", 296, 340), 0.125);
}

// Fog, motion from depth, reactive mask, noise and range are drawn after the surfaces.
TEST_F(FramePartsTest, AreThoseOfWholeFramesAfterEveryPass) {
  const auto scene = std::make_shared<const Scene>(openScene("builtin:fog"));
  SceneRenderer renderer(scene);
  FrameRequest asked = requestOf(*scene, 160, 90);
  asked.inputs.mask = MaskSource::AutoReactive;
  asked.inputs.motion = MotionSource::RawUv;
  asked.inputs.noise = InputNoise::Blue;
  asked.inputs.range = DynamicRange::Ldr;
  asked.inputs.fogHistory = FogHistory::Clamped;
  for (const int frame : {3, 40}) expectPartsOf(renderer, asked, frame, "all passes");
}

} // namespace
} // namespace taa
