// A range of frames into files: pictures, an animation, or values.
#pragma once

#include "core/base/Progress.h"
#include "core/inspect/ShownPicture.h"

#include <filesystem>
#include <string>
#include <vector>

namespace taa {

class Inspector;

enum class SequenceKind {
  Png, ///< NAME.0007.png for each frame
  Gif, ///< one file
  Exr, ///< NAME.0007.exr for each frame, a part for each intermediate
};

struct SequenceRequest {
  SequenceKind kind = SequenceKind::Png;
  /// The file of a GIF; of the others "FOLDER/NAME.png", the number comes before the ending.
  std::filesystem::path target;
  int first = 0, last = 0;
  PictureRequest picture;          ///< of PNG and GIF, for each frame; of EXR its reference's samples
  double framesPerSecond = 30.0;   ///< of a GIF
  std::vector<IntermediateId> ids; ///< of EXR
};

/// How an export ended.
struct ExportResult {
  std::string target; ///< the file, or the first of the files
  int frames = 0;     ///< written; 0: it failed or was stopped, and left nothing
};

/// The file of a frame, or the GIF.
std::filesystem::path sequenceFile(const SequenceRequest& request, int frame);
/// All files that it writes, in their order.
std::vector<std::filesystem::path> sequenceFiles(const SequenceRequest& request);

/// Replaces files that are there. All files or none: they are made in a folder beside their place and moved
/// there at the end, so that a cancelled or failed export leaves what was there before. Ends at the frame
/// where it began, exact. Throws Error, Cancelled.
void exportSequence(Inspector& inspector, const SequenceRequest& request, const Progress& progress);

} // namespace taa
