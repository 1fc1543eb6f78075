// Reading one primitive of a glTF file: what counts towards the vertices that a scene may have.
#include "core/scene/gltf/GltfPrimitive.h"

#include "core/scene/Scene.h"
#include "core/scene/gltf/GltfContext.h"

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cstddef>
#include <string>
#include <vector>

namespace taa {

// Without normals its triangles share no vertices: three corners are three vertices, not six.
TEST(GltfPrimitive, CountsFlatTrianglesByTheirCorners) {
  tinygltf::Model model;
  tinygltf::Accessor zeros; // of no bufferView
  zeros.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  zeros.type = TINYGLTF_TYPE_VEC3;
  zeros.count = 3;
  model.accessors.push_back(zeros);
  tinygltf::Primitive triangle;
  triangle.attributes["POSITION"] = 0;
  Scene scene;
  scene.materials.emplace_back();
  const std::vector<std::string> faults;
  GltfContext context{model, scene, faults};
  context.vertices = 19'999'995;
  EXPECT_EQ(readPrimitive(context, triangle).vertices.size(), 3u);
  EXPECT_EQ(context.vertices, 19'999'998u);
}

} // namespace taa
