// Tests of opening glTF files made by the test: what they mean.
#include "core/base/Progress.h"
#include "core/scene/Deform.h"
#include "core/scene/Pose.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"
#include "tests/support/frames/GltfSample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::GltfSample;
using test::morphSample;

TEST(GltfLoader, ReadsTheWholeSampleFromBothContainers) {
  GltfSample sample;
  for (const fs::path& file : {sample.writeEmbedded("whole"), sample.writeBinary("whole")}) {
    const Scene scene = openScene(file.string());
    EXPECT_EQ(scene.name, file.filename().string());
    ASSERT_EQ(scene.nodes.size(), 5u);
    EXPECT_EQ(scene.nodes[0].scale, glm::vec3(1, -1, 1));
    EXPECT_EQ(scene.nodes[1].parent, 0);
    ASSERT_EQ(scene.meshes.size(), 1u); // shared by the skinned node and the other
    const Primitive& triangle = scene.meshes[std::size_t(scene.nodes[1].mesh)].primitives.at(0);
    EXPECT_EQ(triangle.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(triangle.vertices[1].position, glm::vec3(1, 0, 0));
    EXPECT_EQ(triangle.vertices[1].normal, glm::vec3(0, 0, 1)) << "made flat";
    EXPECT_EQ(triangle.vertices[1].tangent, glm::vec4(1, 0, 0, 1)) << "u grows along x, v falls along y";
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].rgba.size(), 4u);
    EXPECT_EQ(scene.bounds.min, glm::vec3(0, -3, 0)) << "the skinned triangle, moved by its joint";
  }
}

TEST(GltfLoader, ReadsMaterialsCamerasAndLights) {
  const Scene scene = openScene(GltfSample().writeEmbedded("parts").string());
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.metallic, 0.25f);
  EXPECT_EQ(material.roughness, 1.0f);
  EXPECT_EQ(material.normalScale, 2.0f);
  EXPECT_EQ(material.alphaMode, AlphaMode::Mask);
  EXPECT_EQ(material.alphaCutoff, 0.25f);
  EXPECT_EQ(material.baseColorTexture.image, 0);
  EXPECT_EQ(material.emissiveTexture.image, -1);
  EXPECT_EQ(material.baseColorTexture.sampler.magnify, Filter::Nearest);
  EXPECT_EQ(material.baseColorTexture.sampler.wrapU, Wrap::ClampToEdge);
  EXPECT_EQ(material.baseColorTexture.sampler.wrapV, Wrap::Repeat);
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].fovY, 0.9f);
  EXPECT_EQ(scene.cameras[0].nearPlane, 0.1f);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::Spot);
  EXPECT_EQ(scene.lights[0].intensity, 5.0f);
  EXPECT_EQ(scene.lights[0].outerConeAngle, 0.5f);
  EXPECT_FALSE(scene.sky.sunEnabled) << "the file brings its own light";
}

TEST(GltfLoader, LooksThroughTheOnlyCameraThatAFileHas) {
  GltfSample sample;
  EXPECT_EQ(openScene(sample.writeEmbedded("eye").string()).shot.camera, "gltf:eye")
      << "as its node is called";
  sample.json["cameras"][0]["name"] = "lens";
  EXPECT_EQ(openScene(sample.writeEmbedded("lens").string()).shot.camera, "gltf:lens");
  sample.json["nodes"].push_back({{"name", "other"}, {"camera", 0}});
  sample.json["scenes"][0]["nodes"].push_back(5);
  const Scene several = openScene(sample.writeEmbedded("several").string());
  EXPECT_EQ(several.shot.camera, Scene().shot.camera) << "nothing says which of two";
}

