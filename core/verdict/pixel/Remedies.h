// What might mend a pixel: changes of settings that are worth a try for what is wrong with it, and which of
// those that were tried are worth telling. No GL.
#pragma once

#include "core/settings/Settings.h"
#include "core/verdict/pixel/PixelVerdict.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace taa {

struct Remedy {
  std::vector<std::string> changes; ///< "rectify.method=clipToFiltered", one to three
  Settings settings;                ///< with them
};

/// Of a pixel over its last moments, or of the whole picture, against the reference, as shown (0 to 1).
struct RemedyMeasure {
  double error = 0.0;       ///< root of the mean squared error
  double latest = 0.0;      ///< the same of the last frame alone
  double errorChange = 0.0; ///< root of the mean squared change of the error from frame to frame
  /// The metric (core/measure/Flicker.h) over these frames; of a picture only, as what follows.
  double flicker = 0.0;
  /// Root of the mean squared ghost (core/measure/compare/GhostEnergy.h), looked for where the motion vectors
  /// point, the same for all settings.
  double ghost = 0.0;
  double sharpness = 1.0; ///< core/measure/compare/Sharpness.h, of the last frame
};

struct TriedRemedy {
  Remedy remedy;
  RemedyMeasure pixel;
  std::optional<RemedyMeasure> picture{}; ///< nothing: it was not measured
};

/// What is to be mended.
struct RemedyCase {
  VerdictKind kind = VerdictKind::None;
  Settings settings;         ///< that made the frames
  bool drawsInputs = true;   ///< inputs may be drawn otherwise: they are not those of a capture
  RemedyMeasure before = {}; ///< of the pixel, as it is
};

/// Rounds of a search: likely changes; where none of them helps clearly all others of one setting; the best
/// with those that help besides; that once more.
inline constexpr int kRemedyRounds = 4;
/// What a round tries, knowing `tried` of all rounds before: nothing twice, nothing that changes nothing or
/// more than three settings.
std::vector<Remedy> remedyRound(int round, const RemedyCase& of, const std::vector<TriedRemedy>& tried);

/// The best `count` of those that bring the pixel clearly nearer to the truth than `before`, by its errors
/// and their change together, and nearer in the last frame. Of those that nobody could tell apart the one
/// that costs the picture least comes first, by its error and flicker together; where that is the same or
/// not measured the simplest. One that has all changes of one that is told, and more, is left out. One that
/// takes out what was injected comes before all.
std::vector<TriedRemedy> bestRemedies(const std::vector<TriedRemedy>& tried, const RemedyMeasure& before,
                                      std::size_t count);

} // namespace taa
