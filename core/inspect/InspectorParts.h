// What the Inspector is made of, for its own files.
#pragma once

#include "core/base/EmbeddedFiles.h"
#include "core/inspect/Inspector.h"
#include "core/measure/FlickerRows.h"
#include "core/measure/ReferenceRows.h"
#include "core/measure/References.h"
#include "core/picture/Thumbnails.h"
#include "core/replay/BackgroundCompiler.h"
#include "core/replay/FrameMaker.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace taa {

/// The shaders as they were when they were read last: files that are being edited change nothing until they
/// compile.
class UsedShaders {
 public:
  UsedShaders() { useShaders(readShaders()); }
  ~UsedShaders() { useShaders(nullptr); }
  UsedShaders(const UsedShaders&) = delete;
  UsedShaders& operator=(const UsedShaders&) = delete;
};

struct InspectedShot::Parts {
  UsedShaders shaders; // first: everything else is compiled from them
  gl::Context context;
  Subject subject;
  FrameMaker maker;
  std::vector<IntermediateId> watchedOfReference; // the others are the maker's
  Visualizer visualizer;
  std::vector<Checkpoints> checkpoints{1}; // one a lane
  ShownFrame shown;
  std::vector<ShownFrame> aside; // frames to compare with, of the same subject
  std::size_t budget = kDefaultCheckpointBudget;
  Thumbnails thumbnails;
  std::optional<gl::PassTimer> timer; // while profiling
  int profiled = 0;                   // frames that the timer had seen at the last profile
  StageMeter stageMeter{gl::timingMethodFor(context.driver())};
  References references;
  std::array<ReferenceRows, kMostLanes> comparisons; // with the reference, one a lane
  std::array<FlickerRows, kMostLanes> flickers;      // one a lane
  int flickerFrames = kFlickerFrames;
  BackgroundCompiler compiler;

  bool isOpen() const { return subject.scene != nullptr; }
  bool hasFog() const { return isOpen() && !subject.scene->fog.empty(); }
  const ShownLane& lane(int index) const { return shown.lanes.at(static_cast<std::size_t>(index)); }
  const Settings& settings(int index) const { return subject.lanes.at(static_cast<std::size_t>(index)); }
  const FrameInputs& inputs(int index) {
    return maker.inputs(subject, shown, static_cast<std::size_t>(index));
  }
  ResolvedFrame resolved(int index) {
    return {inputs(index), lane(index).previous, lane(index).current, settings(index)};
  }
  bool isExact() const;
  std::vector<IntermediateId> watched() const;

  void show(ShownFrame&& next);
  void keepShown();
  /// Gives up what the budget cannot hold, in each lane.
  void trimCheckpoints();
  void goTo(int frame, const Progress& progress);
  /// The frame that is looked at; null when it is not at hand.
  ShownFrame* find(const std::optional<int>& frame);
  /// Another source or other lanes: all is made first, then put in place of what there was.
  void startAnew(Subject next, std::vector<Checkpoints> kept, int frame);
  /// The frame on show with other settings, at once: changed lanes on the history they had, or on none. What
  /// does not depend on what changed stays.
  void redraw(Subject next, const std::vector<bool>& changed, bool keepsHistory);
  void prepare(const Settings& settings, std::size_t lane);
  void reloadShaders();
  /// Another camera track, or other restarts: what lies before frame `from`, the first that changes, stays.
  /// `keepsOld`: until it is exact the frame on show stands on the history it had, else on none.
  void follow(Subject next, int from, bool keepsOld = false);

  /// What a view draws: rows of the frame, of another one, of the reference.
  DrawnLayers layersOf(const Look& look, const std::optional<Look>& minus, const ViewStyle& style);

  // InspectorTracing.cpp
  /// A lane as the only one.
  Subject onlyLane(int lane) const;
  /// Any frame of a lane as the only one, exactly, without anything exposed; what is on show stays.
  ShownFrame makeBeside(int frame, TraceCursor& cursor, const Progress& progress, int lane = 0);

  // InspectorFlicker.cpp
  struct FlickerNeed {
    int lane = 0, last = 0; ///< the frame whose flicker it is
    int samples = 0;        ///< of the reference, 0: none
  };
  FlickerSubject flickerSubject(int lane) const;
  /// The first frame that flicker of `last` is taken over.
  int firstOfFlicker(int last) const;
  /// What a lane shows in any frame, as a screen is sent it.
  Image shownBeside(int frame, TraceCursor& cursor, const Progress& progress, int lane);
  /// Makes what is missing of a window but what the last frame shows.
  void fillFlicker(FlickerWindow& window, References& drawn, const FlickerNeed& need,
                   const Progress& progress);
  /// Those of the frame on show; null where the row is not made.
  FlickerRows* flickerRows(IntermediateId id, int lane);

  // InspectorReference.cpp
  /// The reference of any frame of the first lane of `of`, found among those at hand or drawn into `drawn`.
  const ReferencePicture& referenceOf(const Subject& of, int frame, int samples, References& drawn,
                                      const Progress& progress);
  ReferenceSubject referenceSubject(int lane) const;
  /// Throws Error where there is not the memory to draw one, and `more` bytes.
  void checkReference(int lane, std::size_t more = 0) const;
  /// Those of the frame on show; null where it has no reference.
  ReferenceRows* referenceRows(int lane);
  ReferenceRows& requiredReferenceRows(int lane); ///< throws Error instead
  /// A row of the reference, single frame or over time; throws Error where it is not made. The texture: null.
  Image referenceImage(IntermediateId id, const gl::Rect& region, int lane);
  const gl::Texture* referenceTexture(IntermediateId id, int lane);
  Picture referencePicture(IntermediateId id, const ViewStyle& style, const ViewTransform& transform,
                           const glm::ivec2& size, int lane);
  /// Writes the rows of the reference into records of `region`, where there is one.
  void addReference(std::vector<PixelRecord>& around, const gl::Rect& region, int lane);
  void forgetReferences();

 private:
  FrameStep stepOfRedraw(const Subject& next, const std::vector<bool>& changed, bool keepsHistory) const;
};

} // namespace taa
