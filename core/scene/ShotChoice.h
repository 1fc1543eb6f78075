// What is shown of a scene that leaves it open: which of its animations plays, and for how long.
#pragma once

#include "core/base/Error.h"

#include <string>
#include <string_view>
#include <vector>

namespace taa {

struct Scene;

/// All animations of a file play at once, each in a loop of its own; where two move one thing, the later one
/// does.
inline constexpr std::string_view kAllAnimations = "all";
inline constexpr int kMaxShotFrames = 100'000;

struct ShotChoice {
  std::string animation{}; ///< one of Scene::animationNames, or kAllAnimations; empty: the first
  int frames = 0;          ///< 1 to kMaxShotFrames; 0: as many as the scene has of its own

  bool operator==(const ShotChoice&) const = default;
};

/// What is open has no such animation, or no shot of that length.
class ChoiceError : public Error {
 public:
  using Error::Error;
};

/// What animations are called: their names; "#2" where the second has none, or one that another has before
/// it.
std::vector<std::string> animationNamesOf(const Scene& scene);

/// Leaves the animations that play, and fills Scene::animationNames with all there are. Throws
/// ChoiceError naming them.
void chooseAnimation(Scene& scene, const std::string& name);

/// Camera paths stay as fast as they are. Throws ChoiceError where there are too few or too many.
void chooseLength(Scene& scene, int frames);

} // namespace taa
