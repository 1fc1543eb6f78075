// What shaders/include/noise.glsl needs of C++.
#pragma once

#include "core/gl/Texture.h"
#include "core/settings/Settings.h"

#include <string>

namespace taa {

/// The constants that choose a noise.
std::string noisePrelude(InputNoise noise);

/// The tile of blue noise, made when it is first asked for.
class NoiseSource {
 public:
  static constexpr unsigned kUnit = 6; ///< where the tile is read
  const gl::Texture& tile();

 private:
  gl::Texture tile_;
};

} // namespace taa
