// What a manifest must be like, whether it was read or made: for reading and writing of capture.json.
#pragma once

#include "core/capture/format/Manifest.h"

#include <cstddef>

namespace taa::capture {

inline constexpr int kManifestFormat = 1;
inline constexpr std::size_t kMaxText = 4096, kMaxNotes = 1000;
inline constexpr double kMaxStatedJitter = 1e6, kMaxMatrixElement = 1e30,
                        kMaxSeconds = 1e9; ///< of either sign
inline constexpr double kMinPreExposure = 1e-12, kMaxPreExposure = 1e12;

/// As checkManifest(), without the beginning: throws Error that names the key at fault by its path in the
/// file.
void requireConsistent(const Manifest& manifest);

} // namespace taa::capture
