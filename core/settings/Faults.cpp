#include "core/settings/Faults.h"

#include "core/base/Error.h"
#include "core/base/NearestNames.h"
#include "core/base/Say.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <array>
#include <map>

namespace taa {

namespace {

using FaultValues = std::map<const Parameter*, double>;

// fault, id, label, part, reach, symptom, assignments
constexpr FaultInfo kFaults[] = {
    {Fault::JitterNegatedX, FaultPart::Jitter, FaultReach::Any, "jitterNegatedX", "Jitter's x negated",
     "A still picture is aliased and shakes sideways.", "fault.jitter=negatedX"},
    {Fault::JitterNegatedY, FaultPart::Jitter, FaultReach::Any, "jitterNegatedY", "Jitter's y negated",
     "A still picture is aliased and shakes up and down.", "fault.jitter=negatedY"},
    {Fault::JitterNegated, FaultPart::Jitter, FaultReach::Any, "jitterNegated", "Jitter negated",
     "A still picture is aliased and shakes.", "fault.jitter=negated"},
    {Fault::JitterSwapped, FaultPart::Jitter, FaultReach::Any, "jitterSwapped", "Jitter's axes swapped",
     "A still picture is aliased and shakes along the diagonal.", "fault.jitter=swapped"},
    {Fault::JitterDoubled, FaultPart::Jitter, FaultReach::Any, "jitterDoubled",
     "Jitter reported twice too large", "A still picture shakes, softer than it could be.",
     "fault.jitterReported=2"},
    {Fault::JitterHalved, FaultPart::Jitter, FaultReach::Any, "jitterHalved",
     "Jitter reported half too small", "A still picture is less anti-aliased than it could be.",
     "fault.jitterReported=0.5"},
    {Fault::JitterOutside, FaultPart::Jitter, FaultReach::Drawn, "jitterOutside",
     "Jitter beyond half a pixel", "Everything is blurred, moving or not.",
     "fault.jitterApplied=2 fault.jitterReported=2"},
    {Fault::JitterNotApplied, FaultPart::Jitter, FaultReach::Drawn, "jitterNotApplied",
     "Jitter reported, not applied", "TAA seems to work, and edges stay stairs.", "fault.jitterApplied=0"},
    {Fault::JitterNotReported, FaultPart::Jitter, FaultReach::Any, "jitterNotReported",
     "Jitter applied, not reported",
     "The picture is a little soft, because samples are taken for pixels' centers.",
     "fault.jitter=unreported"},
    {Fault::JitterFrozen, FaultPart::Jitter, FaultReach::Drawn, "jitterFrozen", "Jitter frozen",
     "Nothing is anti-aliased, and all of the picture is shifted.", "fault.jitterPeriod=1"},
    {Fault::JitterMean, FaultPart::Jitter, FaultReach::Drawn, "jitterMean", "Jitter's mean not 0",
     "The whole picture is shifted by a constant part of a pixel.",
     "fault.jitterMeanX=0.25 fault.jitterMeanY=0.125"},
    {Fault::JitterShort, FaultPart::Jitter, FaultReach::Drawn, "jitterShort", "Jitter's sequence too short",
     "Edges keep a rest of their stairs however long one waits.", "fault.jitterPeriod=2"},
    {Fault::JitterLate, FaultPart::Jitter, FaultReach::Any, "jitterLate", "Jitter reported a frame late",
     "A still picture shakes twice as much as without any correction.", "fault.jitter=late"},
    {Fault::JitterEarly, FaultPart::Jitter, FaultReach::Any, "jitterEarly", "Jitter reported a frame early",
     "A still picture shakes twice as much as without any correction.", "fault.jitter=early"},
    {Fault::DepthNotJittered, FaultPart::Jitter, FaultReach::Drawn, "depthNotJittered",
     "Depth without jitter", "Rims at every edge: depth and color do not lie on each other.",
     "fault.depthJitter=0"},
    {Fault::SkyNotJittered, FaultPart::Jitter, FaultReach::Drawn, "skyNotJittered", "Sky without jitter",
     "The sky is not anti-aliased, and shifted against what stands before it.", "fault.skyJitter=0"},
    {Fault::MotionJitterThis, FaultPart::Motion, FaultReach::Any, "motionJitterThis",
     "This frame's jitter in motion", "The whole picture trembles, at rest too.", "fault.motionJitter=this"},
    {Fault::MotionJitterLast, FaultPart::Motion, FaultReach::Any, "motionJitterLast",
     "The last frame's jitter in motion", "The whole picture trembles, at rest too.",
     "fault.motionJitter=last"},
    {Fault::MotionJitterBoth, FaultPart::Motion, FaultReach::Any, "motionJitterBoth",
     "Both jitters in motion", "The whole picture trembles, and is softer.", "fault.motionJitter=both"},
    {Fault::MotionNegatedX, FaultPart::Motion, FaultReach::Any, "motionNegatedX", "Motion's x negated",
     "Ghosts grow with speed where things move sideways.", "fault.motionX=-1"},
    {Fault::MotionNegatedY, FaultPart::Motion, FaultReach::Any, "motionNegatedY", "Motion's y negated",
     "Ghosts grow with speed where things move up or down.", "fault.motionY=-1"},
    {Fault::MotionNegated, FaultPart::Motion, FaultReach::Any, "motionNegated", "Motion's direction reversed",
     "Ghosts grow with speed, before what moves.", "fault.motionX=-1 fault.motionY=-1"},
    {Fault::MotionSwapped, FaultPart::Motion, FaultReach::Any, "motionSwapped", "Motion's axes swapped",
     "Ghosts grow with speed, across what moves.", "fault.motionSwapped=on"},
    {Fault::MotionDoubled, FaultPart::Motion, FaultReach::Any, "motionDoubled", "Motion twice too large",
     "Ghosts grow with speed.", "fault.motionX=2 fault.motionY=2"},
    {Fault::MotionHalved, FaultPart::Motion, FaultReach::Any, "motionHalved", "Motion half too small",
     "Ghosts grow with speed.", "fault.motionX=0.5 fault.motionY=0.5"},
    {Fault::MotionInUv, FaultPart::Motion, FaultReach::Any, "motionInUv", "Motion in texture coordinates",
     "Everything that moves smears, as if there were no motion vectors.", "fault.motionUnit=uv"},
    {Fault::MotionInNdc, FaultPart::Motion, FaultReach::Any, "motionInNdc", "Motion in device coordinates",
     "Everything that moves smears, as if there were no motion vectors.", "fault.motionUnit=ndc"},
    {Fault::MotionEncoded, FaultPart::Motion, FaultReach::Any, "motionEncoded",
     "Encoded motion read as it is", "Constant motion everywhere: history comes from half a picture away.",
     "fault.motionUnit=biased"},
    {Fault::MotionRoot, FaultPart::Motion, FaultReach::Any, "motionRoot", "Root of motion read as it is",
     "Slow things smear more than fast ones.", "fault.motionUnit=root"},
    {Fault::MotionUnwritten, FaultPart::Motion, FaultReach::Any, "motionUnwritten",
     "\"Not written\" read as motion", "Wild regions: history comes from outside of the picture.",
     "fault.motionUnit=unwritten fault.region=sky"},
    {Fault::MotionShifted, FaultPart::Motion, FaultReach::Any, "motionShifted",
     "Motion read at the wrong texel", "Fringes at the edges of what moves.", "fault.motionShift=1"},
    {Fault::MotionZero, FaultPart::Motion, FaultReach::Any, "motionZero", "No motion at all",
     "Everything that moves smears.", "fault.motion=zero"},
    {Fault::MotionCameraOnly, FaultPart::Motion, FaultReach::Any, "motionCameraOnly",
     "Objects write no motion", "What moves by itself ghosts; what rests is right.",
     "fault.motion=cameraOnly"},
    {Fault::MotionWithoutCamera, FaultPart::Motion, FaultReach::Any, "motionWithoutCamera",
     "Motion without the camera's", "Everything smears while the camera moves.",
     "fault.previousCamera=ofNow"},
    {Fault::ZeroTakenAsMissing, FaultPart::Motion, FaultReach::Any, "zeroTakenAsMissing",
     "Zero motion taken for missing", "A still picture softens: its history is dropped.",
     "fault.zeroIsMissing=on"},
    {Fault::PreviousTwoFramesOld, FaultPart::Motion, FaultReach::Any, "previousTwoFramesOld",
     "Previous transforms two frames old", "Everything that moves ghosts: motion is twice as long.",
     "fault.previousAge=2"},
    {Fault::MotionLingers, FaultPart::Motion, FaultReach::Any, "motionLingers", "Motion a frame late",
     "Edges break for a frame when something stops or starts.", "fault.motionLag=1"},
    {Fault::SkinningOfNow, FaultPart::Motion, FaultReach::Any, "skinningOfNow",
     "Skinning with the current pose for both", "Ghosts on limbs only.",
     "fault.motion=cameraOnly fault.region=deforming"},
    {Fault::SkyWithoutMotion, FaultPart::Motion, FaultReach::Any, "skyWithoutMotion", "Sky without motion",
     "The sky smears while the camera turns.", "fault.motion=zero fault.region=sky"},
    {Fault::CameraTurned, FaultPart::Motion, FaultReach::Any, "cameraTurned",
     "Previous matrix uniformly wrong", "A double image that sticks to the screen.",
     "fault.previousCamera=turned"},
    {Fault::CameraOfMirror, FaultPart::Motion, FaultReach::Any, "cameraOfMirror",
     "Previous camera of a mirror", "Everything smears by the same matrix.", "fault.previousCamera=mirrored"},
    {Fault::CameraOfSecondView, FaultPart::Motion, FaultReach::Any, "cameraOfSecondView",
     "Previous camera of a second view", "Everything smears, near things more than far ones.",
     "fault.previousCamera=secondView"},
    {Fault::PreviousIdentity, FaultPart::Motion, FaultReach::Any, "previousIdentity",
     "Previous matrix never set", "One frame of long motion at first sight.",
     "fault.previousCamera=identity fault.firstFrame=8 fault.lastFrame=8"},
    {Fault::OldTransformOnReturn, FaultPart::Motion, FaultReach::Any, "oldTransformOnReturn",
     "Object comes back with its old transform", "One frame of garbage where it appears.",
     "fault.previousAge=8 fault.region=moving fault.firstFrame=12 fault.lastFrame=12"},
    {Fault::MotionCoarse, FaultPart::Motion, FaultReach::Any, "motionCoarse", "Motion of a lower resolution",
     "Wrong at edges, fine in the middle.", "fault.motionCoarse=2"},
    {Fault::MotionUntested, FaultPart::Motion, FaultReach::Drawn, "motionUntested",
     "Objects' motion drawn without the depth test",
     "What stands still smears where something moves behind it.", "fault.motionUntested=on"},
    {Fault::TransparentsWithoutMotion, FaultPart::Motion, FaultReach::Drawn, "transparentsWithoutMotion",
     "Transparents write no motion", "Particles and glass ghost.", "inputs.blended=before"},
    {Fault::TransparentsOverwriteMotion, FaultPart::Motion, FaultReach::Drawn, "transparentsOverwriteMotion",
     "Transparents overwrite the motion behind", "What is behind glass smears.",
     "inputs.blended=beforeWithMotion"},
    {Fault::DepthReversed, FaultPart::Depth, FaultReach::Any, "depthReversed", "Depth the other way around",
     "Dilation follows what is behind, and disocclusion is found everywhere or nowhere.",
     "fault.depth=reversed"},
    {Fault::DepthLinear, FaultPart::Depth, FaultReach::Any, "depthLinear",
     "Linear depth taken for device depth", "Disocclusion is found everywhere or nowhere.",
     "fault.depth=linear"},
    {Fault::NearPlaneWrong, FaultPart::Depth, FaultReach::Any, "nearPlaneWrong", "Near plane wrong",
     "Every view depth is wrong by the same factor.", "fault.nearPlane=2"},
    {Fault::DepthCoarse, FaultPart::Depth, FaultReach::Any, "depthCoarse", "Depth of a lower resolution",
     "Wrong at edges, fine in the middle.", "fault.depthCoarse=2"},
    {Fault::ExposureStep, FaultPart::Color, FaultReach::Any, "exposureStep",
     "Exposure changes between frames", "A flash, then a slow fade.", "fault.exposure=1 fault.firstFrame=8"},
    {Fault::InterfaceBefore, FaultPart::Color, FaultReach::Any, "interfaceBefore", "Interface in the picture",
     "Text and bars smear while the camera moves.", "fault.interface=still"},
    {Fault::InterfaceJittered, FaultPart::Color, FaultReach::Any, "interfaceJittered",
     "Interface drawn jittered", "Text and bars shake.", "fault.interface=jittered"},
    {Fault::MipBiasMissing, FaultPart::Color, FaultReach::Drawn, "mipBiasMissing", "Textures too soft",
     "Blur that no sharpening takes away: the bias of the level of detail is missing or of the wrong sign.",
     "inputs.mipBias=1"},
    {Fault::MipBiasLeftOn, FaultPart::Color, FaultReach::Drawn, "mipBiasLeftOn", "Textures too sharp",
     "Textures crawl: a negative bias stays where nothing accumulates it away.", "inputs.mipBias=-3"},
    {Fault::DilatesFarthest, FaultPart::Resolve, FaultReach::Any, "dilatesFarthest",
     "Dilation picks the farthest", "Halos at the edges of what moves.", "dilate.method=farthest3x3"},
    {Fault::OffScreenClamped, FaultPart::Resolve, FaultReach::Any, "offScreenClamped",
     "Off-screen history clamped", "Streaks at the border while the camera moves.",
     "validate.offScreen=keep history.border=edge"},
    {Fault::NoResetAtCut, FaultPart::Resolve, FaultReach::Any, "noResetAtCut", "No reset at a cut",
     "The old image bleeds into the new one.", "fault.keepsAtCuts=on"},
    {Fault::HistoryNotSwapped, FaultPart::Resolve, FaultReach::Any, "historyNotSwapped",
     "History not swapped", "Two pictures take turns: each frame goes on from the one before the last.",
     "fault.notSwapped=on"},
    {Fault::HistoryReadJittered, FaultPart::Resolve, FaultReach::Any, "historyReadJittered",
     "History read with jitter", "A still picture shakes, softer than without TAA.",
     "fault.historyJitter=on"},
    {Fault::NanKept, FaultPart::Resolve, FaultReach::Any, "nanKept", "NaN in the history",
     "A blob that grows from frame to frame.", "fault.nan=on"},
    {Fault::AlphaOne, FaultPart::Resolve, FaultReach::Any, "alphaOne",
     "Nothing accumulates, and jitter is left on", "TAA does nothing: the picture shakes with the jitter.",
     "weight.source=constant weight.alpha=1 current.filter=center"},
    {Fault::AlphaZero, FaultPart::Resolve, FaultReach::Any, "alphaZero", "Nothing new is taken",
     "The picture freezes where nothing rejects it.", "weight.source=constant weight.alpha=0"},
    {Fault::LowPrecision, FaultPart::Resolve, FaultReach::Any, "lowPrecision", "History of few bits",
     "Drift and a tint in a long rest.", "history.precision=unorm8"},
    {Fault::BoxOfCorners, FaultPart::Resolve, FaultReach::Any, "boxOfCorners", "Box converted by its corners",
     "Wrong colors: the lower corner can be the higher.", "fault.boxCorners=on"},
};

constexpr std::string_view kFaultGroup = "fault.";

/// Of the group: rows that say where, when and how much, and are no fault by themselves.
constexpr std::array<std::string_view, 9> kFaultDetails{
    "fault.cameraTurn", "fault.region", "fault.object",     "fault.left",     "fault.top",
    "fault.right",      "fault.bottom", "fault.firstFrame", "fault.lastFrame"};

/// Of the details: rows that hold for all faults that are injected; the others for those of planes.
bool saysWhen(const Parameter& row) {
  return row.path == "fault.firstFrame" || row.path == "fault.lastFrame";
}

bool isFaultDetail(const Parameter& row) {
  return std::ranges::find(kFaultDetails, row.path) != kFaultDetails.end();
}

/// Calls `tell` with each assignment of the row.
template <typename Tell>
void forEachAssignment(const FaultInfo& info, Tell tell) {
  std::string_view rest = info.assignments;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    tell(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

FaultValues injectedValues(Fault fault) {
  FaultValues values;
  forEachAssignment(faultInfo(fault), [&](std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    const Parameter& row = parameter(assignment.substr(0, equals));
    values.emplace(&row, parseValue(row, assignment.substr(equals + 1)));
  });
  return values;
}

bool isOfPlanes(const FaultInfo& info) {
  return info.assignments.starts_with(kFaultGroup) &&
         (info.part == FaultPart::Motion || info.part == FaultPart::Depth || info.part == FaultPart::Color);
}

} // namespace

std::span<const FaultInfo> faultTable() {
  return kFaults;
}

const FaultInfo& faultInfo(Fault fault) {
  return kFaults[static_cast<std::size_t>(fault)];
}

const FaultInfo& faultInfo(std::string_view id) {
  const auto found = std::ranges::find(kFaults, id, &FaultInfo::id);
  if (found != std::end(kFaults)) return *found;
  std::vector<std::string_view> ids;
  for (const FaultInfo& info : kFaults) ids.push_back(info.id);
  const std::vector<std::string_view> near = nearestNames(id, ids, 3);
  throw Error(say<"there is no fault \"%1\"; near it are %2, %3 or %4">(id, near[0], near[1], near[2]));
}

std::string_view faultPartLabel(FaultPart part) {
  constexpr std::array<std::string_view, 5> kLabels{"Jitter", "Motion vectors", "Depth", "Color", "Resolve"};
  return kLabels[static_cast<std::size_t>(part)];
}

void inject(Fault fault, Settings& settings) {
  for (const auto& [row, value] : injectedValues(fault)) row->set(settings, value);
}

bool injectHalf(Fault fault, Settings& settings) {
  Settings half = settings;
  for (const auto& [row, value] : injectedValues(fault)) {
    const double healthy = row->defaultValue();
    const bool isGradual = row->kind == ParameterKind::Number && value * healthy >= 0.0;
    if (!isGradual && !isFaultDetail(*row)) return false;
    row->set(half, isGradual ? 0.5 * (healthy + value) : value);
  }
  settings = half;
  return true;
}

bool isInjected(Fault fault, const Settings& settings) {
  return std::ranges::all_of(injectedValues(fault),
                             [&](const auto& entry) { return entry.first->get(settings) == entry.second; });
}

void withdraw(Fault fault, const Settings& healthy, Settings& settings) {
  for (const auto& [row, value] : injectedValues(fault)) row->set(settings, row->get(healthy));
}

bool excludeEachOther(Fault a, Fault b) {
  const FaultValues ofA = injectedValues(a), ofB = injectedValues(b);
  const auto differs = [](const FaultValues& values, const Parameter& row, double value) {
    const auto found = values.find(&row);
    return found != values.end() && found->second != value;
  };
  // Of faulty planes all are so in the same region; of all that is injected all is so in the same frames.
  const bool shareAPlace = isOfPlanes(faultInfo(a)) && isOfPlanes(faultInfo(b));
  const bool shareFrames =
      faultInfo(a).assignments.starts_with(kFaultGroup) && faultInfo(b).assignments.starts_with(kFaultGroup);
  return std::ranges::any_of(parameters(), [&](const Parameter& row) {
    const auto wantsOther = [&](const FaultValues& one, const FaultValues& other) {
      if (const auto found = one.find(&row); found != one.end()) return differs(other, row, found->second);
      const bool isShared = saysWhen(row) ? shareFrames : shareAPlace && isFaultDetail(row);
      return isShared && differs(other, row, row.defaultValue());
    };
    return wantsOther(ofA, ofB) || wantsOther(ofB, ofA);
  });
}

bool isFaulty(const Settings& settings) {
  return std::ranges::any_of(parameters(), [&](const Parameter& row) {
    return row.stage == Stage::Faults && !isFaultDetail(row) && row.get(settings) != row.defaultValue();
  });
}

std::vector<std::string> injectedFaults(const Settings& settings) {
  if (!isFaulty(settings)) return {};
  std::vector<std::string> all = differences(settings, Settings{});
  std::erase_if(all, [](const std::string& assignment) { return !isOfFaults(assignment); });
  return all;
}

bool isOfFaults(const std::string& assignment) {
  return assignment.starts_with(kFaultGroup);
}

void clearFaults(Settings& settings) {
  settings.fault = FaultSettings{};
}

} // namespace taa
