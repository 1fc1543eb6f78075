// How often the doctor is right about injected faults, and what it says where it is not: a part of the
// manual's page of faults.
#pragma once

#include "tests/manual/DoctorCases.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace taa {

/// What became of cases with one fault each.
struct OutcomeCounts {
  std::size_t cases = 0;
  std::size_t hidden = 0;      ///< frames that do not show the fault …
  std::size_t hiddenNamed = 0; ///< … and something is named; the rest is of the others
  std::array<std::size_t, kCaseOutcomes> byOutcome{}; ///< as CaseOutcome

  void add(const JudgedCase& judged);
  std::size_t shown() const { return cases - hidden; }
  std::size_t count(CaseOutcome outcome) const { return byOutcome[static_cast<std::size_t>(outcome)]; }
};

/// Markdown, below a heading of its own: what was tried, the shares, and a table of all faults.
std::string doctorConfusions(const std::vector<JudgedCase>& judged);

} // namespace taa
