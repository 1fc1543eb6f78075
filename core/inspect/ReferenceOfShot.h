// The frame on show supersampled (core/measure/References.h), and the rows that compare with it; of a capture
// also those that compare with what its engine made of the frame.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/measure/Metrics.h"
#include "core/measure/ReferenceRows.h"
#include "core/settings/Lanes.h"
#include "core/taa/Intermediates.h"
#include "core/taa/twin/Twin.h"

#include <array>
#include <cstddef>
#include <vector>

namespace taa::gl {
struct Driver;
}

namespace taa {

class OverTimeOfShot;
class References;
class ShotPlayer;

/// A reference depends on nothing of a lane but how transparent materials are drawn, and is kept: coming back
/// to the frame finds it. Looking at its rows (isOfReference()) without one: Views::picture() is empty,
/// Views::image() throws Error, Probes::probe() gives NaN.
class ReferenceOfShot {
 public:
  /// `references`: those of all frames. Rows over time are those of `overTime`.
  ReferenceOfShot(ShotPlayer& player, References& references, OverTimeOfShot& overTime,
                  const gl::Driver& driver);

  /// Makes what those of `ids` need, each row against a reference of so many samples. As refine(); throws
  /// Error, too, where they need the output of an engine and there is none.
  void makeRows(const std::vector<IntermediateId>& ids, int samples, const Progress& progress = {},
                int lane = 0);
  /// Draws until it has `samples`, 4 to 1024; with more it starts anew. Reports after each one; cancelled: it
  /// keeps what it has. Throws Error.
  void refine(int samples, const Progress& progress = {}, int lane = 0);
  int samples(int lane = 0) const; ///< 0: there is none
  /// Bytes of main memory that references of all frames may use; default kReferenceBudget.
  void setBudget(std::size_t bytes);
  /// Of the output against it. Throws Error where there is none.
  PictureError error(int lane = 0);
  /// The same of the mean of its first so many samples; draws them. Throws Error, Cancelled.
  PictureError errorOfFirst(int samples, int lane = 0, const Progress& progress = {});

  // What other parts make of it
  /// Those of the frame on show; null where it has no reference.
  ReferenceRows* rows(int lane);
  /// Those against the engine's output; null where there is none. Throws Error where it cannot be read.
  ReferenceRows* engineRows(int lane);
  /// Whether a row is made, of a single frame or over time.
  bool has(IntermediateId id, int lane);
  /// Its values; throws Error where it is not made.
  Image image(IntermediateId id, const gl::Rect& region, int lane);
  /// For the Visualizer; null where it is not made.
  const gl::Texture* texture(IntermediateId id, int lane);
  /// Writes the rows that are made into records of `region`.
  void addTo(std::vector<twin::PixelRecord>& records, const gl::Rect& region, int lane);
  /// The scene is another one, or is drawn by other shaders: all references and what was made of them go.
  void forget();

 private:
  ReferenceKey keyOf(int lane) const;
  ReferenceRows& requiredRows(IntermediateId id, int lane);
  ReferenceRows* rowsOf(IntermediateId id, int lane) {
    return isOfEngine(id) ? engineRows(lane) : rows(lane);
  }

  ShotPlayer& player_;
  References& references_;
  OverTimeOfShot& overTime_;
  const gl::Driver& driver_;
  std::array<ReferenceRows, kMaxLanes> rows_, engineRows_; // one a lane
};

} // namespace taa
