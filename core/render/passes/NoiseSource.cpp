#include "core/render/passes/NoiseSource.h"

#include "core/render/passes/NoiseTile.h"

namespace taa {

std::string noisePrelude(InputNoise noise) {
  const auto constant = [](const char* name, InputNoise value) {
    return std::string("const int ") + name + " = " + std::to_string(static_cast<int>(value)) + ";\n";
  };
  return constant("kNoise", noise) + constant("kNoNoise", InputNoise::None) +
         constant("kGradientNoise", InputNoise::Gradient) + constant("kBlueNoise", InputNoise::Blue) +
         constant("kWhiteNoise", InputNoise::White);
}

const gl::Texture& NoiseSource::tile() {
  if (!tile_) {
    tile_ = gl::Texture({kNoiseTileSize, kNoiseTileSize}, gl::Format::R32F, "blue noise");
    tile_.upload(blueNoiseTile());
  }
  return tile_;
}

} // namespace taa
