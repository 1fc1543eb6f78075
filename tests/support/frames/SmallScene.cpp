#include "tests/support/frames/SmallScene.h"

#include <array>

namespace taa::test {

Scene emptyScene() {
  Scene scene;
  scene.name = "test";
  scene.shot.frames = 16;
  scene.shot.framesPerSecond = 60.0;
  scene.shot.camera = kEye;
  scene.sky.sunEnabled = false;
  scene.nodes.resize(1);
  scene.nodes[0].translation = {0.0f, 0.0f, 10.0f};
  scene.nodes[0].camera = 0;
  SceneCamera camera;
  camera.name = "eye";
  camera.node = 0;
  camera.fovY = 1.04719755f; // 60°
  camera.nearPlane = 0.1f;
  scene.cameras.push_back(camera);
  Material material;
  material.name = "white";
  material.unlit = true;
  scene.materials.push_back(material);
  scene.bounds.add(glm::vec3(-1.0f));
  scene.bounds.add(glm::vec3(1.0f));
  return scene;
}

int addQuad(Scene& scene, const glm::vec3& center, const glm::vec3& right, const glm::vec3& up,
            int material) {
  Primitive primitive;
  primitive.material = material;
  const std::array<glm::vec2, 4> corners{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}}; // uv, counter-clockwise
  for (const glm::vec2& uv : corners) {
    Vertex vertex;
    vertex.position = (uv.x - 0.5f) * right + (0.5f - uv.y) * up;
    vertex.normal = glm::normalize(glm::cross(right, up));
    vertex.tangent = glm::vec4(glm::normalize(right), 1.0f);
    vertex.uv0 = vertex.uv1 = uv;
    primitive.bounds.add(vertex.position);
    primitive.vertices.push_back(vertex);
  }
  primitive.indices = {0, 1, 2, 0, 2, 3};
  scene.meshes.push_back({"quad", {primitive}});
  Node node;
  node.name = "quad";
  node.translation = center;
  node.mesh = static_cast<int>(scene.meshes.size()) - 1;
  scene.nodes.push_back(node);
  return static_cast<int>(scene.nodes.size()) - 1;
}

int addColor(Scene& scene, const glm::vec4& baseColor) {
  Material material = scene.materials.front();
  material.baseColor = baseColor;
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

void jump(Scene& scene, int node, AnimationPath path, const glm::vec4& before, const glm::vec4& after) {
  if (scene.animations.empty()) scene.animations.push_back({"jump", 1000.0f, {}});
  const float between = 0.5f / static_cast<float>(scene.shot.framesPerSecond);
  scene.animations.front().channels.push_back(
      {node, path, Interpolation::Step, {0.0f, between}, {before, after}});
}

} // namespace taa::test
