// Frames of a shot as a captured sequence: what the resolve was given and what it made of it, in the
// conventions of any engine.
#pragma once

#include "core/base/Progress.h"
#include "core/capture/format/Conventions.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace taa {

class Inspector;

/// How a capture is written.
struct CaptureChoice {
  std::string like = "taa-inspector";   ///< id of a capture::StartingPoint
  std::vector<std::string> conventions; ///< "path=value" on top of it
  int lane = 0;
  int referenceSamples = 0; ///< of the reference in it; 0: without one
  bool namesFaults = true;  ///< its notes say which ones were injected
};

/// Throws Error where they are none, or contradict each other.
capture::Conventions conventionsOf(const CaptureChoice& choice);

/// All files that a capture of frames `first` to `last` can consist of, capture.json last.
std::vector<std::filesystem::path> captureFiles(const std::filesystem::path& folder, int first, int last);

class CaptureExport {
 public:
  /// Of frames `first` to `last`; expects that something is open. Throws Error.
  CaptureExport(Inspector& inspector, CaptureChoice choice, int first, int last);
  ~CaptureExport();
  CaptureExport(const CaptureExport&) = delete;
  CaptureExport& operator=(const CaptureExport&) = delete;

  /// Writes the planes of the frame on show, one of those, into `folder`. Throws Error, Cancelled.
  void add(const std::filesystem::path& folder, const Progress& progress);
  /// Writes capture.json once all frames are added; the names of all files, it as the last. Throws Error.
  std::vector<std::string> finish(const std::filesystem::path& folder);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace taa
