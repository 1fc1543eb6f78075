#include "core/doctor/color/ScreenEncoding.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"

#include <algorithm>

namespace taa::doctor {

namespace {

constexpr double kAboveScreen = 1.5, kBrightPixelShare = 1e-3;

/// Of luma as it is compared: l / (1 + l).
double lightOfLuma(float luma) {
  constexpr double kMostOfLuma = 0.9999;
  const double kept = std::min(static_cast<double>(luma), kMostOfLuma);
  return kept / (1.0 - kept);
}

Finding encodedLight(const BrightLight& light) {
  Finding out;
  out.id = "colorEncoding";
  out.name = say<"Color is not encoded as stated">();
  out.isWholePicture = true;
  out.reason = say<"Color is stated as encoded for a screen, which ends at 1; decoded it goes up to %1.">(
      shortNumber(light.most));
  out.symptom = say<"Contrast is too strong, and dark parts are too dark.">();
  out.change = say<"State color.encoding=linear, or encode color before it is stored.">();
  return out;
}

} // namespace

void BrightLight::add(const DoctorFrame& frame) {
  for (const float luma : frame.luma.pixels) {
    const double light = lightOfLuma(luma);
    pixels += 1.0;
    if (!(light > kAboveScreen)) continue; // nor NaN
    bright += 1.0;
    most = std::max(most, light);
  }
}

bool BrightLight::isSeen() const {
  return bright > kBrightPixelShare * pixels;
}

void tellEncoding(const BrightLight& light, const CaptureInfo& captureInfo, Diagnosis& out) {
  if (!captureInfo.conventions || light.pixels == 0.0) return;
  const capture::ColorConventions& color = captureInfo.conventions->color;
  const bool isLinear = color.encoding == capture::ColorEncoding::Linear;
  if (light.isSeen() && isLinear) {
    out.parts.addRight(say<"Color's encoding">(),
                       say<"Color goes up to %1, beyond what is encoded for a screen: it is linear, as "
                           "stated.">(shortNumber(light.most)));
    return;
  }
  if (light.isSeen() && !color.preExposed) { // exposure that is taken off makes bright what was not
    out.findings.push_back(encodedLight(light));
    return;
  }
  out.parts.leaveOpen(
      {say<"Color's encoding">(),
       isLinear
           ? say<"hardly any light is above 1: color that is encoded for a screen would look like this, "
                 "too">()
           : say<"color that is encoded for a screen and color that is linear differ in contrast alone">(),
       say<"Capture color before it is mapped to a screen, with a light or the sun in the picture.">()});
}

} // namespace taa::doctor
