// Whether color can be encoded as it is stated: what is encoded for a screen ends at 1, light does not.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/DoctorFrame.h"

namespace taa::doctor {

/// Over all frames, of light as it was decoded.
struct BrightLight {
  double pixels = 0.0, bright = 0.0; ///< bright: clearly above 1
  double most = 0.0;                 ///< of them

  void add(const DoctorFrame& frame);
  /// Enough that no resampling makes it.
  bool isSeen() const;
};

/// Adds what is wrong, right or not decided about the encoding of a capture's color; nothing of a scene.
void tellEncoding(const BrightLight& light, const CaptureInfo& captureInfo, Diagnosis& out);

} // namespace taa::doctor
