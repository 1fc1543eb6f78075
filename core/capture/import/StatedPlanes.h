// Planes that somebody names: "motion=dmv_{frame:4}.exr:G,B".
#pragma once

#include "core/capture/import/FolderScan.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {

/// What an assignment begins with that states a plane, "plane.motion=FILES:CHANNELS".
inline constexpr std::string_view kPlanePrefix = "plane.";

/// Takes those that state planes out of `assignments`.
std::vector<std::string> takeStatedPlanes(std::vector<std::string>& assignments);

/// Each as "KIND=FILES" or "KIND=FILES:CHANNEL,CHANNEL"; FILES as `scan` has them. What is stated counts: no
/// other sequence has that plane any more, and its own has no plane that nobody named. Throws Error that says
/// which there are.
void statePlanes(const std::vector<std::string>& stated, const std::filesystem::path& folder,
                 FolderScan& scan);

} // namespace taa::capture