// Point lights of 1 to 70 cd behind a sun of 0.001 lx, which has no place to be weighed by, and the file's
// spot light of 5 cd, whose color has a luminance of 0.57.
TEST(GltfLoader, DrawsTheStrongestOfMoreLightsThanItCanAndSaysSo) {
  GltfSample sample;
  const auto addLight = [&](const char* type, double intensity) {
    nlohmann::json& lights = sample.json["extensions"]["KHR_lights_punctual"]["lights"];
    const std::size_t index = lights.size();
    lights.push_back({{"type", type}, {"intensity", intensity}});
    const std::size_t node = sample.json["nodes"].size();
    sample.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", index}}}}}});
    sample.json["scenes"][0]["nodes"].push_back(node);
  };
  for (int candela = 70; candela > 0; --candela) addLight("point", candela);
  addLight("directional", 0.001);
  const Scene scene = openScene(sample.writeEmbedded("lamps").string());
  ASSERT_EQ(scene.lights.size(), 64u);
  EXPECT_EQ(scene.lights.front().intensity, 70.0f);
  EXPECT_EQ(scene.lights[62].intensity, 8.0f) << "63 of 70 cd and below, not the spot light's 2.9";
  EXPECT_EQ(scene.lights[63].kind, LightKind::Directional);
  for (std::size_t index = 0; index < scene.lights.size(); ++index)
    EXPECT_EQ(scene.nodes[static_cast<std::size_t>(scene.lights[index].node)].light, static_cast<int>(index));
  EXPECT_EQ(std::ranges::count_if(scene.nodes, [](const Node& node) { return node.light >= 0; }), 64);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], "The file has 72 lights; the 64 strongest are drawn, directional ones first.");
}

TEST(GltfLoader, PlaysTheAnimationAndFitsTheShotToIt) {
  const Scene scene = openScene(GltfSample().writeEmbedded("animated").string());
  ASSERT_EQ(scene.animations.size(), 1u);
  EXPECT_EQ(scene.animations[0].duration, 1.0f);
  EXPECT_EQ(scene.shot.frames, 240);
  EXPECT_EQ(glm::vec3(poseAt(scene, 0.25).worldFromNode[1][3]), glm::vec3(0, -1, 0))
      << "under a mirrored parent";
}

/// With a second animation, which moves the triangle along x by 6 in 3 seconds, and a third without a name.
GltfSample severalAnimations() {
  GltfSample sample;
  const int times = sample.addFloats({0, 3}, "SCALAR"), places = sample.addFloats({0, 0, 0, 6, 0, 0}, "VEC3");
  json& animations = sample.json["animations"];
  animations[0]["name"] = "up";
  animations.push_back(animations[0]);
  animations[1]["name"] = "along";
  animations[1]["samplers"][0] = {{"input", times}, {"output", places}};
  animations.push_back(animations[0]);
  animations[2].erase("name");
  animations[2]["channels"][0]["target"]["node"] = 3; // the joint
  return sample;
}

TEST(GltfLoader, PlaysTheAnimationThatIsChosen) {
  const std::string file = severalAnimations().writeEmbedded("several").string();
  const Scene first = openScene(file), chosen = openScene(file, {}, {.animation = "along"});
  EXPECT_EQ(first.animationNames, (std::vector<std::string>{"up", "along", "#3"}));
  EXPECT_EQ(chosen.animationNames, first.animationNames);
  ASSERT_EQ(first.warnings.size(), 1u);
  EXPECT_EQ(first.warnings[0], "The file has 3 animations; the first, \"up\", plays.");
  EXPECT_TRUE(chosen.warnings.empty());
  EXPECT_EQ(glm::vec3(poseAt(first, 0.5).worldFromNode[1][3]), glm::vec3(0, -2, 0));
  EXPECT_EQ(glm::vec3(poseAt(chosen, 1.5).worldFromNode[1][3]), glm::vec3(3, 0, 0));
  EXPECT_EQ(first.shot.frames, 240) << "four runs of a second";
  EXPECT_EQ(chosen.shot.frames, 360) << "two runs of three seconds";
  EXPECT_EQ(glm::vec3(poseAt(openScene(file, {}, {.animation = "#3"}), 0.5).worldFromNode[3][3]),
            glm::vec3(0, -2, 0))
      << "instead of the joint's own place";
}

TEST(GltfLoader, PlaysAllAnimationsAtOnceEachInItsLoop) {
  const std::string file = severalAnimations().writeEmbedded("all").string();
  const Scene all = openScene(file, {}, {.animation = "all"});
  EXPECT_EQ(all.shot.frames, 360) << "of the longest";
  const Pose pose = poseAt(all, 3.5); // half a second into each run
  EXPECT_EQ(glm::vec3(pose.worldFromNode[1][3]), glm::vec3(1, 0, 0)) << "the later one moves it";
  EXPECT_EQ(glm::vec3(pose.worldFromNode[3][3]), glm::vec3(0, -2, 0));
}

