// What a capture may state otherwise than its frames are written, as far as motion of what rests shows it,
// one convention at a time.
#pragma once

#include "core/capture/format/Conventions.h"
#include "core/capture/format/Manifest.h"
#include "core/doctor/Diagnosis.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace taa::doctor {

/// What is stated by one convention; of one group only one can be wrong.
enum class StatedGroup : std::uint8_t {
  MotionUnit,
  MotionAxes,
  MotionCamera,
  MotionJitter,
  JitterSign,
  JitterFrame,
  DepthKind,
  DepthRange,
  DepthOrder,
  ClipRange,
  ClipAxis,
  Rows,
};

struct Otherwise {
  StatedGroup group;
  std::function<void(capture::Conventions&)> state;
  Finding finding; ///< without what it rests on
  /// Told though nothing else is stated wrongly: what else is examined rests on it, or pictures do not show
  /// it beside something else.
  bool isToldAlone = false;
  /// Told beside jitter in motion alone: what rests has no motion then, in whatever unit and by whatever
  /// depth.
  bool addsCamera = false;
  /// Told beside something else alone: three things that pictures tell one by one.
  bool isOfSeveral = false;
};

/// `lowestDepth`: of what is stored.
std::vector<Otherwise> othersThan(const capture::Manifest& manifest, float lowestDepth);

/// The rows alone, where `conventions` say the same by three axes.
void turnRows(capture::Conventions& conventions);

/// Without what says so.
Finding rowsTurned(capture::RowOrder stated);
/// That they are, with what says so.
Finding matricesFlipped(std::string reason);

} // namespace taa::doctor
