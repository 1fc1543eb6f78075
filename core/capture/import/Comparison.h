// Hypotheses about the same frames, compared where they differ.
#pragma once

#include "core/capture/import/FrameSamples.h"
#include "core/capture/import/Guess.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace taa::capture {

/// An answer to try.
struct Trial {
  std::string text;
  std::vector<std::string> assignments; ///< on top of the state; empty: nothing that can be stated
  TestState state;
  bool isAtRest = false; ///< as if nothing moved
};

/// What pixels say of trials, in their order.
struct TrialComparison {
  std::vector<double> residuals; ///< infinite: the capture contradicts it
  std::size_t best = 0;
  std::size_t possible = 0; ///< trials that the capture does not contradict
  std::size_t pixels = 0;   ///< at which they differ, of all pairs
  std::size_t told = 0;     ///< at which the best two differ
  double gain = 0.0;        ///< residual of the second less that of the best
  double factor = 1.0;      ///< residual of the second by that of the best
  double share = 0.0;       ///< of the picture's regions, over all pairs, in which the best beats the second
  std::size_t regions = 0;

  /// Whether enough of the picture says anything.
  bool hasRegions() const;
  /// Whether the best one stands out.
  bool isClear() const;
  /// Whether the second leaves no more than the best one, as far as anything can be told.
  bool isEven() const;
};

TrialComparison compare(FrameSamples& samples, const std::vector<Trial>& trials);

/// What one trial makes of the pixels of all pairs, pair by pair.
struct Outcome {
  bool isPossible = true;        ///< false: the capture contradicts it
  std::vector<glm::vec2> places; ///< in the picture before
  std::vector<float> errors;     ///< NaN: not known

  void add(const glm::vec2& place, float error) {
    places.push_back(place);
    errors.push_back(error);
  }
};

/// Of outcomes by whatever error; pixels that one of them does not know count for none.
TrialComparison compare(const FrameSamples& samples, const std::vector<Outcome>& outcomes);

/// What pixels say of two states.
TrialComparison compare(FrameSamples& samples, const TestState& first, const TestState& second);
/// Whether pixels say clearly the one, not the other.
bool isClearlyLess(FrameSamples& samples, const TestState& one, const TestState& other);

/// The mean of |luma − luma of the frame before| × 1000 over every n-th pixel of the sample; infinite where
/// conventions contradict the capture. Faster than compare(), for many states.
double roughResidual(FrameSamples& samples, const TestState& state);
/// The same of some pairs.
double roughResidual(FrameSamples& samples, std::span<const FramePair> pairs, const TestState& state);

/// A sentence: what makes a comparison clear or not.
std::string reasonOf(const TrialComparison& comparison);

} // namespace taa::capture
