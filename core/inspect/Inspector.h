// The façade: open a source, choose settings, go to a frame, look. Everything the app and taa-batch do goes
// through it.
#pragma once

#include "core/inspect/InspectedShot.h"
#include "core/measure/Metrics.h"
#include "core/measure/Profiler.h"
#include "core/measure/StageMeter.h"
#include "core/picture/Look.h"
#include "core/picture/Visualizer.h"
#include "core/probe/PixelTrace.h"
#include "core/probe/ProbePin.h"
#include "core/probe/WhatIf.h"
#include "core/taa/rows/Intermediates.h"
#include "core/taa/twin/Details.h"
#include "core/taa/twin/Twin.h"

#include <optional>
#include <vector>

namespace taa {

struct FigureCursor;
using twin::PixelRecord;

/// A shot that can be looked into. Lives on the thread that made it, one at a time there, with its own GL
/// context.
class Inspector : public InspectedShot {
 public:
  // Looking: changes nothing that is looked at
  /// Intermediates that each new frame exposes in its own resolve. Others are exposed on demand by running it
  /// again.
  void watch(const std::vector<IntermediateId>& ids);
  /// Values of the current frame, with the row's channels; `region` empty: the whole picture.
  Image image(IntermediateId id, int lane = 0, std::optional<gl::Rect> region = {});
  /// Several at once, in one run of the resolve.
  std::vector<Image> images(const std::vector<IntermediateId>& ids, int lane = 0);
  /// Everything at one pixel, (0,0) top left. Throws Error outside the picture.
  PixelRecord probe(int x, int y, int lane = 0);
  /// Everything at a square of pixels around (x, y), `radius` 1: 3×3, row-major; clamped at the border.
  std::vector<PixelRecord> probeAround(int x, int y, int radius, int lane = 0);
  // By the CPU twin, which reads what the GPU read
  /// What formulas of a pixel are made of.
  twin::Details details(int x, int y, int lane = 0);
  /// The pixel under other choices. The row of the present ones has the bits of probe() where the driver
  /// rounds as IEEE 754 says.
  std::vector<WhatIfRow> whatIf(int x, int y, int lane = 0);
  /// The pin with the surface it follows looked up, in the frame it was set in; others as they are.
  ProbePin anchored(const ProbePin& pin);
  /// Where a pin is in the frame on show. Expects an anchored one.
  PinSpot spot(const ProbePin& pin);
  /// What is at pins in any frame, exactly; nothing at those that are not seen there. What is on show stays.
  /// Frame after frame costs one frame each. Of the first lane. Expects anchored pins.
  std::vector<std::optional<TraceSample>> traceFrame(int frame, const std::vector<ProbePin>& pins,
                                                     TraceCursor& cursor, const Progress& progress = {});
  /// The finished picture of a view.
  Picture picture(IntermediateId id, const ViewStyle& style, const ViewTransform& transform, int width,
                  int height, int lane = 0);
  // Beside the frame on show, others can be kept at hand
  /// These frames of all lanes from now on, exactly, and no others, until anything but the frame changes.
  /// Cancelled: those that are done are kept.
  void keepAside(const std::vector<int>& frames, const Progress& progress = {});
  /// Whether its frame is the one on show or kept aside, and its lane is there.
  bool isAtHand(const Look& look) const;
  using InspectedShot::isExact;
  bool isExact(const Look& look) const;
  /// The picture of a view, or of what it is more than `minus` (of as many channels). Expects isAtHand().
  Picture picture(const Look& look, const std::optional<Look>& minus, const ViewStyle& style,
                  const ViewTransform& transform, int width, int height);
  /// Values of a part of the picture, or of the difference.
  Image image(const Look& look, const std::optional<Look>& minus, const gl::Rect& region);

  /// A small picture of it in the style it opens with; costs only the pixels that are in it.
  Picture thumbnail(IntermediateId id, const glm::ivec2& texels, int lane = 0);
  /// Drawn now when they are not.
  const FrameInputs& inputs(int lane = 0) const;

  // Reference: the frame on show supersampled (core/measure/References.h). It depends on nothing of a lane
  // but how transparent materials are drawn, and is kept: coming back to the frame finds it. Looking at its
  // rows (isOfReference()) without one: picture() is empty, image() throws Error, probe() gives NaN.
  /// Makes what those of `ids` need, each row against a reference of so many samples. As refineReference().
  void makeRows(const std::vector<IntermediateId>& ids, int samples, const Progress& progress = {},
                int lane = 0);
  /// Draws until it has `samples`, 4 to 1024; with more it starts anew. Reports after each one; cancelled: it
  /// keeps what it has. Throws Error.
  void refineReference(int samples, const Progress& progress = {}, int lane = 0);
  int referenceSamples(int lane = 0) const; ///< 0: there is none
  /// Bytes of main memory that references of all frames may use; default kReferenceBudget.
  void setReferenceBudget(std::size_t bytes);
  /// Of the output against it. Throws Error where there is none.
  PictureError referenceError(int lane = 0);
  // Flicker of what is shown up to the frame on show (core/measure/Flicker.h), whose rows are isOverTime().
  // Always of exact frames. It is kept, and what the next frame needs of it.
  /// Against references of so many samples of all its frames, 0: without, so that only the deviation is
  /// known. Cancelled: goes on from there when it is asked again. Throws Error.
  void refineFlicker(int samples, const Progress& progress = {}, int lane = 0);
  std::optional<int> flickerSamples(int lane = 0) const; ///< nothing: there is none
  /// kLeastFlickerFrames to kMostFlickerFrames; kFlickerFrames unless told otherwise.
  void setFlickerFrames(int frames);
  int flickerFrames() const;
  /// Figures of the frame on show; those against a reference and over time stay empty where there is none.
  FrameFigures figures(const std::vector<Figure>& wanted, int lane = 0);
  /// The same of any frame, exactly, of the first lane, against a reference of so many samples; what is on
  /// show stays. Frame after frame costs one frame each, and its reference. Cancelled: goes on from there
  /// when it is asked again.
  FrameFigures figuresBeside(int frame, const std::vector<Figure>& wanted, int samples, FigureCursor& cursor,
                             const Progress& progress = {});

  // Measuring: nothing of it is done before it is asked for
  /// Times every pass from now on, or no longer.
  void setProfiling(bool on);
  /// The frame made last, with what was looked at of it since; nothing when none was made since the last
  /// call.
  std::optional<FrameProfile> takeProfile();
  /// What each stage costs on the frame on show. Cancelled: keeps what it has and goes on from there when it
  /// is asked again for the same frame.
  StageCosts measureStages(const Progress& progress = {}, int lane = 0);
};

} // namespace taa
