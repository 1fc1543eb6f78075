#include "core/doctor/examination/Examination.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>

namespace taa::doctor {

Examination examinationOf(const DoctorSource& source, int frames, int first) {
  const int count = std::max(0, source.frameCount - first);
  if (count < kLeastDoctorFrames)
    throw Error(
        say<"there are too few frames (%1): the doctor compares each with the one before it; capture at "
            "least 8, better 32">(count));
  Examination out;
  out.read = readerOf(source);
  out.first = first;
  out.frames = std::min(frames, count);
  out.known = source.known;
  out.captureInfo.outputPx = {source.request.width, source.request.height};
  out.captureInfo.objectNames = source.objectNames;
  out.captureInfo.conventions = source.conventions;
  out.captureInfo.frameNames = source.frameNames;
  out.captureInfo.preExposure = source.preExposure;
  out.contradicted = source.contradicted;
  return out;
}

} // namespace taa::doctor