TEST(GltfLoader, NamesTheAnimationsThereAre) {
  const std::string file = severalAnimations().writeEmbedded("none").string();
  EXPECT_EQ(test::errorOf([&] { openScene(file, {}, {.animation = "walk\n"}); }),
            "cannot open " + file + ": it has no animation called \"walk?\"; there are up, along, #3, all");
  EXPECT_EQ(test::errorOf([] { openScene("builtin:fan", {}, {.animation = "all"}); }),
            "builtin:fan has one animation; only of a file's can one be chosen");
}

TEST(GltfLoader, PosesASkinByJointsOutsideTheScene) {
  GltfSample sample;
  json& nodes = sample.json["nodes"];
  nodes[0]["children"] = {1, 2}; // the joint is no child of the scene's any more, but of a root beside it
  nodes.push_back({{"name", "armature"}, {"translation", {5, 0, 0}}, {"children", {3}}, {"mesh", 0}});
  const Scene scene = openScene(sample.writeEmbedded("outside").string());
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
  const auto skinned = std::ranges::find(scene.nodes, 0, &Node::skin);
  ASSERT_NE(skinned, scene.nodes.end());
  const Primitive& primitive = scene.meshes[std::size_t(skinned->mesh)].primitives.at(0);
  const Deformer deformer(scene, static_cast<int>(skinned - scene.nodes.begin()), primitive,
                          poseAt(scene, 0.0), 0.0);
  EXPECT_EQ(deformer.position(2), glm::vec3(5, 3, 0)) << "(0, 1, 0) moved by joint and armature";
  EXPECT_EQ(std::ranges::count_if(scene.nodes, [](const Node& node) { return node.mesh >= 0; }), 2)
      << "the armature's own mesh is not in the scene";
}

// As exporters of whole kits write it: every node is named, or only a child.
TEST(GltfLoader, DrawsOnceWhatASceneNamesThatIsNoRoot) {
  const auto opened = [](const json& named) {
    GltfSample sample;
    sample.json["nodes"][0]["translation"] = {7, 0, 0};
    sample.json["scenes"][0]["nodes"] = named;
    return openScene(sample.writeEmbedded("named").string());
  };
  const auto meshesOf = [](const Scene& scene) {
    return std::ranges::count_if(scene.nodes, [](const Node& node) { return node.mesh >= 0; });
  };
  const Scene roots = opened({0, 4});
  for (const json& named : {json({0, 1, 4}), json({1, 0, 4})}) {
    const Scene all = opened(named);
    EXPECT_EQ(all.nodes.size(), roots.nodes.size()) << named;
    EXPECT_EQ(meshesOf(all), meshesOf(roots)) << named;
    EXPECT_EQ(all.bounds.min, roots.bounds.min) << named;
    ASSERT_FALSE(all.warnings.empty());
    EXPECT_NE(all.warnings[0].find("The scene names nodes[1], which is a child of nodes[0] and no root"),
              std::string::npos)
        << all.warnings[0];
  }
  const Scene child = opened({1});
  const auto drawn = std::ranges::find_if(child.nodes, [](const Node& node) { return node.mesh >= 0; });
  ASSERT_NE(drawn, child.nodes.end());
  const glm::mat4 pose =
      poseAt(child, 0.0).worldFromNode[static_cast<std::size_t>(drawn - child.nodes.begin())];
  EXPECT_EQ(pose[3].x, 7.0f) << "where its parent puts it";
}

TEST(GltfLoader, SkinsVerticesByTheirJoints) {
  const Scene scene = openScene(GltfSample().writeEmbedded("skinned").string());
  ASSERT_EQ(scene.skins.size(), 1u);
  const auto skinnedNode = std::ranges::find(scene.nodes, 0, &Node::skin);
  ASSERT_NE(skinnedNode, scene.nodes.end());
  EXPECT_EQ(skinnedNode->name, "skinned");
  const Primitive& primitive = scene.meshes[std::size_t(skinnedNode->mesh)].primitives.at(0);
  ASSERT_EQ(primitive.influenceSets, 1);
  // The joint is 2 up under a parent that mirrors y.
  const Pose pose = poseAt(scene, 0.0);
  const Deformer deformer(scene, static_cast<int>(skinnedNode - scene.nodes.begin()), primitive, pose, 0.0);
  EXPECT_EQ(deformer.position(2), glm::vec3(0, -3, 0));
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
}

