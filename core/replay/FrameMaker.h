// Makes frames of all lanes and replays them from checkpoints: frame n of a lane is a function (manual,
// architecture).
#pragma once

#include "core/base/Progress.h"
#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/render/FrameSource.h"
#include "core/replay/Checkpoints.h"
#include "core/replay/KeptInputs.h"
#include "core/scene/Pose.h"
#include "core/settings/Settings.h"
#include "core/taa/TaaPass.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa {

/// What a frame is seen through, and the frame that its motion refers to: the same where the shot is cut.
struct FrameCameraPair {
  CameraState now, previous;
};

/// All that frame n is a function of, besides n.
struct ShotState {
  std::string source;
  std::shared_ptr<const Scene> scene;  // also owned by the source of its frames
  std::shared_ptr<FrameSource> frames; // also owned by the copy that a change is tried on
  std::string camera;
  int width = 1280, height = 720;
  std::vector<Settings> lanes{Settings{}};
  std::vector<MotionOverride> motionModes;

  ObjectFilter filter;
  std::vector<CameraTrackHandle> tracks; ///< cameras besides the scene's, by their names
  std::vector<ClassOverride> objectClasses;
  std::vector<int> restarts; ///< frames at which history starts anew besides the scene's cuts, rising

  /// The track that `camera` names; null: a path of the scene's.
  CameraTrackHandle track() const;
  /// The scene's, with restarts among the cuts: where history starts.
  Shot shot() const;
  /// What of it a lane draws.
  FrameRequest request(std::size_t lane) const;
  /// Of a capture without matrices a place to stand. Throws Error.
  FrameCameraPair cameras(std::size_t lane, int frame) const;
};

/// One lane of the frame on show.
struct ShownLane {
  InputsHandle inputs;    ///< one for lanes whose inputs are the same
  HistoryHandle previous; ///< what the frame was resolved on; null: no history
  HistoryHandle current;
  bool exact = true;                ///< false: `previous` is not what these settings would have left
  bool isExposed = false;           ///< whether `watched` holds this frame
  ExposedRows watched;              ///< the whole picture of what is watched
  std::optional<ExposedRows> asked; ///< the whole picture of what was asked for besides
};

/// A frame as it is looked at.
struct ShownFrame {
  int frame = 0;
  std::vector<ShownLane> lanes;
  /// Wall clock up to the end of the GPU's work, for what of the frame was drawn and resolved; 0: nothing.
  double sceneMs = 0.0, resolveMs = 0.0;
};

/// One frame to make: lanes that are not active are left out.
struct FrameStep {
  int frame = 0;
  std::vector<HistoryHandle> previous; ///< one a lane; ignored where the frame starts a history
  std::vector<bool> active;
  bool exposes = true;              ///< fill `watched` in the same run
  std::vector<InputsHandle> inputs; ///< one a lane: this frame's, when there are some already; empty: none
};

class FrameMaker {
 public:
  TaaPass pass;
  std::vector<IntermediateId> watched;
  KeptInputs keptInputs;

  /// A frame to make the next one in, with the textures of one that is not on show any more.
  ShownFrame take();
  /// What a run of the resolve exposes: nothing when no watched row has to be written.
  std::vector<IntermediateId> rowsToExpose(const Settings& settings) const;
  /// Gives back a frame that is not on show any more.
  void recycle(ShownFrame&& frame);
  /// Frees textures that are kept for later: they have not the right size any more.
  void freeTextures();

  /// Resolves the active lanes and draws what inputs that takes. `next` is whole only when all are active.
  void make(const ShotState& state, const FrameStep& step, ShownFrame& next);

  /// Frame `frame` of all lanes, exactly: from the nearest checkpoint of each lane, which new ones are added
  /// to, as many as `budget` bytes hold. Lanes that have kept it are given back as they were, and nothing is
  /// drawn for them. Throws Cancelled when `progress` says so; what was kept stays.
  ShownFrame replay(const ShotState& state, std::vector<Checkpoints>& checkpoints, int frame,
                    std::size_t budget, const Progress& progress);

  /// The rows exposed of the whole picture, `id` among them, made now when there is none.
  const ExposedRows& exposed(const ShotState& state, ShownFrame& shown, IntermediateId id, int lane);
  /// Rows exposed together of the whole picture, all of `ids` among them, made now when there is none.
  const ExposedRows& exposedAll(const ShotState& state, ShownFrame& shown,
                                const std::vector<IntermediateId>& ids, int lane);
  /// The whole picture of several rows, made now.
  ExposedRows expose(const ShotState& state, ShownFrame& shown, const std::vector<IntermediateId>& ids,
                     int lane);
  /// The inputs of a lane, drawn now when they are not.
  const FrameInputs& inputs(const ShotState& state, ShownFrame& shown, std::size_t lane);

 private:
  void arrange(const ShotState& state, const FrameStep& step, ShownFrame& frame);
  void fill(const ShotState& state, ShownFrame& shown, std::size_t lane, ExposedRows& exposedRows);
  HistoryPool pool_;
  std::optional<ShownFrame> spare_;
};

/// Whether frame `frame` may use no history in any lane: the first, at restarts, and after cuts unless a lane
/// has fault.keepsAtCuts.
bool startsHistory(const ShotState& state, int frame);

/// Whether all that the resolve of `frame` was given and left is kept: it need not be made again.
bool isKept(const ShotState& state, const Checkpoints& checkpoints, int frame);
/// What of `budget` bytes the checkpoints of a lane may use: as many frames as those of every other lane,
/// because going to a frame takes as long as in the lane that has kept the least.
std::size_t checkpointShare(const ShotState& state, std::size_t lane, std::size_t budget);
/// How many frames replay() resolves to reach `frame`.
int replayLength(const ShotState& state, const std::vector<Checkpoints>& checkpoints, int frame);
/// The frame nearest to `frame` for which that is one at most.
int nearestCached(const ShotState& state, const std::vector<Checkpoints>& checkpoints, int frame);

} // namespace taa
