// The faults of an integration that can be injected: one table for menus, the doctor and the tests.
#pragma once

#include "core/settings/Settings.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// In the order of the table.
enum class Fault : std::uint8_t {
  JitterNegatedX,
  JitterNegatedY,
  JitterNegated,
  JitterSwapped,
  JitterDoubled,
  JitterHalved,
  JitterOutside,
  JitterNotApplied,
  JitterNotReported,
  JitterFrozen,
  JitterMean,
  JitterShort,
  JitterLate,
  JitterEarly,
  DepthNotJittered,
  SkyNotJittered,
  MotionJitterThis,
  MotionJitterLast,
  MotionJitterBoth,
  MotionNegatedX,
  MotionNegatedY,
  MotionNegated,
  MotionSwapped,
  MotionDoubled,
  MotionHalved,
  MotionInUv,
  MotionInNdc,
  MotionEncoded,
  MotionRoot,
  MotionUnwritten,
  MotionShifted,
  MotionZero,
  MotionCameraOnly,
  MotionWithoutCamera,
  ZeroTakenAsMissing,
  PreviousTwoFramesOld,
  MotionLingers,
  SkinningOfNow,
  SkyWithoutMotion,
  CameraTurned,
  CameraOfMirror,
  CameraOfSecondView,
  PreviousIdentity,
  OldTransformOnReturn,
  MotionCoarse,
  MotionUntested,
  TransparentsWithoutMotion,
  TransparentsOverwriteMotion,
  DepthReversed,
  DepthLinear,
  NearPlaneWrong,
  DepthCoarse,
  ExposureStep,
  InterfaceBefore,
  InterfaceJittered,
  MipBiasMissing,
  MipBiasLeftOn,
  DilatesFarthest,
  OffScreenClamped,
  NoResetAtCut,
  HistoryNotSwapped,
  HistoryReadJittered,
  NanKept,
  AlphaOne,
  AlphaZero,
  LowPrecision,
  BoxOfCorners
};

/// What of an integration is wrong.
enum class FaultPart : std::uint8_t { Jitter, Motion, Depth, Color, Resolve };

/// Which frames it can be injected into.
enum class FaultReach : std::uint8_t {
  Any,  ///< those of the renderer and those of a capture
  Drawn ///< those of the renderer: a capture is drawn already
};

struct FaultInfo {
  Fault fault;
  FaultPart part;
  FaultReach reach;
  std::string_view id;          ///< in files and flags: "motionNegatedY"
  std::string_view label;       ///< in the window
  std::string_view symptom;     ///< what one sees, in a sentence
  std::string_view assignments; ///< "path=value path=value": the settings that inject it
};

std::span<const FaultInfo> faultTable();
const FaultInfo& faultInfo(Fault fault);
/// Throws Error that names the nearest ids when there is none.
const FaultInfo& faultInfo(std::string_view id);
/// As a heading: "Motion vectors".
std::string_view faultPartLabel(FaultPart part);

/// Sets what injects it, at the strength of the table; other settings stay.
void inject(Fault fault, Settings& settings);
/// The same at half of that strength: what is between healthy and faulty. False, and nothing is set, where
/// there is no such thing, as of a choice or a sign.
bool injectHalf(Fault fault, Settings& settings);
/// Whether all that injects it is set, at the strength of the table.
bool isInjected(Fault fault, const Settings& settings);
/// Gives what injects it the values of `healthy`; other settings stay.
void withdraw(Fault fault, const Settings& healthy, Settings& settings);
/// Whether the two want different values of one setting, or faulty planes in different places, so that only
/// one of them can be injected.
bool excludeEachOther(Fault a, Fault b);

/// Whether frames that these settings make are faulty on purpose: rows of the group `fault` that have an
/// effect of their own differ from their defaults. Faults that are choices of a technique are no part of it:
/// presets make them too.
bool isFaulty(const Settings& settings);
/// Those rows, and what says where, when and how much: "fault.motionY=-1". Empty where isFaulty() is not.
std::vector<std::string> injectedFaults(const Settings& settings);
/// Of an assignment: whether it is of the group, "fault.motionY=-1".
bool isOfFaults(const std::string& assignment);
/// The same without any of the group.
void clearFaults(Settings& settings);

} // namespace taa
