// What kind of thing an object is, as an engine marks it in the stencil (manual 12.2).
#pragma once

#include "core/scene/Scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

struct SceneOutline;

enum class ObjectClass : std::uint8_t {
  Sky,
  Still,
  Moving,    ///< as a whole
  Deforming, ///< by a skin, morph targets, a cache or wind
  Character, ///< only where somebody says so: what sources 000 and 003 tell from the background
};

struct ObjectClassInfo {
  std::string_view id;    ///< in flags and files
  std::string_view label; ///< in the window
};

/// In the order of the enumerators.
inline constexpr std::array<ObjectClassInfo, 5> kObjectClasses{{{"sky", "Sky"},
                                                                {"still", "Still"},
                                                                {"moving", "Moves rigidly"},
                                                                {"deforming", "Deforms"},
                                                                {"character", "Character"}}};

/// A class that objects are given whatever moves them: the nodes of this name, as nodeKey() gives it, and
/// what is below them.
struct ClassOverride {
  std::string object;
  ObjectClass objectClass = ObjectClass::Character;
  bool operator==(const ClassOverride&) const = default;
};

/// Reads "OBJECT=character"; the last = counts. Throws Error that says what is expected: nothing is made sky.
ClassOverride parseClassOverride(const std::string& text);

/// Throws Error that names objects there are when an override is for none of them.
void checkClassOverrides(const Scene& scene, const std::vector<ClassOverride>& overrides);

/// By node, the class that it or the nearest node above it is given; the last override of a name counts.
std::vector<std::optional<ObjectClass>> givenClasses(const Scene& scene,
                                                     const std::vector<ClassOverride>& overrides);
/// As that of its scene.
std::vector<std::optional<ObjectClass>> givenClasses(const SceneOutline& outline,
                                                     const std::vector<ClassOverride>& overrides);

/// Which nodes move: those that the animation or a jump moves, and what hangs on them.
std::vector<bool> movingNodes(const Scene& scene);

} // namespace taa
