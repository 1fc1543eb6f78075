// Everything at a pixel, on the frame on show and on others: what the resolve did there and what the CPU twin
// says about it; probes, what they follow and where that is.
#pragma once

#include "core/base/Progress.h"
#include "core/measure/compare/ComparedPixel.h"
#include "core/picture/PictureSource.h"
#include "core/probe/PixelTrace.h"
#include "core/probe/Probe.h"
#include "core/probe/Sensitivity.h"
#include "core/probe/WhatIf.h"
#include "core/replay/TraceCursor.h"
#include "core/taa/twin/Details.h"
#include "core/taa/twin/Twin.h"

#include <optional>
#include <string>
#include <vector>

namespace taa {

class FrameVerifier;
class ReferenceOfShot;
class ShotPlayer;
using twin::PixelRecord;

class Probes {
 public:
  /// Rows of the reference come from `reference`.
  Probes(ShotPlayer& player, ReferenceOfShot& reference);

  /// Everything at one pixel, (0,0) top left. Throws Error outside the picture.
  PixelRecord probe(int x, int y, int lane = 0);
  /// Everything at a square of pixels around (x, y), `radius` 1: 3×3, row-major; clamped at the border.
  std::vector<PixelRecord> probeAround(int x, int y, int radius, int lane = 0);
  /// The other side of a pixel, whatever the row of `other`. Expects that its frame is on show or a
  /// comparison frame, and its lane is there. Along the motion from where the pixel is in `lane`.
  ComparedPixel compared(const glm::ivec2& pixel, const PictureSource& other, int lane = 0);
  // By the CPU twin, which reads what the GPU read
  /// What formulas of a pixel are made of.
  twin::Details details(int x, int y, int lane = 0);
  /// The pixel under other choices. The row of the present ones has the bits of probe() where the driver
  /// rounds as IEEE 754 says.
  std::vector<WhatIfRow> whatIf(int x, int y, int lane = 0);
  /// How much the pixel moves with each thing that it is made of.
  std::vector<Sensitivity> sensitivities(int x, int y, int lane = 0);
  /// How much all pixels move with a number of the settings. Throws Error where none is called `path`,
  /// Cancelled.
  SensitivityMap sensitivityMap(const std::string& path, const Progress& progress = {}, int lane = 0);
  /// Every value that this machine's driver makes of the frame, against what GLSL allows it: added to
  /// `verifier`. Throws Cancelled.
  void verify(FrameVerifier& verifier, const Progress& progress, int lane = 0);
  /// The probe with the surface it follows looked up, in the frame it was set in; others as they are.
  Probe anchored(const Probe& probe);
  /// Where a probe is in the frame on show. Expects an anchored one.
  ProbeSpot spot(const Probe& probe);
  /// What is at probes in any frame, exactly; nothing at those that are not seen there. What is on show
  /// stays. Frame after frame costs one frame each. Of the first lane. Expects anchored probes.
  std::vector<std::optional<TraceSample>> traceFrame(int frame, const std::vector<Probe>& probes,
                                                     TraceCursor& cursor, const Progress& progress = {});

 private:
  std::vector<PixelRecord> recordsOf(const PictureSource& source, const gl::Rect& region);
  void fillBefore(ComparedPixel& compared, const glm::ivec2& pixel, const PictureSource& other, int lane);

  ShotPlayer& player_;
  ReferenceOfShot& reference_;
};

} // namespace taa
