// What makes motion measured of the motion given: a line, fitted to squares, and the known explanation that
// it is.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/flow/Flow.h"

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::doctor {

/// measured = factors · given + offset, by least squares over the squares that follow it.
struct FlowFit {
  glm::dmat2 factors{1.0}; ///< column-major, as GLM has it
  glm::dvec2 offsetPx{0.0};
  glm::dmat2 factorErrors{0.0}; ///< standard errors of each
  glm::dvec2 offsetErrorsPx{0.0};
  std::size_t squares = 0, followed = 0; ///< that were asked; that lie within the tolerance
  /// Of how what pictures move by varies from square to square, squared: what the line makes.
  double explainedShare = 0.0;

  /// Whether nearly all follow it, and its numbers are known to a twentieth.
  bool isGood() const;
};

/// Whether x of motion has no part in y, nor y in x; whether there is an offset, beyond its errors.
bool isAlongAxes(const FlowFit& fit);
/// Whether axes are turned, exchanged or mirrored: they are still across each other, and none is much longer.
bool isTurned(const FlowFit& fit);
bool hasOffset(const FlowFit& fit);
/// Degrees, clockwise as one sees it, where all that it does is to turn motion; within its errors.
std::optional<double> turnedBy(const FlowFit& fit);

inline constexpr std::size_t kEnoughToFit = 12; ///< squares

/// `tolerancePx`: to which squares follow it. Nothing where they are fewer than `enough`. With
/// `isThroughZero` there is no offset; where the motion given is along one line, it is one factor for both
/// axes then, else nothing.
std::optional<FlowFit> fitFlow(const std::vector<const FlowSquare*>& squares, bool isThroughZero,
                               double tolerancePx, std::size_t enough = kEnoughToFit);
/// One factor for both axes, without an offset.
std::optional<FlowFit> fitFactor(const std::vector<const FlowSquare*>& squares, double tolerancePx,
                                 std::size_t enough = kEnoughToFit);
/// A good fit without an offset, else one with it along the axes. Nothing where no line makes what pictures
/// move by, or what is given does.
std::optional<FlowFit> explaining(const std::vector<const FlowSquare*>& squares, double tolerancePx);
/// Where Unreal's encoding is stated, and what is stored is its argument and not its root: of what would be
/// read without undoing one, a factor.
std::optional<FlowFit> explainingWithoutRoot(const std::vector<const FlowSquare*>& squares,
                                             const CaptureInfo& captureInfo, double tolerancePx);

/// Of squares, how many follow a line to so many pixels, or by chance.
double followedShare(const FlowFit& fit, const std::vector<const FlowSquare*>& squares, double tolerancePx);
/// Whether along an axis no motion of one sign is given, and where it is 0, which the other axis need not be,
/// pictures move that way.
bool isClipped(const std::vector<const FlowSquare*>& squares, int axis);

/// A known explanation whose numbers lie within the errors of the fit.
std::optional<MotionTrial> knownTrial(const FlowFit& fit, const glm::ivec2& sizePx);

} // namespace taa::doctor
