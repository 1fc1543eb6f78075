// Frames as they would be with what was found made right: what the doctor says of them, pictures beside those
// of the frames as they are, and how far both are from a reference.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/doctor/Correction.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/source/DoctorSource.h"
#include "core/settings/Settings.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::doctor {

/// A frame in which something was found, resolved by the same settings but for what was made right.
struct CorrectedPicture {
  std::size_t finding = 0; ///< by index
  int frame = 0;
  Image given, corrected; ///< as a screen is sent them: 0 to 1, sRGB, three channels
};

struct CorrectedLook {
  Corrected corrected;
  Diagnosis left; ///< of the corrected frames
  std::vector<CorrectedPicture> pictures;
  int lastFrame = 0;
  std::optional<double> givenPsnr, correctedPsnr; ///< dB, of the last frame; nothing: there is no reference
};

/// A finding has a picture of its own, but for those after so many.
inline constexpr std::size_t kMaxCorrectedPictures = 6;
inline constexpr int kCorrectedSamples = 16; ///< of a reference that is drawn

/// Of the frames of a diagnosis, from `first` on. `source` is left as it was: drawn with `settings`.
/// `healthy`: see corrected(). Needs the current context. Throws Error, Cancelled.
CorrectedLook lookAtCorrected(DoctorSource& source, const Diagnosis& diagnosis, const Settings& settings,
                              const Settings& healthy, const Progress& progress = {}, int first = 0);

} // namespace taa::doctor
