// What stages of the resolve cost, from times of programs that end after each of them, and what of it is
// known.
#pragma once

#include "core/gl/PassTimer.h"
#include "core/settings/Stage.h"

#include <span>
#include <string>
#include <vector>

namespace taa {

/// The median of measured values, and the range in which the true one lies with 96 % at least. That range is
/// one of order statistics: it asks nothing of how the values are spread, an outlier does not widen it.
struct MeasuredMs {
  double median = 0.0, low = 0.0, high = 0.0;
  /// How far the range reaches from the median.
  double spread() const;
};
/// Of six values at least; of fewer the range is all of the line.
MeasuredMs measured(std::vector<double> values);

enum class CostVerdict {
  Clear,   ///< above 0 by more than its spread
  Noise,   ///< within it: nothing is known but how large it can be at most
  Negative ///< below 0 by more than its spread: the compiler leaves out of the longer program what it has
           ///< to keep in the shorter one
};

struct StageCost {
  Stage stage = Stage::Jitter;
  MeasuredMs ms; ///< differences of paired times
  CostVerdict verdict() const;
};

/// Of one frame of one lane. `stages` in the order in which the resolve runs them; `store`: launching the
/// draw and writing its targets.
struct StageCosts {
  int frame = 0, width = 0, height = 0, rounds = 0;
  gl::TimingMethod method = gl::TimingMethod::Finish;
  MeasuredMs whole, store;
  std::vector<StageCost> stages;
};

/// What a verdict means, in a sentence for people; empty: nothing but the number.
std::string verdictWords(const StageCost& cost);

/// Times of a program in each round, in which all programs ran one after the other.
using RoundTimes = std::vector<double>;

/// The cost of each of `stages`: the program that ends after it against the one before, round by round, so
/// that what slows the machine down for longer than two draws falls out. `times`: first that of the program
/// before them all; all of as many rounds.
std::vector<StageCost> stageCosts(std::span<const Stage> stages, std::span<const RoundTimes> times);

} // namespace taa
