// An open capture: its manifest, and its frames decoded when they are wanted, the next one ahead of time.
#pragma once

#include "core/base/Progress.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/format/Manifest.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

namespace taa::capture {

/// Bytes of main memory that decoded frames take at most, besides the two newest.
inline constexpr std::size_t kCaptureBudget = std::size_t(512) << 20;

/// Thread-safe. Frame n is a function of the capture alone.
class Capture {
 public:
  /// `budget`: bytes of main memory for decoded frames.
  Capture(std::filesystem::path folder, Manifest manifest, std::size_t budget = kCaptureBudget);
  ~Capture();

  const std::filesystem::path& folder() const;
  const Manifest& manifest() const;
  int frames() const;
  /// Decoded now, or kept, or waited for while it is on its way; begins to decode the frame after it in the
  /// background, the one before it where frames are asked for downward. Throws Error.
  std::shared_ptr<const DecodedFrame> frame(int index) const;
  /// Whether frame() answers without reading.
  bool isReady(int index) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What a folder is called, however its path is written: "a" of "a", "a/", "b/../a" and, within it, ".".
std::string nameOf(const std::filesystem::path& folder);
/// Whether `source` names a capture: a folder, or a .json file, whatever it is called.
bool isCapture(const std::string& source);
/// The folder of a capture, whichever of both names it.
std::filesystem::path folderOf(const std::string& source);
/// Opens a manifest, a folder with capture.json, or one without that import/ understands: its notes say what
/// was guessed. Checks that the first frame can be read. Throws Error, Cancelled.
std::shared_ptr<const Capture> openCapture(const std::string& source, const Progress& progress = {});

} // namespace taa::capture
