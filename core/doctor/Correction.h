// What makes frames right in which something was found: settings, for those of the renderer and of a capture
// alike, so that corrected frames are a lane beside the original.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/settings/Settings.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {

/// Settings that restrict faults of planes to where a finding is: none where it is the whole picture or most
/// of it. Nothing where no setting says that place.
std::optional<std::vector<std::string>> placeSettings(const Finding& finding);

/// Sets a finding's `correction`, in its place. Does nothing where no setting says that place.
void correctBy(const std::vector<std::string>& assignments, Finding& finding);
/// The same in the whole picture: nothing else is there that would not be right then.
void correctEverywhereBy(const std::vector<std::string>& assignments, Finding& finding);

struct Corrected {
  Settings settings;
  std::vector<std::size_t> findings; ///< that are made right by them, by index; of none: as they were
};

/// Faults that were injected are taken back; what else is wrong is made right by its `correction`, the first
/// ones where two exclude each other. `healthy`: what settings of faults go back to.
Corrected corrected(const std::vector<Finding>& findings, const Settings& settings, const Settings& healthy);

} // namespace taa::doctor