TEST(GltfLoader, MorphsByTheWeightsOfMeshNodeAndAnimation) {
  GltfSample sample = morphSample("LINEAR", {0.25f, 0.75f});
  const Scene scene = openScene(sample.writeEmbedded("morphed").string());
  const Node& node = scene.nodes[1];
  ASSERT_GE(node.firstWeight, 0);
  EXPECT_EQ(scene.morphWeights[std::size_t(node.firstWeight)], 0.5f) << "the mesh's";
  EXPECT_EQ(poseAt(scene, 0.5).morphWeights[std::size_t(node.firstWeight)], 0.5f);
  EXPECT_EQ(poseAt(scene, 0.75).morphWeights[std::size_t(node.firstWeight)], 0.625f);
  const Primitive& primitive = scene.meshes[std::size_t(node.mesh)].primitives.at(0);
  ASSERT_EQ(primitive.targets.size(), 1u);
  ASSERT_EQ(primitive.targets[0].size(), primitive.vertices.size());
  const Pose pose = poseAt(scene, 0.75);
  const Deformer deformer(scene, 1, primitive, pose, 0.0);
  const glm::vec3 plain(pose.worldFromNode[1] * glm::vec4(primitive.vertices[1].position, 1.0f));
  EXPECT_EQ(deformer.position(1) - plain, glm::vec3(pose.worldFromNode[1] * glm::vec4(0, 0, 1.25f, 0)));
  sample.json["nodes"][1]["weights"] = {0.125};
  EXPECT_EQ(openScene(sample.writeEmbedded("morphed").string()).morphWeights[std::size_t(node.firstWeight)],
            0.125f)
      << "the node's own";
}

TEST(GltfLoader, GivesMorphTargetsWithoutNormalsThoseOfTheMovedFaces) {
  const Scene scene = openScene(morphSample("LINEAR", {0.25f, 0.75f}).writeEmbedded("flat").string());
  const Primitive& primitive = scene.meshes[std::size_t(scene.nodes[1].mesh)].primitives.at(0);
  for (const MorphDelta& delta : primitive.targets.at(0)) {
    const glm::vec3 normal = primitive.vertices[0].normal + delta.normal;
    EXPECT_NEAR(normal.x, -2.0f / std::sqrt(5.0f), 1e-6f) << "corner 1 was lifted by 2";
    EXPECT_NEAR(normal.z, 1.0f / std::sqrt(5.0f), 1e-6f);
  }
}

TEST(GltfLoader, ReadsWhatMorphTargetsDoToNormalsAndTangents) {
  GltfSample sample = morphSample("LINEAR", {0.25f, 0.75f});
  nlohmann::json& target = sample.json["meshes"][0]["primitives"][0]["targets"][0];
  target["TANGENT"] = sample.addFloats({1, 0, 0, 0, 2, 0, 0, 0, 3}, "VEC3");
  const Scene scene = openScene(sample.writeEmbedded("tangents").string());
  const std::vector<MorphDelta>& deltas =
      scene.meshes[std::size_t(scene.nodes[1].mesh)].primitives.at(0).targets.at(0);
  EXPECT_EQ(deltas[0].tangent, glm::vec3(1, 0, 0));
  EXPECT_EQ(deltas[1].tangent, glm::vec3(0, 2, 0));
  EXPECT_EQ(deltas[2].tangent, glm::vec3(0, 0, 3));
}

