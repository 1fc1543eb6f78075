// What carries a technique out: the functions that the tables' choices name, and their files.
#pragma once

#include "core/report/Techniques.h"

#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// Where the kernels are whose weights are made once a frame, not by a shader.
inline constexpr std::string_view kKernelsOfAFrame = "core/taa/CurrentWeights.cpp";

/// A function of the resolve or the output. The twin's has the same name.
struct ChoiceFunction {
  std::string name; ///< "clampToBox"
  std::string file; ///< below shaders, "taa/rectify_history.glsl", or kKernelsOfAFrame
};

/// The file below shaders that defines it; empty where none does.
std::string shaderOf(std::string_view function);

/// Those of the choices that a row names as assignments, each once, in its order.
std::vector<ChoiceFunction> functionsOf(const Technique& technique);

} // namespace taa
