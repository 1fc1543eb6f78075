// What might correct a pixel: changes of settings that are worth a try for what is wrong with it, and which
// of those that were tried are worth telling. No GL.
#pragma once

#include "core/settings/Settings.h"
#include "core/verdict/pixel/PixelVerdict.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
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
  bool isNamed = false;                   ///< it changes a setting that the verdict names
};

/// What is to be corrected.
struct RemedyCase {
  VerdictKind kind = VerdictKind::None;
  Settings settings;                      ///< that made the frames
  bool drawsInputs = true;                ///< inputs may be drawn otherwise: they are not those of a capture
  std::vector<std::string_view> named{};  ///< namedSettings() of the verdict
  RemedyMeasure before{};                 ///< of the pixel, as it is
  std::optional<RemedyMeasure> picture{}; ///< as it is; nothing: it was not measured
};

/// PSNR of a measure, dB.
double psnrOf(const RemedyMeasure& picture);
/// A change may take so much of the picture's PSNR, dB, before it counts as a cost: a limit that was
/// chosen, not calibrated.
inline constexpr double kPictureCost = 0.1;
/// And its flicker may rise by this share, if that is at least a twentieth of a step of 255 a frame.
inline constexpr double kFlickerCost = 0.1;
bool costsPicture(const RemedyMeasure& before, const RemedyMeasure& after);

/// Whether it leaves clearly less of the pixel's error than there was, by its errors and their change
/// together, and less in the last frame.
bool isCorrection(const RemedyMeasure& before, const RemedyMeasure& after);

/// What is to be known of a remedy besides its numbers, in sentences: that the verdict names it, that it does
/// not help, what it costs the picture. Mostly empty. `pixel`, `picture`: as it is.
std::string remedyNote(const TriedRemedy& tried, const RemedyMeasure& pixel,
                       const std::optional<RemedyMeasure>& picture);

/// Rounds of a search: what averages frames where nothing does, what the verdict names and likely
/// changes; where all of these leave what can be seen, all choices and numbers of one setting, and where none
/// helps clearly those against other kinds; the best with those that help besides; that once more.
inline constexpr int kRemedyRounds = 4;
/// What a round tries, knowing `tried` of all rounds before: nothing twice, nothing that changes nothing or
/// more than three settings.
std::vector<Remedy> remedyRound(int round, const RemedyCase& of, const std::vector<TriedRemedy>& tried);

/// The best `count` of those that correct the pixel. Those that cost the picture come last, as far as it was
/// measured. Of those that leave about the same the one with fewer changes comes first, then the one whose
/// picture is best, by its error and flicker together. One that has all changes of one that is told, and
/// more, is left out. What takes out what was injected, or turns TAA on, comes before all. One that changes a
/// setting that the verdict names is always among them, after all others where it does not correct the pixel.
std::vector<TriedRemedy> bestRemedies(const std::vector<TriedRemedy>& tried, const RemedyCase& of,
                                      std::size_t count);

} // namespace taa
