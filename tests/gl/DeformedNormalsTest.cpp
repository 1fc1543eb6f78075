// Normals and tangents of what the vertex shader deforms turn with the surface.
#include "tests/support/frames/MotionFixture.h"

#include <cmath>
#include <cstddef>

namespace taa {
namespace {

using test::addQuad;
using test::emptyScene;
using test::kHeight;
using test::kWidth;

class DeformedNormalsTest : public test::MotionFixture {
 protected:
  static glm::vec3 normalInTheMiddle(const Scene& scene) {
    return glm::vec3(draw(scene, request(), 0).normal.download().texel(kWidth / 2, kHeight / 2));
  }
};

Primitive& primitiveOf(Scene& scene, int node) {
  return scene.meshes[std::size_t(scene.nodes[std::size_t(node)].mesh)].primitives[0];
}

TEST_F(DeformedNormalsTest, OfAWaveLeanAgainstItsSlope) {
  constexpr float kAmplitude = 0.5f, kWaveNumber = 1.0f, kHalf = 0.25f;
  Scene scene = emptyScene();
  const int quad = addQuad(scene, {0, 0, 0}, {2 * kHalf, 0, 0}, {0, 2 * kHalf, 0});
  for (Vertex& vertex : primitiveOf(scene, quad).vertices) vertex.uv1.y = 1.0f;
  scene.materials[0].wind = {kAmplitude, kWaveNumber, 0.0f, {0, 0, 1}};
  // z = A sin(kx): the normal is (−Ak cos kx, 0, 1), the same at corners ± ¼ m from the middle.
  const float slope = kAmplitude * kWaveNumber * std::cos(kWaveNumber * kHalf);
  const glm::vec3 expected = glm::normalize(glm::vec3(-slope, 0, 1)), normal = normalInTheMiddle(scene);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(normal[axis], expected[axis], 1e-3f); // stored as halves
  scene.materials[0].wind.amplitude = 0.0f;
  EXPECT_EQ(normalInTheMiddle(scene), glm::vec3(0, 0, 1));
}

TEST_F(DeformedNormalsTest, OfAWaveAlongTheSurfaceStay) {
  Scene scene = emptyScene();
  const int quad = addQuad(scene, {0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0});
  for (Vertex& vertex : primitiveOf(scene, quad).vertices) vertex.uv1.y = 1.0f;
  scene.materials[0].wind = {0.1f, 1.0f, 0.0f, {0, 1, 0}}; // moves within its plane
  const glm::vec3 normal = normalInTheMiddle(scene);
  EXPECT_EQ(normal.x, 0.0f);
  EXPECT_EQ(normal.y, 0.0f);
}

TEST_F(DeformedNormalsTest, FollowMorphedTangents) {
  Scene scene = emptyScene();
  scene.images.push_back({"to the right", 1, 1, {255, 128, 128, 255}}); // (1, 0, 0) of the tangents' frame
  scene.materials[0].normalTexture.image = 0;
  const int quad = addQuad(scene, {0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  Primitive& primitive = primitiveOf(scene, quad);
  // Takes the tangent from +x to +y.
  primitive.targets.emplace_back(primitive.vertices.size(), MorphDelta{{}, {}, {-1, 1, 0}});
  scene.nodes[std::size_t(quad)].firstWeight = 0;
  scene.morphWeights = {0.0f};
  EXPECT_NEAR(normalInTheMiddle(scene).x, 1.0f, 0.01f); // 128/255 is not quite the middle
  scene.morphWeights = {1.0f};
  EXPECT_NEAR(normalInTheMiddle(scene).y, 1.0f, 0.01f);
}

} // namespace
} // namespace taa
