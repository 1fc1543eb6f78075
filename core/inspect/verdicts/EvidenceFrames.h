// What verdicts are made from, of any frames of a lane: the resolve by the twin, truth by the reference and
// by the scene's geometry.
#pragma once

#include "core/base/Progress.h"
#include "core/measure/DrawnSurfaces.h"
#include "core/replay/ShotPlayer.h"
#include "core/verdict/pixel/Evidence.h"

#include <map>
#include <optional>
#include <vector>

namespace taa {

class References;

/// One frame's inputs at a time, read where the twin looks; references and steps of all that were asked for.
/// Needs the current context for its whole life.
class EvidenceFrames : public EvidenceSource {
 public:
  /// `samples`: of each reference; those that are drawn are kept in `references` as far as its budget goes.
  EvidenceFrames(ShotPlayer& player, References& references, int lane, int samples, const Progress& progress);
  ~EvidenceFrames() override;

  PixelStep step(int frame, const glm::ivec2& pixel) override;
  twin::PixelRecord record(int frame, const glm::ivec2& pixel) override;
  const Image& reference(int frame) override;
  const Image& steps(int frame) override;

  /// The way back of the surface that a pixel shows, latest first: `frames` at most, as long as it was seen.
  /// Their records are made when the frame is read for whatever else.
  std::vector<SurfaceMoment> moments(int frame, const glm::ivec2& pixel, int frames);
  /// Fills in the values of moments, frame by frame.
  void fill(std::vector<SurfaceMoment>& moments);
  const Settings& settings() const { return state_.lanes[0]; }
  const ShotState& state() const { return state_; }
  int lane() const { return lane_; }

 private:
  void open(int frame);
  void close();

  ShotPlayer& player_;
  References& references_;
  ShotState state_; // of the lane alone
  int lane_, samples_;
  const Progress& progress_;
  Checkpoints kept_;
  std::optional<ShownFrame> made_; // nothing: the frame on show is read, or none
  std::optional<int> frame_;
  twin::Inputs inputs_;
  std::map<int, Image> means_, steps_;
  DrawnSurfaces seen_;
};

} // namespace taa