TEST(GltfLoader, AnimatesMorphWeightsByStepsAndSplines) {
  const auto weightAt = [](const char* interpolation, const std::vector<float>& weights, double time) {
    const Scene scene = openScene(morphSample(interpolation, weights).writeEmbedded("weights").string());
    return poseAt(scene, time).morphWeights[std::size_t(scene.nodes[1].firstWeight)];
  };
  EXPECT_EQ(weightAt("STEP", {0.25f, 0.75f}, 0.75), 0.25f);
  // In-tangent, value, out-tangent: the Hermite basis at ½ is ½, ⅛, ½, −⅛.
  EXPECT_EQ(weightAt("CUBICSPLINE", {0, 1, 2, 4, 0, 0}, 0.5), 0.5f * 1 + 0.125f * 2 + 0.5f * 0 - 0.125f * 4);
}

TEST(GltfLoader, TakesVelocitiesForTheCacheOfOneFrame) {
  GltfSample sample;
  sample.json["meshes"][0]["primitives"][0]["attributes"]["_VELOCITY"] =
      sample.addFloats({1, 0, 0, 0, 2, 0, 0, 0, 3}, "VEC3");
  const Scene scene = openScene(sample.writeEmbedded("velocity").string());
  const Node& node = scene.nodes[1];
  const Primitive& primitive = scene.meshes[std::size_t(node.mesh)].primitives.at(0);
  ASSERT_EQ(primitive.cache.frames, 1);
  EXPECT_EQ(primitive.cache.entries[1].position, primitive.vertices[1].position);
  EXPECT_EQ(primitive.cache.entries[1].velocity, glm::vec3(0, 2, 0));
  const Pose pose = poseAt(scene, 0.0);
  const Deformer now(scene, 1, primitive, pose, 0.0), before(scene, 1, primitive, pose, 0.0, 0.25);
  EXPECT_EQ(now.position(1) - before.position(1),
            glm::vec3(pose.worldFromNode[1] * glm::vec4(0, 0.5f, 0, 0)));
}

TEST(GltfLoader, UnrollsEveryPrimitiveMode) {
  struct Case {
    int mode;
    Topology topology;
    std::vector<std::uint32_t> indices;
  };
  const Case cases[] = {{0, Topology::Points, {0, 1, 2, 3, 4}},
                        {1, Topology::Lines, {0, 1, 2, 3}},
                        {2, Topology::Lines, {0, 1, 1, 2, 2, 3, 3, 4, 4, 0}},
                        {3, Topology::Lines, {0, 1, 1, 2, 2, 3, 3, 4}},
                        {4, Topology::Triangles, {0, 1, 2}},
                        {5, Topology::Triangles, {0, 1, 2, 1, 3, 2, 2, 3, 4}},
                        {6, Topology::Triangles, {1, 2, 0, 2, 3, 0, 3, 4, 0}}};
  for (const Case& expected : cases) {
    GltfSample sample;
    json attributes;
    attributes["POSITION"] = sample.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, "VEC3");
    attributes["NORMAL"] = sample.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    sample.json["meshes"][0]["primitives"][0] = {{"attributes", attributes}, {"mode", expected.mode}};
    sample.json["nodes"][4].erase("skin");
    const Scene scene = openScene(sample.writeEmbedded("mode").string());
    const Primitive& primitive = scene.meshes.at(0).primitives.at(0);
    EXPECT_EQ(primitive.topology, expected.topology) << expected.mode;
    EXPECT_EQ(primitive.indices, expected.indices) << expected.mode;
  }
}

