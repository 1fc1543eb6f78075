// What the parts of the glTF loader share while one file becomes a scene.
#pragma once

#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/Scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace taa {

struct GltfContext {
  const tinygltf::Model& model;
  Scene& scene;
  const std::vector<std::string>& imageFaults; ///< GltfDocument's
  std::vector<int>
      sceneNode{}; ///< for each node of the file its index in the scene, −1 when that scene leaves it out
  std::vector<bool>
      posedOnly{}; ///< for each node of the file: outside the shown scene, it moves a skin or a node in it
  std::size_t vertices = 0; ///< made so far
  std::size_t indices = 0;  ///< made so far

  bool isPosedOnly(std::size_t node) const { return node < posedOnly.size() && posedOnly[node]; }

  /// Adds a sentence for the user, once; of very many only the first.
  void warn(const std::string& text) {
    const std::string sentence = shownLine(text);
    constexpr std::size_t kMaxWarnings = 20;
    if (scene.warnings.size() > kMaxWarnings) return;
    for (const std::string& known : scene.warnings)
      if (known == sentence) return;
    const bool isOneMore = scene.warnings.size() == kMaxWarnings;
    scene.warnings.push_back(isOneMore ? say<"There is more to say of the file.">() : sentence);
  }
};

inline float toFloat(double value) {
  return static_cast<float>(value);
}

} // namespace taa
