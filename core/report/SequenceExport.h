// A range of frames into files: pictures, an animation, values, or a capture.
#pragma once

#include "core/base/Progress.h"
#include "core/inspect/ShownPicture.h"
#include "core/report/CaptureExport.h"

#include <filesystem>
#include <string>
#include <vector>

namespace taa {

class Inspector;

enum class SequenceKind {
  Png,     ///< NAME.0007.png for each frame
  Gif,     ///< one file
  Exr,     ///< NAME.0007.exr for each frame, a part for each intermediate
  Capture, ///< FOLDER/capture.json, and a file for each plane of each frame
};

struct SequenceRequest {
  SequenceKind kind = SequenceKind::Png;
  /// The file of a GIF, "FOLDER/capture.json" of a capture; of the others "FOLDER/NAME.png", the number comes
  /// before the ending.
  std::filesystem::path target;
  int first = 0, last = 0;
  PictureRequest picture;          ///< of PNG and GIF, for each frame; of EXR its reference's samples
  double framesPerSecond = 30.0;   ///< of a GIF
  std::vector<IntermediateId> ids; ///< of EXR
  /// Of EXR: what the other side of `picture` is, in words, where differences from it are written instead of
  /// rows; empty: rows.
  std::string differenceFrom{};
  CaptureChoice capture;
};

/// How an export ended.
struct ExportResult {
  std::string target; ///< the file, or the first of the files
  int frames = 0;     ///< written; 0: it failed or was stopped, and left nothing
};

/// The file of a frame, or the GIF, or capture.json.
std::filesystem::path sequenceFile(const SequenceRequest& request, int frame);
/// All files that it writes, in their order; of a capture those that it may have.
std::vector<std::filesystem::path> sequenceFiles(const SequenceRequest& request);

/// Replaces files that are there. All files or none: they are made in a folder beside their place and moved
/// there at the end, so that a cancelled or failed export leaves what was there before. Ends at the frame
/// where it began, exact. Gives the files that it wrote, in their order. Throws Error, Cancelled.
std::vector<std::filesystem::path> exportSequence(Inspector& inspector, const SequenceRequest& request,
                                                  const Progress& progress);

} // namespace taa
