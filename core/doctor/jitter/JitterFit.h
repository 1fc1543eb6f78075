// How well the frame before fits a frame under each explanation of the jitter, beside what is stated.
#pragma once

#include "core/doctor/jitter/JitterTrials.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::doctor {

/// A trial against what is stated, over the pairs of frames in which the two shift otherwise.
struct TrialFit {
  int pairs = 0, won = 0;           ///< won: by the trial
  double stated = 0.0, tried = 0.0; ///< sums of what both leave, see TrialLuma

  /// Of what is left: below 1 where the trial fits better; infinite where nothing is known.
  double share() const;
};

/// Of `tried` against `stated`, both indices of trials.
TrialFit fitOf(const std::vector<TrialLuma>& pairs, std::size_t tried, std::size_t stated);

struct JitterFit {
  std::vector<TrialFit> trials; ///< as jitterTrials(), against what is stated
  std::vector<double> missPx;   ///< as trials: shiftResidual()
  std::vector<bool> isOfLength; ///< as trials: it is what is stated, longer or shorter
  std::size_t best = 0;    ///< of trials: the one that leaves least; a twofold one where no other contradicts
  std::size_t twofold = 0; ///< of trials, the last ones: those that say two things
  double statedLuma = 0.0; ///< mean of what is left as stated

  /// Nothing fits better than what is stated, but for another length in some pairs by chance: what is swayed
  /// by wind is read softer, and shorter jitter is.
  bool isConfirmed() const;
  /// Shifts that are measured are those of what is stated, nearly exactly, and of nothing else: whatever fits
  /// better because pictures alias is chance.
  bool isMeasured() const;
  /// The best fits clearly better in nearly all pairs, and is not farther from measured shifts than what is
  /// stated; or it fits better, and is much nearer to them. Neither is enough alone: thin lines stay on their
  /// pixels whatever the jitter, and what repeats shifts by whatever it is told.
  bool isContradicted() const;
  /// Both checks say so clearly: what says two things fits more by chance.
  bool isContradictedTwice() const;
  /// Trials that leave hardly more than the best one, and say no more.
  std::vector<std::size_t> rivals() const;
};

/// Of the world. Expects pairs of these trials.
JitterFit jitterFit(const JitterEvidence& evidence, const std::vector<JitterTrial>& trials);

/// The one that makes what pictures of a camera at rest are displaced by, where all that would displace them
/// otherwise is clearly worse; trials of another length do not count, see RestingPictures. A consistency
/// check that aliasing does not mislead. Nothing: it does not say.
std::optional<std::size_t> trialAtRest(const JitterEvidence& evidence,
                                       const std::vector<JitterTrial>& trials);

/// Whether the sky rests while the world shifts as a trial has it; nothing where it does not say.
std::optional<bool> isSkyResting(const JitterEvidence& evidence, std::size_t trial);

/// What the sky shifts by, of what is stated: 1 as all else, 0 not at all. Nothing where too few shifts are
/// measured, or they are no share of it; nor where the trial of about that length leaves no less than what is
/// stated: grain of its own shifts by any share. Expects trials of the evidence.
std::optional<double> skyFactor(const JitterEvidence& evidence, const std::vector<JitterTrial>& trials);

} // namespace taa::doctor
