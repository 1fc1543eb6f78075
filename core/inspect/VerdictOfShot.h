// Verdicts on pixels of the frame on show, and of others, and what corrects them.
#pragma once

#include "core/base/Progress.h"
#include "core/replay/Checkpoints.h"
#include "core/verdict/pixel/PixelVerdict.h"
#include "core/verdict/pixel/Remedies.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace taa::gl {
struct Driver;
}

namespace taa {

class References;
class ShotPlayer;

/// Samples of each reference that a verdict is made from, and up to how many there are where that is too few
/// to conclude from.
inline constexpr int kVerdictSamples = 16, kMaxVerdictSamples = 256;

struct VerdictQuestion {
  int frame = 0;
  glm::ivec2 pixel{0};
  int lane = 0;
  int samples = kVerdictSamples; ///< of the references, to begin with
};

struct VerdictAnswer {
  PixelVerdict verdict;
  PixelError error;
  /// Name of what a ghost is of, with its number where several objects bear it; empty: none, or it has none.
  std::string object;
  std::string sentence; ///< what is wrong, and why
  int samples = 0;      ///< of the references that it was concluded from in the end
  /// Standard error of the reference at the pixel, as shown, 0 to 1; nothing: it came with a capture.
  std::optional<double> referenceError{};
};

/// How far the reference may be off at a pixel.
struct ReferenceDoubt {
  double error = 0.0;   ///< standard error as shown, 0 to 1, of the largest channel
  bool isMoving = true; ///< it is another one in other frames: what is the same in all makes no flicker
};

/// Whether another reference that is off by as much could lead to another verdict: to twice its standard
/// error, the pixel's error may lie on the other side of what is visible, its flicker as well, or another
/// part may be most of the error. `origin`: of which the parts were taken.
bool isInDoubt(const ReferenceDoubt& doubt, const PixelVerdict& verdict, const PixelError& origin);

/// The best remedies, and what they are held against.
struct RemedyAnswer {
  RemedyMeasure pixel;                    ///< as it is
  std::optional<RemedyMeasure> picture{}; ///< as it is; nothing: it was not measured
  std::vector<TriedRemedy> best;          ///< three at most
  int tried = 0;
  int first = 0;   ///< frame that they were tried from
  int samples = 0; ///< of the references at the pixel
};

/// How far a search for them got, for who may be cancelled.
struct RemedySearch {
  std::optional<RemedyMeasure> before;  ///< the settings as they are
  std::vector<TriedRemedy> tried;       ///< with the pictures of those that were measured
  std::vector<Remedy> waiting{};        ///< those of the present round
  int rounds = 0;                       ///< that were begun
  std::vector<Checkpoints> histories{}; ///< of the present settings and of those that are being measured
};

class VerdictOfShot {
 public:
  /// `references`: those of all frames, which it uses and adds to.
  VerdictOfShot(ShotPlayer& player, References& references, const gl::Driver& driver);

  /// Of a pixel of any frame, exactly; what is on show stays. Throws Error where there is no such pixel or
  /// frame, or where a capture has no reference; Cancelled. Where the reference is not certain enough for
  /// what is concluded, it is drawn with four times the samples, and again.
  VerdictAnswer of(const VerdictQuestion& question, const Progress& progress = {});
  /// Tries what may correct it, and measures the best ones as the program would show them. As of().
  RemedyAnswer remedies(const VerdictQuestion& question, const VerdictAnswer& answer,
                        const Progress& progress = {});
  /// Of these first what they do for the pixel, about: each remedy's frames are resolved from where the
  /// trouble began, a few frames before, on the history there was, around the pixel only. Goes on from what
  /// `search` holds of this question; Cancelled: it holds what was measured.
  RemedyAnswer triedRemedies(const VerdictQuestion& question, const VerdictAnswer& answer,
                             RemedySearch& search, const Progress& progress);
  /// And then, of whole pictures that are resolved from where history starts, how it is and what the best
  /// ones make of it: fills in the pictures of `remedies`, and the pixel exactly. What does not correct it
  /// after all is left out, and where one costs the picture the next best is measured as well. Likewise.
  void measurePictures(const VerdictQuestion& question, const VerdictAnswer& answer, RemedyAnswer& remedies,
                       RemedySearch& search, const Progress& progress);

 private:
  void require(const VerdictQuestion& question) const;
  /// With references of so many samples, and whether they are too few to conclude from.
  VerdictAnswer concluded(const VerdictQuestion& question, int samples, bool& isUncertain,
                          const Progress& progress);
  RemedyCase caseOf(const VerdictAnswer& answer, const Settings& settings) const;

  ShotPlayer& player_;
  References& references_;
  const gl::Driver& driver_;
};

} // namespace taa
