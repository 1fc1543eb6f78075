// A small picture of a scene as verdicts are made of it.
#pragma once

#include "core/render/passes/SceneRenderer.h"
#include "core/replay/ShotPlayer.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"

#include <glm/vec2.hpp>

#include <memory>
#include <string>

namespace taa::test {

inline constexpr glm::ivec2 kSceneShotPx{160, 90};

inline ShotState sceneShot(const std::string& source, const std::string& presetId) {
  ShotState state;
  state.scene = std::make_shared<const Scene>(openScene(source));
  state.frames = std::make_shared<SceneRenderer>(state.scene);
  state.camera = state.scene->shot.camera;
  state.width = kSceneShotPx.x;
  state.height = kSceneShotPx.y;
  state.lanes = {preset(presetId).settings};
  return state;
}

} // namespace taa::test
