// The keys of capture.json, for reading, the schema and the manual.
#pragma once

#include <string>
#include <string_view>

namespace taa::capture {

inline constexpr std::string_view kManifestKeys[] = {
    "$schema",    "format",          "name",    "engine", "like",   "conventions", "size",
    "outputSize", "framesPerSecond", "objects", "planes", "frames", "notes",
};

inline constexpr std::string_view kFrameKeys[] = {
    "number",      "jitter", "view",    "projection", "previousView", "previousProjection",
    "preExposure", "cut",    "seconds", "planes",
};

inline constexpr std::string_view kPlaneKeys[] = {
    "file", "part", "channels", "raw", "size", "rowPitch", "at", "rows",
};

/// "R11G11B10F, RGBA16F, …"
std::string rawFormatNames();

} // namespace taa::capture
