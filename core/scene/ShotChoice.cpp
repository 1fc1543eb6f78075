#include "core/scene/ShotChoice.h"

#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>

namespace taa {

namespace {

/// As a message lists them: the first ones.
std::string someNames(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) text += shownText(names[i]) + ", ";
  return text + std::string(kAllAnimations);
}

} // namespace

std::vector<std::string> animationNamesOf(const Scene& scene) {
  std::vector<std::string> names;
  std::unordered_set<std::string> taken{std::string(kAllAnimations)};
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    const std::string& name = scene.animations[i].name;
    const bool isOwn = !name.empty() && taken.insert(name).second;
    names.push_back(isOwn ? name : "#" + std::to_string(i + 1));
  }
  return names;
}

void chooseAnimation(Scene& scene, const std::string& name) {
  scene.animationNames = animationNamesOf(scene);
  const std::vector<std::string>& names = scene.animationNames;
  if (names.empty() && !name.empty())
    throw ChoiceError(say<"it has no animation, so none called \"%1\"">(shownText(name)));
  if (name == kAllAnimations || names.empty()) return;
  const auto found = name.empty() ? names.begin() : std::ranges::find(names, name);
  if (found == names.end())
    throw ChoiceError(
        say<"it has no animation called \"%1\"; there are %2">(shownText(name), someNames(names)));
  Animation chosen = std::move(scene.animations[static_cast<std::size_t>(found - names.begin())]);
  scene.animations.clear();
  scene.animations.push_back(std::move(chosen));
}

void chooseLength(Scene& scene, int frames) {
  if (frames < 1 || frames > kMaxShotFrames)
    throw ChoiceError(say<"a shot of %1 frames cannot be made: give 1 to %2">(frames, kMaxShotFrames));
  scene.shot.loopFrames = scene.shot.cameraLoopFrames();
  scene.shot.frames = frames;
}

} // namespace taa
