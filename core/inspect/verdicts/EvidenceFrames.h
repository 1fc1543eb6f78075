// What verdicts are made from, of any frames of a lane: the resolve by the twin, truth by the reference and
// by the scene's geometry.
#pragma once

#include "core/base/Progress.h"
#include "core/inspect/verdicts/TwinFrames.h"
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

  PixelStep step(int frame, const glm::ivec2& pixel) override;
  twin::PixelRecord record(int frame, const glm::ivec2& pixel) override;
  const Image& reference(int frame) override;
  const Image& steps(int frame) override;

  /// The way back of the surface that a pixel shows, latest first: `frames` at most, as long as it was seen.
  /// Their records are made when the frame is read for whatever else.
  std::vector<SurfaceMoment> moments(int frame, const glm::ivec2& pixel, int frames);
  /// Fills in the values of moments, frame by frame.
  void fill(std::vector<SurfaceMoment>& moments);
  const Settings& settings() const { return frames_.settings(); }
  const ShotState& state() const { return frames_.state(); }
  int lane() const { return lane_; }

 private:
  References& references_;
  TwinFrames frames_;
  int lane_, samples_;
  const Progress& progress_;
  std::map<int, Image> means_, steps_;
  DrawnSurfaces seen_;
};

} // namespace taa
