#include "core/doctor/motion/MotionOpen.h"

#include "core/doctor/motion/MotionWords.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace taa::doctor {

namespace {

// An explanation is refuted where it leads elsewhere at so many pixels and leaves so many times as much.
constexpr std::size_t kEnoughToRefute = 150;
constexpr double kRefutingFactor = 1.2;

/// What no explanation of the sky is, and what only it has.
bool isOfRegion(Fault fault, bool isSky) {
  switch (fault) {
  case Fault::SkyWithoutMotion:
    return isSky;
  case Fault::MotionZero:
  case Fault::MotionCameraOnly:
  case Fault::SkinningOfNow:
  case Fault::OldTransformOnReturn:
  case Fault::PreviousTwoFramesOld:
    return !isSky;
  default:
    return true;
  }
}

/// Decided by the values themselves, or at silhouettes.
bool isSeenElsewhere(Fault fault) {
  return fault == Fault::MotionUnwritten || fault == Fault::ZeroTakenAsMissing ||
         fault == Fault::MotionShifted || fault == Fault::MotionCoarse;
}

std::vector<Fault> faultsOfRegion(bool isSky) {
  std::vector<Fault> out;
  for (const FaultInfo& info : faultTable())
    if (info.part == FaultPart::Motion && isOfRegion(info.fault, isSky) && !isSeenElsewhere(info.fault))
      out.push_back(info.fault);
  return out;
}

/// Faults that an explanation is.
void closeFault(const JudgedRegion& region, const MotionTrial& trial, std::vector<Fault>& open) {
  const std::string id = motionFault(&trial, *region.region, *region.evidence).id;
  std::erase_if(open, [&](Fault fault) {
    // Twice as long, of objects that move evenly, is two frames old.
    const bool isSame = id == faultInfo(Fault::MotionDoubled).id && fault == Fault::PreviousTwoFramesOld;
    return faultInfo(fault).id == id || isSame;
  });
}

} // namespace

std::vector<Fault> openFaults(const JudgedRegion& region, const std::vector<MotionTrial>& trials) {
  const bool isSky = region.region->isSky;
  // What depth and matrices make is right, or that of something that moves besides, or lies over it.
  if (isConfirmed(*region.evidence))
    return isSky ? std::vector<Fault>{Fault::InterfaceBefore}
                 : std::vector<Fault>{Fault::InterfaceBefore, Fault::MotionCameraOnly, Fault::SkinningOfNow};
  std::vector<Fault> open = faultsOfRegion(isSky);
  for (std::size_t t = 1; t < trials.size(); ++t) {
    const TrialEvidence& evidence = region.evidence->trials[t];
    if (evidence.pixels >= kEnoughToRefute && evidence.tried >= kRefutingFactor * evidence.given)
      closeFault(region, trials[t], open);
  }
  return open;
}

std::vector<Fault> openFaultsOfUnseen() {
  return faultsOfRegion(false);
}

void addFaults(const std::vector<Fault>& more, std::vector<Fault>& faults) {
  for (const Fault fault : more)
    if (std::ranges::find(faults, fault) == faults.end()) faults.push_back(fault);
}

} // namespace taa::doctor
