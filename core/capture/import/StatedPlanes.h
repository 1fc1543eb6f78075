// Planes that somebody names: "motion=dmv_{frame:4}.exr:G,B".
#pragma once

#include "core/capture/format/Manifest.h"
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

/// In the place of files: there is no such plane, whatever is called so.
inline constexpr std::string_view kNoPlane = "none";

/// A plane's place as it is stated: "FILES:CHANNEL,CHANNEL", "FILES:PART:CHANNEL,CHANNEL" or "FILES".
std::string statedText(const PlaneSource& source);

/// Each as "KIND=FILES", with channels as statedText() writes them; FILES as `scan` has them, or kNoPlane.
/// What is stated counts: no other sequence has that plane any more, and its own has no plane that nobody
/// named. Throws Error that says which there are.
void statePlanes(const std::vector<std::string>& stated, const std::filesystem::path& folder,
                 FolderScan& scan);

/// The same of a capture, whose frames then have the plane from these files alone. Throws Error where a frame
/// is not among them, too.
void statePlanes(const std::vector<std::string>& stated, const std::filesystem::path& folder, FolderScan scan,
                 Manifest& manifest);

/// Throws Error where a plane that is stated is none of the manifest's.
void requireStated(const std::vector<std::string>& stated, const Manifest& manifest);

} // namespace taa::capture
