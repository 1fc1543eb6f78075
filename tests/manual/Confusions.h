// How often verdicts are right about labelled pixels, and where they are not: a page of the manual.
#pragma once

#include "tests/manual/VerdictLabels.h"

#include <cstddef>
#include <string>
#include <vector>

namespace taa {

/// Shares that are right, 0 to 1; 0 of no labels.
struct VerdictShares {
  double kind = 0.0, stage = 0.0;
  // Of the labels that have something wrong.
  double faultsKind = 0.0, faultsStage = 0.0;
  std::size_t tried = 0;  ///< faults on which remedies were tried
  double corrected = 0.0; ///< of these, whose first remedy lowers the pixel's error
};

VerdictShares sharesRight(const std::vector<JudgedLabel>& judged);

/// The text of confusions.md below its head: the shares, kinds that were said against kinds that verdicts
/// name, each label whose verdict is another, and each fault whose first remedy does not lower its error.
std::string confusionsText(const std::vector<JudgedLabel>& judged);

} // namespace taa