TEST(GltfLoader, ReadsNormalizedAndQuantizedComponents) {
  GltfSample sample;
  const std::int8_t positions[12] = {0, 0, 0, 0, 64, 0, 0, 0, -128, 127, 0, 0}; // stride 4
  const std::uint16_t colors[12] = {65535, 0, 0, 65535, 0, 0, 0, 0, 0, 0, 0, 13107};
  json& accessors = sample.json["accessors"];
  accessors[0] = {{"bufferView", sample.addView(positions, 12)},
                  {"componentType", 5120},
                  {"count", 3},
                  {"type", "VEC3"},
                  {"normalized", true}};
  sample.json["bufferViews"].back()["byteStride"] = 4;
  accessors.push_back({{"bufferView", sample.addView(colors, 24)},
                       {"componentType", 5123},
                       {"count", 3},
                       {"type", "VEC4"},
                       {"normalized", true}});
  sample.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = accessors.size() - 1;
  sample.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const Scene scene = openScene(sample.writeEmbedded("quantized").string());
  const std::vector<Vertex>& vertices = scene.meshes.at(0).primitives.at(0).vertices;
  EXPECT_EQ(vertices[1].position, glm::vec3(64.0f / 127.0f, 0, 0));
  EXPECT_EQ(vertices[2].position, glm::vec3(-1, 1, 0)) << "-128 counts as -127";
  EXPECT_EQ(vertices[0].color, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(vertices[2].color, glm::vec4(0, 0, 0, 13107.0f / 65535.0f));
}

TEST(GltfLoader, PutsSparseValuesOverTheOthers) {
  GltfSample sample;
  const std::uint8_t which[4] = {2};
  const float where[3] = {7, 8, 9};
  const int indices = sample.addView(which, 1), values = sample.addView(where, 12);
  sample.json["accessors"][0]["sparse"] = {{"count", 1},
                                           {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                           {"values", {{"bufferView", values}}}};
  const Scene scene = openScene(sample.writeEmbedded("sparse").string());
  const std::vector<Vertex>& vertices = scene.meshes.at(0).primitives.at(0).vertices;
  EXPECT_EQ(vertices[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(vertices[2].position, glm::vec3(7, 8, 9));
}

TEST(GltfLoader, ReadsTextureTransformEmissiveStrengthAndUnlit) {
  GltfSample sample;
  json& material = sample.json["materials"][0];
  material["emissiveFactor"] = {0.5, 0.25, 0};
  material["extensions"] = {{"KHR_materials_unlit", json::object()},
                            {"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}};
  material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.25, 0.5}}, {"scale", {2, 4}}, {"rotation", 0}, {"texCoord", 1}};
  material["normalTexture"]["extensions"]["KHR_texture_transform"] = {{"rotation", 1.5707963}};
  const Material read = openScene(sample.writeEmbedded("extended").string()).materials.at(0);
  EXPECT_TRUE(read.unlit);
  EXPECT_EQ(read.emissive, glm::vec3(4, 2, 0));
  EXPECT_EQ(read.baseColorTexture.uvSet, 1);
  EXPECT_EQ(read.baseColorTexture.uvFromUv * glm::vec3(1, 1, 1), glm::vec3(2.25f, 4.5f, 1));
  const glm::vec3 turned =
      read.normalTexture.uvFromUv * glm::vec3(1, 0, 1); // counter-clockwise: u points up, to −v
  EXPECT_NEAR(turned.x, 0.0f, 1e-6f);
  EXPECT_NEAR(turned.y, -1.0f, 1e-6f);
}

TEST(GltfLoader, ReadsInstancesOfANode) {
  GltfSample sample;
  const int places = sample.addFloats({1, 0, 0, 2, 0, 0, 3, 0, 0}, "VEC3");
  const int scales = sample.addFloats({1, 1, 1, 2, 3, 4, 1, -1, 1}, "VEC3");
  // Half turns about x, y and z; longer than 1.
  const int turns = sample.addFloats({2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}, "VEC4");
  sample.json["nodes"][1]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", places}, {"SCALE", scales}, {"ROTATION", turns}};
  const Scene scene = openScene(sample.writeEmbedded("instanced").string());
  EXPECT_EQ(scene.nodes.size(), GltfSample().json["nodes"].size()) << "they are no nodes";
  const Node& node = scene.nodes[1];
  EXPECT_EQ(node.timesDrawn(), 3);
  ASSERT_EQ(node.firstInstance, 0);
  // Columns: axes, then the place.
  ASSERT_EQ(scene.instances.size(), 3u);
  EXPECT_EQ(scene.instances[0], glm::mat4x3(1, 0, 0, 0, -1, 0, 0, 0, -1, 1, 0, 0));
  EXPECT_EQ(scene.instances[1], glm::mat4x3(-2, 0, 0, 0, 3, 0, 0, 0, -4, 2, 0, 0));
  EXPECT_EQ(scene.instances[2], glm::mat4x3(-1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 0));
}

TEST(GltfLoader, OpensFilesBesideItThroughPercentEncodedNames) {
  GltfSample sample;
  test::writeTemporary("sub folder/data ü.bin", sample.buffer + "padding");
  sample.json["buffers"][0]["uri"] = "sub%20folder/data%20%C3%BC.bin";
  EXPECT_NO_THROW(openScene(test::writeTemporary("external.gltf", sample.json.dump()).string()));
}

TEST(GltfLoader, OpensFilesBesideItWhateverTheyAreCalled) {
  GltfSample sample;
  for (const std::string name : {"a+b.bin", "$HOME ~ `id`.bin", "*.bin"}) {
    test::writeTemporary("named/" + name, sample.buffer);
    sample.json["buffers"][0]["uri"] = name;
    EXPECT_TRUE(
        openScene(test::writeTemporary("named/it.gltf", sample.json.dump()).string()).warnings.empty())
        << name;
  }
}

TEST(GltfLoader, SaysWhatNoCameraAndNoLightCanBe) {
  GltfSample sample;
  sample.json["nodes"][0]["camera"] = 0;
  sample.json["cameras"] = {
      {{"name", "slit"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.0}, {"znear", 0.1}}}}};
  const Scene slit = openScene(sample.writeEmbedded("slit").string());
  EXPECT_EQ(slit.warnings,
            std::vector<std::string>{
                "The camera \"slit\" has a size or a plane that none can have; the nearest is taken."});
  EXPECT_FLOAT_EQ(slit.cameras.at(0).fovY, 0.01f);
  sample.json["cameras"][0]["perspective"] = {{"yfov", 0.8}, {"znear", 0.1}};
  EXPECT_TRUE(openScene(sample.writeEmbedded("slit").string()).warnings.empty());
  for (const nlohmann::json& change :
       {nlohmann::json{{"intensity", -1.0}}, nlohmann::json{{"color", {1.0, -0.5, 1.0}}},
        nlohmann::json{{"range", -3.0}},
        nlohmann::json{{"spot", {{"innerConeAngle", 0.9}, {"outerConeAngle", 0.5}}}},
        nlohmann::json{{"spot", {{"outerConeAngle", 2.0}}}}}) {
    GltfSample dark;
    nlohmann::json& light = dark.json["extensions"]["KHR_lights_punctual"]["lights"][0];
    light.update(change);
    light["name"] = "lamp";
    EXPECT_EQ(
        openScene(dark.writeEmbedded("dark").string()).warnings,
        std::vector<std::string>{"The light \"lamp\" has values that none can have; the nearest are taken."})
        << change;
  }
}

TEST(GltfLoader, SaysWhatNoAlphaModeIs) {
  GltfSample sample;
  sample.json["materials"][0]["name"] = "paint";
  sample.json["materials"][0]["alphaMode"] = "blend";
  const Scene scene = openScene(sample.writeEmbedded("mode").string());
  EXPECT_EQ(scene.warnings,
            std::vector<std::string>{
                "The material \"paint\" has an alphaMode that is none, \"blend\"; it is drawn as OPAQUE."});
  EXPECT_EQ(scene.materials.at(0).alphaMode, AlphaMode::Opaque);
}

TEST(GltfLoader, TakesBackslashesForSlashesAndSaysSo) {
  GltfSample sample;
  test::writeTemporary("back/sub/slash.bin", sample.buffer);
  sample.json["buffers"][0]["uri"] = "sub\\slash.bin";
  const Scene scene = openScene(test::writeTemporary("back/it.gltf", sample.json.dump()).string());
  EXPECT_EQ(scene.warnings,
            std::vector<std::string>{"Backslashes in the names of its files are taken for slashes."});
}

TEST(GltfLoader, TakesWhatMovesACursorOutOfNames) {
  GltfSample sample;
  sample.json["nodes"][0]["name"] = "a\nb\x1b[2J";
  EXPECT_EQ(openScene(sample.writeEmbedded("named").string()).nodes[0].name, "a?b?[2J");
}

TEST(GltfLoader, ReportsProgressAndStopsWhenAsked) {
  const std::string file = GltfSample().writeEmbedded("stopped").string();
  int calls = 0;
  openScene(file, [&](std::string_view, int, int) { return ++calls > 0; });
  EXPECT_GE(calls, 3);
  EXPECT_THROW(openScene(file, [](std::string_view, int, int) { return false; }), Cancelled);
}

} // namespace
} // namespace taa
