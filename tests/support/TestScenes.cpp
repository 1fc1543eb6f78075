// Scenes of squares, made without the loader.
#include "tests/support/TestScenes.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <numbers>

namespace taa::test {
namespace {

constexpr int kAnimatedFrames = 120;

AnimationChannel channel(const Scene& scene, int node, AnimationPath path, const glm::vec4& first,
                         const glm::vec4& last) {
  AnimationChannel made;
  made.node = node;
  made.path = path;
  made.times = {0.0f, static_cast<float>(kAnimatedFrames / scene.shot.framesPerSecond)};
  made.values = {first, last};
  return made;
}

Primitive square(float halfSize) {
  Primitive primitive;
  for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
    Vertex vertex;
    vertex.position = glm::vec3(halfSize * corner, 0.0f);
    vertex.uv0 = 0.5f * corner + 0.5f;
    primitive.vertices.push_back(vertex);
    primitive.bounds.add(vertex.position);
  }
  primitive.indices = {0, 1, 2, 0, 2, 3};
  return primitive;
}

} // namespace

TestScene::TestScene() {
  scene.name = "test";
  Material material;
  material.baseColor = {0.5f, 0.25f, 0.125f, 1.0f};
  material.unlit = true;
  material.doubleSided = true;
  scene.materials.push_back(material);
  Animation animation;
  animation.duration = static_cast<float>(2 * kAnimatedFrames / scene.shot.framesPerSecond);
  scene.animations.push_back(animation);
  SceneCamera camera;
  camera.name = "main";
  camera.fovY = std::numbers::pi_v<float> / 3.0f;
  camera.node = cameraNode = 0;
  scene.cameras.push_back(camera);
  Node node;
  node.name = "camera";
  node.camera = 0;
  scene.nodes.push_back(node);
  scene.shot.camera = "gltf:main";
  scene.bounds.add(glm::vec3(-1.0f));
  scene.bounds.add(glm::vec3(1.0f));
}

int TestScene::addSquare(const glm::vec3& center, float halfSize) {
  Mesh mesh;
  mesh.primitives.push_back(square(halfSize));
  scene.meshes.push_back(mesh);
  Node node;
  node.translation = center;
  node.mesh = static_cast<int>(scene.meshes.size()) - 1;
  scene.nodes.push_back(node);
  scene.bounds.add(center - halfSize);
  scene.bounds.add(center + halfSize);
  return static_cast<int>(scene.nodes.size()) - 1;
}

void TestScene::move(int node, const glm::vec3& perFrame) {
  const glm::vec3 start = scene.nodes[static_cast<std::size_t>(node)].translation;
  const glm::vec3 end = start + static_cast<float>(kAnimatedFrames) * perFrame;
  scene.animations[0].channels.push_back(
      channel(scene, node, AnimationPath::Translation, glm::vec4(start, 0.0f), glm::vec4(end, 0.0f)));
}

void TestScene::turn(int node, const glm::vec3& axis, float perFrame) {
  const glm::quat end = glm::angleAxis(static_cast<float>(kAnimatedFrames) * perFrame, axis);
  scene.animations[0].channels.push_back(
      channel(scene, node, AnimationPath::Rotation, {0, 0, 0, 1}, {end.x, end.y, end.z, end.w}));
}

FrameRequest stillRequest(int width, int height, const std::string& camera) {
  FrameRequest request;
  request.camera = camera;
  request.width = width;
  request.height = height;
  request.jitter.sequence = JitterSequence::None;
  request.inputs.precision = Precision::Full;
  return request;
}

FrameInputs drawFrame(const Scene& scene, const FrameRequest& request, int frame) {
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameInputs inputs;
  renderer.draw(request, frame, inputs);
  return inputs;
}

} // namespace taa::test
