#include "app/importing/Answers.h"

#include "core/base/Error.h"

#include <algorithm>
#include <string>

namespace taa::app {

namespace {

bool sets(const capture::Hypothesis& hypothesis, std::string_view path) {
  const std::string begin = std::string(path) + '=';
  return std::ranges::any_of(hypothesis.assignments,
                             [&](const std::string& assignment) { return assignment.starts_with(begin); });
}

int doubtOf(Verdict verdict) {
  switch (verdict) {
  case Verdict::NotMeasured:
    break;
  case Verdict::Sure:
    return 1;
  case Verdict::NotSure:
    return 2;
  case Verdict::Contradicted:
    return 3;
  }
  return 0;
}

} // namespace

const capture::Finding* findingOf(const std::vector<capture::Finding>& findings, std::string_view path,
                                  const capture::Conventions& stated) {
  const capture::Finding* found = nullptr;
  const auto take = [&](const capture::Finding& finding) {
    if (!found || doubtOf(verdictOn(&finding, stated)) > doubtOf(verdictOn(found, stated))) found = &finding;
  };
  for (const capture::Finding& finding : findings)
    if (finding.path == path) take(finding);
  if (found) return found;
  for (const capture::Finding& finding : findings) {
    if (finding.path == "like") continue; // sets much, and decides none of it
    if (std::ranges::any_of(finding.hypotheses, [&](const auto& each) { return sets(each, path); }))
      take(finding);
  }
  return found;
}

bool agrees(const capture::Hypothesis& hypothesis, const capture::Conventions& stated) {
  if (!hypothesis.isStatable) return false;
  capture::Conventions assigned = stated;
  try {
    for (const std::string& assignment : hypothesis.assignments)
      capture::applyAssignment(assigned, assignment);
  } catch (const Error&) {
    return false;
  }
  return assigned == stated;
}

Verdict verdictOn(const capture::Finding* finding, const capture::Conventions& stated) {
  if (!finding || finding->hypotheses.empty()) return Verdict::NotMeasured;
  if (!finding->isSure) return Verdict::NotSure;
  if (agrees(finding->hypotheses.front(), stated)) return Verdict::Sure;
  // What is stated has to be among the answers: of a number that was not asked nothing is known.
  const bool wasAsked = std::ranges::any_of(
      finding->hypotheses, [&](const auto& hypothesis) { return agrees(hypothesis, stated); });
  return wasAsked ? Verdict::Contradicted : Verdict::NotSure;
}

} // namespace taa::app
