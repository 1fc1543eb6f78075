// What pictures hold of the stated jitter, in numbers: factors along both axes, by least squares over the
// shifts that are measured.
#pragma once

#include "core/doctor/jitter/JitterTrials.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>

namespace taa::doctor {

/// Pictures hold the stated jitter times `factor`.
struct JitterFactors {
  glm::dvec2 factor{1.0}, error{0.0}; ///< along x and y; standard errors

  /// Whether a factor lies farther from another one, along either axis, than its errors.
  bool areBeyond(const glm::dvec2& other) const;
  JitterTrial trial() const;
};

/// One factor for both axes where two lie within each other's errors. Nothing where none makes nearly all
/// shifts, or they are not known to a twentieth.
std::optional<JitterFactors> measureFactors(const JitterEvidence& evidence);

/// Whether measured shifts are those of jitter with these factors, and not those of what is stated.
bool explainShifts(const JitterFactors& factors, const JitterEvidence& evidence);

/// "y of jitter reported 0.23 times as large as it is": axes whose factor is 1 are left out. Of
/// JitterKind::Scaled.
std::string factorsName(const glm::vec2& factor);

/// The ratio of the picture's sides where one axis has it for a factor and the other none, in a sentence;
/// empty: it lies beyond the errors.
std::string sidesText(const JitterFactors& factors, const glm::ivec2& sizePx);

} // namespace taa::doctor
