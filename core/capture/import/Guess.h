// What a folder of frames is, guessed from names, formats, side files and pixels; what is sure of it and what
// is not.
#pragma once

#include "core/base/Progress.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/import/FolderScan.h"

#include <filesystem>
#include <string>
#include <vector>

namespace taa::capture {

/// One answer to a question about the conventions, and how well the frames' own pixels fit it.
struct Hypothesis {
  std::string text;                     ///< for people: "previous − current"
  std::vector<std::string> assignments; ///< "motion.direction=previousMinusCurrent"
  double residual = 0.0; ///< mean |luma − warped luma of the frame before|, × 1000; or as the question says
  bool isChosen = false;  ///< what the manifest states
  bool isStatable = true; ///< false: no convention says it, as that nothing moves
};

/// A question, its answers by rising residual, and whether the best one stands out.
struct Finding {
  std::string question; ///< "Direction of motion"
  std::string path;     ///< the convention it decides
  std::vector<Hypothesis> hypotheses;
  bool isSure = false;
  std::string reason;  ///< a sentence: what it rests on
  std::string measure; ///< what the residuals are: "|Δ luma| × 1000", "px"
  /// With all answers that are best together motion leaves about as much as if nothing moved, or more.
  bool explainsNothing = false;

  /// Whether pixels say clearly something else than what the manifest states.
  bool contradicts() const;
};

struct Guess {
  Manifest manifest;                              ///< the best there is; readManifest() would take it
  std::vector<Finding> findings;                  ///< of pixels
  std::vector<std::string> sure, unsure, missing; ///< sentences
  std::vector<PictureSequence> sequences; ///< all that the folder holds, also what is taken for no plane
};

/// What names, formats and side files of `folder` say, then what pixels say. `like`: the starting point whose
/// conventions are taken where pixels decide nothing else, or empty; `assignments` are not questioned, those
/// of planes included
/// ("plane.motion=FILES:R,G", see statePlanes()). Throws Error that says what was looked for where nothing is
/// found, or which files and channels there are; Cancelled.
Guess guessCapture(const std::filesystem::path& folder, const std::string& like,
                   const std::vector<std::string>& assignments, const Progress& progress = {});

/// Asks the pixels of a manifest again, for a page that changes conventions. Throws Error, Cancelled.
std::vector<Finding> measureConventions(const std::filesystem::path& folder, const Manifest& manifest,
                                        const Progress& progress = {});

} // namespace taa::capture
