// Findings that are known already: a build does not fail because of them.
#pragma once

#include "core/doctor/Diagnosis.h"

#include <string>
#include <vector>

namespace taa {

/// A finding as a baseline names it.
struct KnownFinding {
  std::string id;
  std::string region; ///< by its name; empty: the whole picture, and each region of it
  bool operator==(const KnownFinding&) const = default;
};
using DoctorBaseline = std::vector<KnownFinding>;

/// All that is found, a line for each region; by id, then by region.
DoctorBaseline baselineOf(const doctor::Diagnosis& diagnosis);
/// Whether it is known in all of its regions.
bool isKnown(const doctor::Finding& finding, const DoctorBaseline& baseline);
/// Says of each finding whether it is known.
void markKnown(doctor::Diagnosis& diagnosis, const DoctorBaseline& baseline);

/// {"known": [{"id", "region"}]}
std::string baselineToText(const DoctorBaseline& baseline);
/// Throws Error that names `place` and what is wrong with it.
DoctorBaseline baselineFromText(const std::string& text, const std::string& place);

} // namespace taa
