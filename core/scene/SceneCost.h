// What a scene asks of those who draw it: counted from its data before anything is uploaded, and held to a
// budget.
#pragma once

#include "core/base/Error.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace taa {

struct Scene;

/// Of a whole scene, whatever a frame sees of it.
struct SceneCost {
  std::uint64_t objects = 0;   ///< primitives at nodes and their instances
  std::uint64_t triangles = 0; ///< of all objects; three indices of lines and points count as one
  std::uint64_t vertices = 0;  ///< of all meshes
  std::uint64_t bytes = 0;     ///< of the buffers and textures that hold meshes and images on the GPU
};

inline constexpr int kDefaultSceneMillions = 20, kDefaultSceneMiB = 4096;
inline constexpr int kMaxSceneMillions = 1'000'000; ///< of triangles that can be asked for
inline constexpr int kMaxSceneMiB = 1 << 20;        ///< likewise, of buffers and textures

/// What is drawn at most, unless somebody asks for more: --scene-triangles and --scene-memory of the
/// programs.
struct SceneBudget {
  std::uint64_t triangles = kDefaultSceneMillions * std::uint64_t(1'000'000);
  std::uint64_t bytes = kDefaultSceneMiB * (std::uint64_t(1) << 20);
};

/// Of what the options of the programs say: millions of triangles, MiB.
SceneBudget sceneBudget(int millions, int mib);

SceneCost costOf(const Scene& scene);

/// Bytes of a primitive's buffers, as SceneResources makes them; `deltas`: vertices of all its morph targets.
struct PrimitiveSize {
  std::uint64_t vertices = 0, indices = 0, influences = 0, deltas = 0, cacheEntries = 0;
  std::uint64_t bytes() const;
};

/// a·b and a + b, or about 1.8·10¹⁹ where that would be more.
std::uint64_t cappedProduct(std::uint64_t a, std::uint64_t b);
std::uint64_t cappedSum(std::uint64_t a, std::uint64_t b);

/// A scene asks for more than it may.
class BudgetError : public Error {
 public:
  BudgetError(const std::string& sentence, const SceneBudget& needed) : Error(sentence), needed_(needed) {}
  /// The smallest budget that lets it in and holds the one that did not.
  const SceneBudget& needed() const { return needed_; }

 private:
  SceneBudget needed_;
};

/// The smallest budget of whole units, as options give it, that lets `cost` in and holds `budget`.
SceneBudget budgetFor(const SceneCost& cost, const SceneBudget& budget);

/// Why a scene is not drawn, as a sentence that names the option that lets it be; empty where it is.
std::string costRefusal(const SceneCost& cost, const SceneBudget& budget);

} // namespace taa
