#include "core/inspect/DriverCheck.h"

#include "core/base/Say.h"
#include "core/gl/ContextLock.h"
#include "core/inspect/Inspector.h"
#include "core/settings/Presets.h"

#include <string_view>
#include <vector>

namespace taa {

void verifyFrames(Inspector& inspector, int first, int last, FrameVerifier& verifier,
                  const Progress& progress) {
  for (int frame = first; frame <= last; ++frame) {
    inspector.shot().seek(frame, progress);
    for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
      inspector.probes().verify(verifier, progress, lane);
  }
}

void verifyPresets(Inspector& inspector, int first, int last, FrameVerifier& verifier,
                   const Progress& progress) {
  const std::vector<Preset>& presets = wholePresets();
  int done = 0;
  const auto count = static_cast<int>(presets.size());
  // Of each preset a part of the whole, so that it does not run back.
  const Progress ofOne = [&](std::string_view, int, int) {
    return !progress || progress(say<"Verifying presets">(), done, count);
  };
  for (const Preset& preset : presets) {
    report(progress, say<"Verifying presets">(), done, count);
    inspector.shot().setSettings(preset.settings);
    verifyFrames(inspector, first, last, verifier, ofOne);
    ++done;
  }
  report(progress, say<"Verifying presets">(), count, count);
}

DriverCheck checkDriver(const Progress& progress) {
  gl::ContextLock lock;
  const Progress passing = lock.passing(progress);
  Inspector inspector;
  inspector.shot().setSize(kDriverCheckWidth, kDriverCheckHeight);
  inspector.shot().open(kDriverCheckSource, passing);
  FrameVerifier verifier;
  verifyPresets(inspector, kDriverCheckFirst, kDriverCheckLast, verifier, passing);
  const gl::Driver& driver = inspector.shot().driver();
  return {driver.renderer + ", " + driver.version, verifier.verification()};
}

} // namespace taa
