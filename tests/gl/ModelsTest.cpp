// Every shared model that opens can be drawn: no GL error, a picture that is not empty, and no NaN.
#include "core/base/Error.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;

using ModelsTest = test::GlTest;

std::vector<fs::path> modelFiles() {
  std::vector<fs::path> files;
  const fs::path folder = fs::path(TAA_SHARED_DATA) / "models";
  if (!fs::exists(folder)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
      files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// Nothing when the file is refused, which GltfModelsTest looks after.
std::optional<Scene> open(const fs::path& file) {
  try {
    return openScene(file.string());
  } catch (const Error&) {
    return std::nullopt;
  }
}

void expectPicture(const Scene& scene, const std::string& file) {
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameRequest request;
  request.camera = "still";
  request.width = 64;
  request.height = 48;
  FrameInputs inputs;
  renderer.draw(request, 1, inputs);
  for (const gl::Texture* texture : {&inputs.color, &inputs.motion, &inputs.normal, &inputs.previousDepth})
    for (const float value : texture->download().pixels) ASSERT_TRUE(std::isfinite(value)) << file;
  const Image ids = inputs.objectId.download();
  EXPECT_TRUE(std::ranges::any_of(ids.pixels, [](float id) { return id > 0.0f; }))
      << file << " shows nothing";
  EXPECT_NO_THROW(gl::checkErrors("drawing " + file));
}

TEST_F(ModelsTest, AllDraw) {
  const std::vector<fs::path> files = modelFiles();
  if (files.empty()) GTEST_SKIP() << "no shared data at " << TAA_SHARED_DATA;
  for (const fs::path& file : files)
    if (const std::optional<Scene> scene = open(file)) expectPicture(*scene, file.string());
}

TEST_F(ModelsTest, BuiltinScenesDraw) {
  for (const BuiltinScene& builtin : builtinScenes())
    expectPicture(openScene("builtin:" + builtin.id), builtin.id);
}

} // namespace
} // namespace taa
