#include "core/doctor/color/ColorCheck.h"

#include "core/base/Say.h"
#include "core/doctor/color/InterfaceCheck.h"

#include <utility>

namespace taa::doctor {

namespace {

/// How sharp a texture is before it is filtered is in no frame: one that is drawn too soft looks like one
/// that has less detail.
void tellTextures(Diagnosis& out) {
  out.parts.leaveOpen(
      {say<"Bias of textures' level of detail">(),
       say<"a texture that is drawn too sharp or too soft looks like one of more or of less "
           "detail">(),
       say<"Compare with a capture that is drawn with another bias: with TAA that keeps the "
           "size of pictures 0 or a little less is right, with one that enlarges them log₂ of "
           "the width that is drawn over that of the output.">(),
       {Fault::MipBiasMissing, Fault::MipBiasLeftOn}});
}

} // namespace

void ColorEvidence::add(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels) {
  tiles.add(frames, labels);
  brightness.add(frames);
  coplanar.add(frames);
  blended.add(frames);
  outlier.add(frames, labels);
  light.add(frames.now);
}

std::vector<std::uint8_t> tellInterface(const ColorEvidence& evidence, Diagnosis& out) {
  const ScreenGroups groups = interfaceGroups(evidence.tiles);
  tellInterface(groups, evidence.tiles, out);
  return coveredPixels(groups.clear, evidence.tiles);
}

void tellInterfaceLeft(const ColorEvidence& evidence, bool isFound, bool isJitterOpen, Diagnosis& out) {
  tellInterfaceLeft(interfaceGroups(evidence.tiles), evidence.tiles, isFound, isJitterOpen, out);
}

FrameReader coveredReader(const FrameReader& read, std::vector<std::uint8_t> covered) {
  return [read, covered = std::move(covered)](int frame) {
    DoctorFrame out = read(frame);
    out.covered = covered;
    return out;
  };
}

void tellColor(const ColorEvidence& evidence, const BrightnessEvidence& brightness,
               const CaptureInfo& captureInfo, bool isMaskUsed, Diagnosis& out) {
  tellBlended(evidence.blended, isMaskUsed, out);
  tellBrightness(brightness, captureInfo, out);
  tellCoplanar(evidence.coplanar, captureInfo, out);
  tellTextures(out);
  tellEncoding(evidence.light, captureInfo, out);
}

} // namespace taa::doctor
