// The frame on show, what it is a function of, and the histories that other frames are reached from.
#pragma once

#include "core/base/Progress.h"
#include "core/replay/Checkpoints.h"
#include "core/replay/FrameMaker.h"
#include "core/replay/TraceCursor.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace taa {

/// Every change is made first, then put in place of what there was: when a member throws, everything is as it
/// was before.
class ShotPlayer {
 public:
  explicit ShotPlayer(const glm::ivec2& picturePx);
  ShotPlayer(const ShotPlayer&) = delete;
  ShotPlayer& operator=(const ShotPlayer&) = delete;

  const ShotState& state() const { return state_; }
  bool isOpen() const { return state_.scene != nullptr; }
  const Scene* scene() const { return state_.scene.get(); }
  glm::ivec2 picturePx() const { return {state_.width, state_.height}; }
  const Settings& settings(int lane) const { return state_.lanes.at(static_cast<std::size_t>(lane)); }
  /// A lane as the only one.
  ShotState onlyLane(int lane) const;

  /// Rows that each new frame exposes in its own resolve. Those of the reference are only remembered.
  void watch(const std::vector<IntermediateId>& ids);
  std::vector<IntermediateId> watched() const;

  // The frame on show
  ShownFrame& shown() { return shown_; }
  const ShownFrame& shown() const { return shown_; }
  const ShownLane& lane(int index) const { return shown_.lanes.at(static_cast<std::size_t>(index)); }
  bool isExact() const; ///< in all lanes
  const FrameInputs& inputs(int lane);
  ResolvedFrame resolved(int lane);
  const ExposedRows& exposed(IntermediateId id, int lane);
  FrameMaker& maker() { return maker_; }

  // Going to another; expects that something is open
  void goTo(int frame, const Progress& progress);
  void advance();
  const std::vector<Checkpoints>& checkpoints() const { return checkpoints_; }
  std::size_t budget() const { return budget_; }
  void setBudget(std::size_t bytes);

  // Frames that it is compared with, and frames in the background
  /// Keeps these frames, exactly, and no others, until something changes that they depend on.
  void keepComparisonFrames(const std::vector<int>& frames, const Progress& progress);
  /// The one on show, or one that it is compared with; null when it is neither.
  ShownFrame* find(const std::optional<int>& frame);
  /// Any frame of a lane as the only one, exactly, without anything exposed; what is on show stays.
  ShownFrame makeInBackground(int frame, TraceCursor& cursor, const Progress& progress, int lane = 0);
  /// The same for going back frame by frame: what it is reached from is looked for in `kept` as well, which
  /// what is resolved on the way is added to, up to half of what checkpoints may use.
  ShownFrame makeInBackground(int frame, Checkpoints& kept, const Progress& progress, int lane = 0);
  /// Any frame with other settings side by side, likewise. `kept`: for each of them what it is reached from;
  /// of what is resolved on the way the last stays there.
  ShownFrame makeInBackground(int frame, const std::vector<Settings>& lanes, std::vector<Checkpoints>& kept,
                              const Progress& progress);

  // Changing what it is a function of
  /// Another source, at frame 0.
  void open(ShotState next);
  /// Other lanes; the histories of those that there were already stay.
  void setLanes(const std::vector<Settings>& lanes);
  /// The first ones stay as they are; others come without a history, and go, at once. Expects that something
  /// is open.
  void changeLanes(const std::vector<Settings>& lanes);
  /// The frame on show with other settings, at once: changed lanes on the history they had, or on none. What
  /// does not depend on what changed stays.
  void redraw(ShotState next, const std::vector<bool>& changed, bool keepsHistory);
  void redrawAll(ShotState next, bool keepsHistory);
  /// Another camera track, or other restarts: what lies before frame `from`, the first that changes, stays.
  /// `keepsOld`: until it is exact the frame on show stands on the history it had, else on none.
  void follow(ShotState next, int from, bool keepsOld = false);
  /// Frees textures that are kept for the next frame: they have not the right size any more.
  void freeTextures() { maker_.freeTextures(); }
  /// Compiles what redraw() would need for these settings.
  void prepare(const Settings& settings, int lane);
  /// Draws all with shaders that are compiled again.
  void reloadShaders();

 private:
  ShownFrame replayed(const ShotState& state, std::vector<Checkpoints>& kept, int frame, std::size_t budget,
                      const Progress& progress);
  void show(ShownFrame&& next);
  void keepShown();
  void trimCheckpoints();
  void startAnew(ShotState next, std::vector<Checkpoints> kept, int frame);
  FrameStep stepOfRedraw(const ShotState& next, const std::vector<bool>& changed, bool keepsHistory) const;

  ShotState state_;
  FrameMaker maker_;
  std::vector<IntermediateId> watchedOfReference_; // the others are the maker's
  std::vector<Checkpoints> checkpoints_{1};        // one a lane
  ShownFrame shown_;
  std::vector<ShownFrame> comparisonFrames_; // of the same state
  std::size_t budget_ = kDefaultCheckpointBudget;
};

} // namespace taa
