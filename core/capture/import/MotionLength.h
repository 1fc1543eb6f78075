// How long motion is: by what it has to be multiplied so that least is left between pictures.
#pragma once

#include "core/capture/import/FrameSamples.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>

namespace taa::capture {

/// The scale that motion has to have along each axis, and its standard error.
struct MotionLength {
  glm::dvec2 scale{1.0}, error{0.0};

  /// The shortest numbers within the errors, one for both axes where there is one.
  glm::dvec2 rounded() const;
  /// "Times 40: 39.8 ± 0.2 and 39.9 ± 0.2 as measured"
  std::string text() const;
};

TestState timesLength(TestState state, double factor);

/// From a half to twice of what `state` says; nothing where no length is best.
std::optional<MotionLength> measuredLength(FrameSamples& samples, const TestState& state);

/// Whether the first and the last pairs are of one length: what is of another frame is longer or shorter by
/// turns.
bool isOneLength(FrameSamples& samples, const TestState& state);

} // namespace taa::capture
