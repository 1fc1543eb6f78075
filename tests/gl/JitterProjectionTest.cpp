// The picture is drawn where the jittered projection says, in each of its forms (invariant 6, manual
// §2.1).
#include "tests/support/CompareImages.h"
#include "tests/support/frames/MotionFixture.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace taa {
namespace {

using test::addQuad;
using test::emptyScene;
using test::kHeight;
using test::kP11;
using test::kWidth;

constexpr std::array kForms{JitterProjection::Translation, JitterProjection::AddedAsPrinted,
                            JitterProjection::ColumnAsPrinted, JitterProjection::RightAsPrinted};
constexpr glm::vec2 kJitter(0.375f, -0.25f);

class JitterProjectionTest : public test::MotionFixture {
 protected:
  static FrameRequest as(JitterProjection form, const glm::vec2& jitter = kJitter) {
    FrameRequest asked = request();
    asked.jitter.projection = form;
    asked.jitterPx = jitter;
    return asked;
  }
  static void makeOrthographic(Scene& scene) {
    scene.cameras[0].orthographic = true;
    scene.cameras[0].height = 4.0f;
    scene.cameras[0].farPlane = 100.0f;
  }
  static glm::vec2 windowOf(const FrameInputs& inputs, const glm::vec3& world) {
    const glm::vec4 clip = inputs.block.clipFromWorld * glm::vec4(world, 1.0f);
    return glm::vec2(0.5f + 0.5f * clip.x / clip.w, 0.5f - 0.5f * clip.y / clip.w) *
           glm::vec2(kWidth, kHeight);
  }
};

/// Where the middle of a pixel meets the plane z = `z` in the world, by the jittered inverse.
glm::dvec2 metAt(const FrameInputs& inputs, int x, int y, double z) {
  const glm::dmat4 worldFromClip = glm::inverse(glm::dmat4(inputs.block.jitteredClipFromWorld));
  const glm::dvec2 ndc(2.0 * (x + 0.5) / kWidth - 1.0, 1.0 - 2.0 * (y + 0.5) / kHeight);
  const auto at = [&](double depth) {
    const glm::dvec4 point = worldFromClip * glm::dvec4(ndc, depth, 1.0);
    return glm::dvec3(point) / point.w;
  };
  const glm::dvec3 near = at(1.0), way = at(0.25) - near;
  return glm::dvec2(near + way * ((z - near.z) / way.z));
}

// Techniques: 2.1.
TEST_F(JitterProjectionTest, DrawsEachSurfaceWhereTheMatrixPutsIt) {
  constexpr std::array kDepths{1.0f, 4.0f, 60.0f};
  for (const bool isOrthographic : {false, true})
    for (const float depth : kDepths)
      for (const JitterProjection form : kForms) {
        Scene scene = emptyScene();
        if (isOrthographic) makeOrthographic(scene);
        const float half = (isOrthographic ? 1.0f : 0.25f * depth), z = 10.0f - depth;
        addQuad(scene, {0, 0, z}, {2.0f * half, 0, 0}, {0, 2.0f * half, 0});
        const FrameInputs inputs = draw(scene, as(form));
        const Image ids = inputs.objectId.download();
        int seen = 0;
        for (int y = 0; y < kHeight; ++y)
          for (int x = 0; x < kWidth; ++x) {
            const glm::dvec2 met = glm::abs(metAt(inputs, x, y, z)) / double(half);
            const double silhouette = std::max(met.x, met.y);
            const bool isSeen = ids.at(x, y)[0] != 0.0f;
            seen += isSeen;
            // A hundredth of a pixel on either side is what rasters and float matrices may round.
            if (std::abs(silhouette - 1.0) * half < 0.01 * (isOrthographic ? 0.022 : 0.0064 * depth))
              continue;
            ASSERT_EQ(isSeen, silhouette < 1.0)
                << "form " << int(form) << " depth " << depth << " pixel " << x << ", " << y;
          }
        EXPECT_GT(seen, 1000);
      }
}

// The matrix of depth reconstruction knows where each form puts things, so that motion of depth leaks none of
// it.
TEST_F(JitterProjectionTest, LeavesNoMotionWhereNothingMoves) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {4, 1, 3}, {0, 4, 1});
  addQuad(scene, {3, -2, 5}, {2, 1, -1}, {1, 2, 1});
  for (const JitterProjection form : kForms)
    for (const MotionSource source : {MotionSource::Objects, MotionSource::CameraFromDepth}) {
      FrameRequest asked = as(form);
      asked.inputs.motion = source;
      for (const float value : motion(scene, asked).pixels) ASSERT_EQ(value, 0.0f) << int(form);
    }
}

