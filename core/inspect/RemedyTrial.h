// What other settings would have made of the last frames: a pixel's surface in them, and whole pictures.
#pragma once

#include "core/base/Progress.h"
#include "core/inspect/EvidenceFrames.h"
#include "core/inspect/PartlyResolved.h"
#include "core/replay/Checkpoints.h"
#include "core/replay/ShotPlayer.h"
#include "core/verdict/pixel/Remedies.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <map>
#include <memory>
#include <vector>

namespace taa {

/// Frames that are measured, the last of those that are tried.
inline constexpr int kMeasuredFrames = 4;

/// What settings make of a shot's frames from where history starts.
struct WholeMeasure {
  RemedyMeasure pixel, picture;
};

/// Frames up to `last`. All of it throws Error, Cancelled.
class RemedyTrial {
 public:
  /// `evidence`, `progress`: stay as long as it does.
  RemedyTrial(ShotPlayer& player, EvidenceFrames& evidence, int last, int first, const Progress& progress);

  /// Looks at the surface that a pixel of the last frame shows: the other members expect it.
  void follow(const glm::ivec2& pixel);
  /// Of that surface, from frame `first` on, on the history that the present settings left before it.
  /// Resolves no more than it takes.
  RemedyMeasure ofPixel(const Settings& settings);
  /// Of that surface and of whole pictures, each resolved from where its history starts: what the program
  /// shows with these settings. `lanes`: the present settings first. `kept`: what is known of them, and of
  /// how far they were resolved when it is Cancelled.
  std::vector<WholeMeasure> ofWhole(const std::vector<Settings>& lanes, std::vector<Checkpoints>& kept);

 private:
  HistoryHandle historyBefore();
  /// The frames with the inputs that `settings` draw.
  PartlyResolved& partsFor(const Settings& settings);
  RemedyMeasure ofColors(const std::map<int, glm::dvec3>& colors);

  ShotPlayer& player_;
  EvidenceFrames& evidence_;
  int last_, first_;
  const Progress& progress_;
  HistoryHandle before_;
  std::vector<SurfaceMoment> moments_;     // latest first
  std::map<int, glm::ivec2> wanted_;       // pixels of the moments by frame
  std::unique_ptr<PartlyResolved> parts_;  // of the moments, with the present inputs
  std::unique_ptr<PartlyResolved> others_; // with those that were drawn otherwise last
  Settings settingsOfOthers_;
};

} // namespace taa
