#include "core/doctor/jitter/JitterSky.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/jitter/JitterFit.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// Of the pictures: a sky that is smaller is none that anybody sees tremble.
constexpr double kLeastSky = 0.02;

Finding restingSky(const TrialFit& fit, const RegionPlace& place) {
  Finding out = faultFinding(Fault::SkyNotJittered);
  out.regions = {place};
  out.reason =
      say<"In %1 of %2 pairs of frames the sky fits the one before better without jitter, to %3 % of what "
          "is left with it; all else shifts with the jitter.">(fit.won, fit.pairs,
                                                               std::lround(100.0 * fit.share()));
  out.change = say<"Draw the sky with the projection that all else is drawn with, jitter included.">();
  out.measure = say<"median difference of luma in the sky, × 1000">();
  out.residuals = {{"notApplied", say<"none in the sky">(), 1000.0 * fit.tried / fit.pairs, false, true},
                   {"asStated", say<"as in all else">(), 1000.0 * fit.stated / fit.pairs, true, false}};
  return out;
}

Finding otherSky(const TrialFit& fit, double factor, const RegionPlace& place) {
  Finding out = restingSky(fit, place);
  out.name = say<"Sky with another jitter">();
  out.reason =
      say<"Measured in the middle of all pairs of frames, the sky shifts by %1 times the jitter that "
          "is stated; all else shifts with the jitter.">(shortNumber(factor));
  out.measure = say<"shift of the sky, of the jitter that is stated">();
  out.residuals = {{"measured", say<"measured">(), factor, false, true},
                   {"asStated", say<"as in all else">(), 1.0, true, false}};
  return out;
}

/// Whether the sky shifts by another share of the jitter than the world, which shifts as is stated. A small
/// share is none: what rests is told by what it leaves.
bool isOtherShare(std::optional<double> factor) {
  constexpr double kLeastShare = 0.25, kLeastFromOne = 0.3;
  return factor && *factor >= kLeastShare && std::abs(*factor - 1.0) >= kLeastFromOne;
}

} // namespace

void tellSky(const JitterEvidence& evidence, const std::vector<JitterTrial>& trials, std::size_t trial,
             const RegionPlace& place, Diagnosis& out) {
  // The world itself shifts as if there were none: then the sky is as all else.
  if (trial == kNotAppliedTrial || evidence.skyShare < kLeastSky * evidence.pairs) return;
  const std::optional<bool> isResting = isSkyResting(evidence, trial);
  const std::optional<double> factor = trial == 0 ? skyFactor(evidence, trials) : std::nullopt;
  if (!isResting)
    out.parts.leaveOpen({say<"Jitter of the sky">(),
                         say<"it has too little detail to measure a shift">(),
                         say<"Capture clouds, or a sky with a texture.">(),
                         {Fault::SkyNotJittered}});
  else if (*isResting)
    out.findings.push_back(restingSky(fitOf(evidence.sky, kNotAppliedTrial, trial), place));
  else if (isOtherShare(factor))
    out.findings.push_back(otherSky(fitOf(evidence.sky, kNotAppliedTrial, trial), *factor, place));
}

} // namespace taa::doctor
