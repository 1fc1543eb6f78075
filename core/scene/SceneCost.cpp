#include "core/scene/SceneCost.h"

#include "core/base/Say.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

namespace taa {

namespace {

constexpr std::uint64_t kMillion = 1'000'000, kBytesOfMiB = std::uint64_t(1) << 20;
constexpr std::uint64_t kVectorBytes = 16; // of storage blocks, which hold vectors of four floats

std::uint64_t countIn(const auto& list) {
  return list.size();
}

PrimitiveSize sizeOfPrimitive(const Primitive& primitive) {
  // Without either there is nothing to draw and nothing is made.
  const bool isEmpty = primitive.vertices.empty() || primitive.indices.empty();
  return {isEmpty ? 0 : countIn(primitive.vertices), isEmpty ? 0 : countIn(primitive.indices),
          countIn(primitive.influences), countIn(primitive.targets) * countIn(primitive.vertices),
          countIn(primitive.cache.entries)};
}

/// A texture of four bytes a texel with all its levels.
std::uint64_t mippedBytes(const SceneImage& image) {
  std::uint64_t bytes = 0;
  for (int width = image.width, height = image.height;;
       width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
    bytes += std::uint64_t(4) * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (width <= 1 && height <= 1) return bytes;
  }
}

/// An image that is read both as a color and as numbers is there twice.
std::uint64_t bytesOfImages(const Scene& scene) {
  std::set<std::pair<int, bool>> textures; // image, and whether it holds colors
  for (const Material& material : scene.materials) {
    for (const TextureSlot* slot : {&material.baseColorTexture, &material.emissiveTexture})
      textures.insert({slot->image, true});
    for (const TextureSlot* slot :
         {&material.metallicRoughnessTexture, &material.normalTexture, &material.occlusionTexture})
      textures.insert({slot->image, false});
  }
  std::uint64_t bytes = 0;
  for (const auto& [image, isColor] : textures)
    if (image >= 0) bytes += mippedBytes(scene.images[static_cast<std::size_t>(image)]);
  return bytes;
}

/// The whole number of units that holds all of it.
std::uint64_t unitsHolding(std::uint64_t count, std::uint64_t unit) {
  return count / unit + (count % unit != 0 ? 1 : 0);
}

} // namespace

SceneBudget sceneBudget(int millions, int mib) {
  return {static_cast<std::uint64_t>(millions) * kMillion, static_cast<std::uint64_t>(mib) * kBytesOfMiB};
}

std::uint64_t cappedProduct(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  return b != 0 && a > kMost / b ? kMost : a * b;
}

std::uint64_t cappedSum(std::uint64_t a, std::uint64_t b) {
  return a + std::min(b, std::numeric_limits<std::uint64_t>::max() - a);
}

std::uint64_t PrimitiveSize::bytes() const {
  constexpr std::uint64_t kVectorsOfInfluence = 2, kVectorsOfDelta = 3, kVectorsOfEntry = 3;
  const std::uint64_t vectors =
      kVectorsOfInfluence * influences + kVectorsOfDelta * deltas + kVectorsOfEntry * cacheEntries;
  return vertices * sizeof(Vertex) + indices * sizeof(std::uint32_t) + kVectorBytes * vectors;
}

SceneCost costOf(const Scene& scene) {
  SceneCost cost;
  for (const Mesh& mesh : scene.meshes)
    for (const Primitive& primitive : mesh.primitives) {
      const PrimitiveSize size = sizeOfPrimitive(primitive);
      cost.vertices += size.vertices;
      cost.bytes += size.bytes();
    }
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    const auto times = static_cast<std::uint64_t>(node.timesDrawn());
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      cost.objects += times;
      cost.triangles = cappedSum(cost.triangles, cappedProduct(times, primitive.indices.size() / 3));
    }
  }
  cost.bytes += bytesOfImages(scene);
  return cost;
}

SceneBudget budgetFor(const SceneCost& cost, const SceneBudget& budget) {
  const auto holding = [](std::uint64_t count, std::uint64_t unit) {
    return cappedProduct(unitsHolding(count, unit), unit);
  };
  return {std::max(budget.triangles, holding(cost.triangles, kMillion)),
          std::max(budget.bytes, holding(cost.bytes, kBytesOfMiB))};
}

std::string costRefusal(const SceneCost& cost, const SceneBudget& budget) {
  if (cost.triangles > budget.triangles)
    return say<"the scene draws %1 triangles and may draw %2; --scene-triangles %3 lets it">(
        cost.triangles, budget.triangles, unitsHolding(cost.triangles, kMillion));
  if (cost.bytes > budget.bytes)
    return say<"the scene takes %1 MiB of buffers and textures and may take %2; --scene-memory %1 lets it">(
        unitsHolding(cost.bytes, kBytesOfMiB), budget.bytes / kBytesOfMiB);
  return {};
}

} // namespace taa
