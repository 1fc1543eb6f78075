// What the programs that libFuzzer drives have in common: what a refusal may be, and files to read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace taa::fuzz {

/// Ends the program with `sentence` where that is not so: libFuzzer keeps the input as a finding.
void require(bool holds, const std::string& sentence);

/// Calls `read`, which may throw Error with one plain line that begins with `place`, and nothing else.
/// Returns whether it threw nothing.
bool readsOrRefuses(std::string_view place, const std::function<void()>& read);

/// Puts bytes into the file NAME of a folder of this process's own, in memory where the system has such
/// folders; returns its path. The folder goes with the process.
std::string fileOf(const char* name, const std::uint8_t* bytes, std::size_t count);

inline std::string textOf(const std::uint8_t* bytes, std::size_t count) {
  return {reinterpret_cast<const char*>(bytes), count};
}

} // namespace taa::fuzz