TEST_F(JitterProjectionTest, ThirdColumnDrawsTheBitsOfTheTranslationWithPerspective) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {4, 1, 3}, {0, 4, 1});
  const FrameInputs translated = draw(scene, as(JitterProjection::Translation));
  const FrameInputs printed = draw(scene, as(JitterProjection::ColumnAsPrinted));
  EXPECT_EQ(test::difference(printed.color.download(), translated.color.download()), "");
  EXPECT_EQ(test::difference(printed.depth.download(), translated.depth.download()), "");
  EXPECT_EQ(test::difference(printed.objectId.download(), translated.objectId.download()), "");
}

// With the sign as printed the picture is that of the opposite jitter.
TEST_F(JitterProjectionTest, AddedAsPrintedIsTheOppositeJitter) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {4, 1, 3}, {0, 4, 1});
  const FrameInputs printed = draw(scene, as(JitterProjection::AddedAsPrinted));
  const FrameInputs opposite = draw(scene, as(JitterProjection::Translation, -kJitter));
  EXPECT_EQ(printed.info.jitterPx, kJitter) << "the resolve believes it";
  EXPECT_EQ(test::difference(printed.objectId.download(), opposite.objectId.download()), "");
  EXPECT_EQ(test::difference(printed.depth.download(), opposite.depth.download()), "");
}

// A jitter that moves near things by many pixels brings some into the picture.
TEST_F(JitterProjectionTest, CullsNothingThatAPrintedFormMovesIntoThePicture) {
  Scene scene = emptyScene();
  const float depth = 0.11f, right = depth / kP11 * kWidth / kHeight; // of the picture's border
  addQuad(scene, {right + 0.0041f, 0, 10.0f - depth}, {0.006f, 0, 0}, {0, 0.05f, 0}); // 1.4 px beyond it
  // Half a pixel of NDC is shifted by in meters: P00/0.11 times as many pixels, 4.4.
  FrameRequest asked = as(JitterProjection::RightAsPrinted, {-0.5f, 0.0f});
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameInputs culled, all;
  renderer.draw(asked, 1, culled);
  renderer.setCulling(false);
  renderer.draw(asked, 1, all);
  EXPECT_EQ(test::difference(culled.objectId.download(), all.objectId.download()), "");
  EXPECT_EQ(all.objectId.download().texel(kWidth - 1, kHeight / 2).x, 1.0f) << "it is seen";
  asked.jitter.projection = JitterProjection::Translation;
  renderer.draw(asked, 1, all);
  EXPECT_EQ(all.objectId.download().texel(kWidth - 1, kHeight / 2).x, 0.0f) << "and not without it";
}

// What is laid over the output has no jitter in any form.
// Techniques: 21.8.
TEST_F(JitterProjectionTest, LeavesTheOverlayAlone) {
  Scene scene = emptyScene();
  Material glass = scene.materials.front();
  glass.baseColor = {1.0f, 0.5f, 0.25f, 0.5f};
  glass.alphaMode = AlphaMode::Blend;
  scene.materials.push_back(glass);
  addQuad(scene, {0, 0, 0}, {4, 1, 0}, {-1, 4, 0}, 1);
  FrameRequest asked = as(JitterProjection::Translation);
  asked.inputs.blended = BlendedAs::After;
  const Image expected = draw(scene, asked).overlay.download();
  for (const JitterProjection form : kForms) {
    asked.jitter.projection = form;
    EXPECT_EQ(test::difference(draw(scene, asked).overlay.download(), expected), "") << int(form);
  }
}

} // namespace
} // namespace taa
