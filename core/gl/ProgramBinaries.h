// Linked programs kept on disk from one run of the program to the next.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace taa::gl {

/// What glGetProgramBinary gives.
struct ProgramBinary {
  std::uint32_t format = 0;
  std::string bytes;
};

/// One file for each program, which holds driver and source in full and a checksum: what is not whole, or of
/// another driver or source, is as good as not there. Nothing here throws or says anything: without a folder
/// to write to, programs are compiled each time.
class ProgramBinaries {
 public:
  /// `driver`: all it says of itself. Beyond `maxBytes` the files used longest ago go.
  ProgramBinaries(std::filesystem::path folder, std::string driver, std::uintmax_t maxBytes = 64u << 20);

  std::optional<ProgramBinary> find(const std::string& source) const;
  void keep(const std::string& source, const ProgramBinary& binary) const;
  std::filesystem::path fileOf(const std::string& source) const;

 private:
  void dropOldest() const;
  std::filesystem::path folder_;
  std::string driver_;
  std::uintmax_t maxBytes_;
};

/// $TAA_PROGRAM_CACHE when it is set; else taa-inspector/programs in $XDG_CACHE_HOME or ~/.cache. Empty: keep
/// nothing (TAA_PROGRAM_CACHE is empty, or there is no home).
std::filesystem::path programFolder();

} // namespace taa::gl
