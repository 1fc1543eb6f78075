// Reading and writing whole files, with sentences for errors.
#pragma once

#include "core/base/Error.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace taa {

/// The bytes of a file. Throws Error when it cannot be read or is larger than `maxBytes`.
std::string readFile(const std::filesystem::path& path, std::uintmax_t maxBytes = std::uintmax_t(2) << 30);

/// Writes beside the target and renames, so that a reader sees the old file or the new one, never half of
/// one. `write` gets the temporary path, which keeps the extension of `path`. Whatever it throws goes on, and
/// the temporary file is removed.
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write);

/// As above, for bytes at hand.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

} // namespace taa
