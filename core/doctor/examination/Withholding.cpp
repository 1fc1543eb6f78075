#include "core/doctor/examination/Withholding.h"

#include "core/base/Say.h"
#include "core/settings/Faults.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

namespace taa::doctor {

namespace {

constexpr std::string_view kJitterInMotion = "motionJitter"; ///< ids of such findings begin so

/// Takes findings of motion back that are not sure, for `reason`.
void withhold(std::size_t first, const std::function<bool(const Finding&)>& isUnsure, Undecided reason,
              Diagnosis& out) {
  const auto unsure =
      std::remove_if(out.findings.begin() + static_cast<std::ptrdiff_t>(first), out.findings.end(), isUnsure);
  if (unsure == out.findings.end()) return;
  out.findings.erase(unsure, out.findings.end());
  out.parts.leaveOpen(std::move(reason));
}

} // namespace

void withholdParts(std::size_t first, Diagnosis& out) {
  const auto isOfPart = [](const Finding& finding) {
    return !finding.isWholePicture && !std::ranges::all_of(finding.regions, &RegionPlace::isSky);
  };
  withhold(first, isOfPart,
           {say<"Motion of parts">(),
            say<"depth says which pixels are one part, and it is of a lower resolution">(),
            say<"Mend depth first, or capture object numbers, too.">(),
            {},
            true},
           out);
}

void withholdMotion(const JitterOutcome& jitter, std::size_t first, Diagnosis& out) {
  const auto isUnsure = [&](const Finding& finding) {
    return (jitter.isContradicted && !finding.isWholePicture) || finding.id.starts_with(kJitterInMotion);
  };
  withhold(first, isUnsure,
           {say<"Motion">(),
            say<"it does not fit, but pictures do not shift as the jitter that is stated either">(),
            say<"Mend jitter first.">(),
            {},
            true},
           out);
}

void withholdSky(std::size_t first, Diagnosis& out) {
  const auto isOfPart = [](const Finding& finding) {
    return finding.id.starts_with(kJitterInMotion) && !finding.isWholePicture;
  };
  const std::string_view found = faultInfo(Fault::SkyNotJittered).id;
  if (std::ranges::find(out.findings, found, &Finding::id) == out.findings.end()) return;
  withhold(first, isOfPart,
           {say<"Jitter in motion">(),
            say<"the sky is drawn without the jitter that it is examined by">(),
            say<"Mend the sky first.">(),
            {},
            true},
           out);
}

} // namespace taa::doctor
