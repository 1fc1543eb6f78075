// What numbers of planes say of their conventions: ranges, values that stand for nothing, and whether depth
// and matrices make the motion that is stored.
#pragma once

#include "core/base/Image.h"
#include "core/capture/import/FrameSamples.h"
#include "core/capture/import/Guess.h"
#include "core/capture/import/Questions.h"

#include <optional>
#include <string>
#include <vector>

namespace taa::capture {

struct DepthValues {
  double lowest = 0.0, highest = 0.0, median = 0.0; ///< of finite values but `nothing`
  std::optional<double> nothing;                    ///< an end of the range that many pixels share
  bool isKnown = false;                             ///< there are two values that differ
};
DepthValues depthValuesOf(const Image& depth);

/// Kind, direction and scale that such values are likely to have; near and far plane stay 0.
DepthConventions depthFrom(const DepthValues& values);
/// Whether such values can be of that kind, with their sign and what stands for nothing.
bool canHold(const DepthConventions& depth, const DepthValues& values);
/// A sentence: what depthFrom() rests on.
std::string depthGuess(const DepthValues& values);

struct MotionValues {
  double largest = 0.0;            ///< of either component, without sign
  double restX = 0.0, restY = 0.0; ///< the values that most pixels have
  /// One value other than 0 in both components of many pixels and not of all, to the last bit: no motion, but
  /// a mark of what nobody wrote. Nothing: there is none.
  std::optional<double> mark;
  /// All that is not 0 lies within 0 to 1 and around a half: encoded with an offset.
  bool isAroundHalf = false;
  double zeroShare = 0.0; ///< of pixels that hold 0 in both
};
MotionValues motionValuesOf(const Image& motion);

/// By what depth and matrices make of the camera's motion against the motion stored: what stands still in the
/// world has both alike. Nothing where the capture has not all three. Adopts what is sure, unless that
/// changes one of `fixedPaths`.
std::optional<Finding> askDepth(FrameSamples& samples, TestState& state, const DepthValues& values,
                                const QuestionRules& rules);

/// Motion of the sky where motion is 0 wherever nothing was drawn, though the camera moves: it was not
/// written. Nothing where it is not so. Adopts it unless fixed.
std::optional<Finding> askSky(FrameSamples& samples, TestState& state, bool isFixed);

} // namespace taa::capture
