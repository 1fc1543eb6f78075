// What is wrong with the pictures themselves: an interface in them, steps of brightness, surfaces that fight,
// textures too sharp or too soft.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/color/BlendedSurfaces.h"
#include "core/doctor/color/BrightnessSteps.h"
#include "core/doctor/color/CoplanarFlips.h"
#include "core/doctor/color/OutlierPixels.h"
#include "core/doctor/color/ScreenEncoding.h"
#include "core/doctor/color/ScreenTiles.h"
#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionTrials.h"

#include <cstdint>
#include <vector>

namespace taa::doctor {

/// Over all pairs of frames.
struct ColorEvidence {
  ScreenTiles tiles;
  BrightnessEvidence brightness;
  CoplanarEvidence coplanar;
  BlendedEvidence blended;
  OutlierPixels outlier;
  BrightLight light;

  /// `labels`: of `frames.now`.
  void add(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels);
};

/// Adds what is wrong about an interface in the pictures. Returns the pixels that it covers, see
/// DoctorFrame::covered.
std::vector<std::uint8_t> tellInterface(const ColorEvidence& evidence, Diagnosis& out);
/// Adds what is right or not decided about one, see there.
void tellInterfaceLeft(const ColorEvidence& evidence, bool isFound, bool isJitterOpen, Diagnosis& out);
/// The same frames, in which covered pixels are no evidence.
FrameReader coveredReader(const FrameReader& read, std::vector<std::uint8_t> covered);

/// Adds all else about color. Expects evidence of frames in which interfaces are covered. `brightness`: of
/// the frames as they are. `isMaskUsed`: see tellBlended().
void tellColor(const ColorEvidence& evidence, const BrightnessEvidence& brightness,
               const CaptureInfo& captureInfo, bool isMaskUsed, Diagnosis& out);

} // namespace taa::doctor
