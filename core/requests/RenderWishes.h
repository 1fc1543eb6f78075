// What the render thread is asked for.
#pragma once

#include "core/requests/RenderResults.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa {

/// The pinned probes, and of which more is wanted.
struct PinWish {
  std::vector<ProbePin> pins;
  int active = -1;
  bool whatIf = false; ///< also the active pixel under other choices
};

/// Wishes that are of the scene that is open.
struct ShotWishes {
  std::optional<std::string> camera;
  std::optional<std::vector<MotionOverride>> motionModes;
  SceneWishes scene;
  std::vector<RecordingWish> earlierRecordings; ///< begun or ended before `scene.recording`
  std::optional<int> frame;                     ///< to go to, before the steps
  int steps = 0;
};

/// What is asked for and not yet taken up; the last wish of a kind wins, steps add up.
struct Wishes : ShotWishes {
  LatestRequests latest;
  bool reload = false, cancel = false, measureStages = false;
  std::optional<std::string> source;
  ShotWishes unlessOpened; ///< what was asked of the scene before `source`: still is where that is refused
  std::optional<glm::ivec2> size;
  std::optional<Settings> settings, prepared;
  std::optional<bool> looping, playing;
  std::optional<std::vector<ViewRequest>> views;
  std::optional<PinWish> pins;
  std::optional<std::size_t> checkpointBudget;
  std::optional<bool> profiling;
  std::optional<glm::ivec2> thumbnails;
  std::optional<Playback> playback;
  std::optional<int> referenceSamples;
  std::optional<std::vector<Figure>> figures;
  std::optional<std::vector<Settings>> otherLanes;
  std::optional<SequenceRequest> exported;
  std::optional<bool> tracing;
  std::optional<std::pair<int, int>> fillTraces; ///< first and last frame

  bool isEmpty() const;
  /// Opens `next` in place of what was to be opened; what was asked of the present scene waits for that.
  void open(const std::string& next);
  /// The source was refused: what was asked of the present scene counts, where nothing newer was asked.
  void refuseSource();
  /// Whether going to a frame is of no use any more once these are taken up.
  bool endReplay() const;
};

// Questions for RenderWorker's `pending`.
bool isAny(const Wishes& wishes);
bool endsReplay(const Wishes& wishes);

} // namespace taa
