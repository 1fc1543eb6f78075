#include "tests/fuzz/OpenGltf.h"

#include "core/base/ShownText.h"
#include "core/scene/Pose.h"
#include "core/scene/SceneCost.h"
#include "core/scene/gltf/GltfLoader.h"
#include "tests/fuzz/Fuzz.h"

#include <cmath>
#include <string>

namespace taa::fuzz {

namespace {

/// Small, so that a run takes a moment; it is the budget that a larger scene is refused by.
constexpr SceneBudget kSmallBudget{.triangles = 100'000, .bytes = std::uint64_t(32) << 20};

void askScene(const Scene& scene) {
  const SceneCost cost = costOf(scene);
  require(cost.triangles <= kSmallBudget.triangles && cost.bytes <= kSmallBudget.bytes,
          "a scene beyond the budget is opened");
  for (const std::string& warning : scene.warnings)
    require(isPlainText(warning), "a warning is not one plain line: " + warning);
  for (const double seconds : {0.0, 0.7})
    for (const std::string& camera : cameraNames(scene)) cameraAt(scene, camera, seconds, 1.5f);
  for (int axis = 0; axis < 3; ++axis)
    require(scene.bounds.isEmpty() || std::isfinite(scene.bounds.max[axis] - scene.bounds.min[axis]),
            "the scene's bounds are not finite");
}

} // namespace

void openGltf(const char* name, const std::uint8_t* bytes, std::size_t count) {
  const std::string file = fileOf(name, bytes, count);
  readsOrRefuses("cannot open " + file + ": ", [&] { askScene(loadGltf(file, {}, {}, kSmallBudget)); });
}

} // namespace taa::fuzz
