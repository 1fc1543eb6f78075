// What verdicts are made from, of any frames of a lane: the resolve by the twin, truth by the reference and
// by the scene's geometry.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/Rect.h"
#include "core/inspect/TwinFrames.h"
#include "core/measure/DrawnSurfaces.h"
#include "core/render/FrameInputs.h"
#include "core/replay/ShotPlayer.h"
#include "core/taa/twin/Texels.h"
#include "core/verdict/pixel/Evidence.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

class References;
struct ReferenceKey;

/// Samples of references: of the parts that are read, and of whole pictures, of which so many cost too much.
struct EvidenceSamples {
  int parts = 0, pictures = 0;
};

/// One frame's inputs at a time, read where the twin looks; references and steps of all that were asked for,
/// drawn where they are read. Captures have all of each at once. Needs the current context for its whole
/// life.
class EvidenceFrames : public EvidenceSource {
 public:
  /// `samples`: of each reference; what is drawn of them is kept in `references` as far as its budget goes.
  EvidenceFrames(ShotPlayer& player, References& references, int lane, EvidenceSamples samples,
                 const Progress& progress);

  PixelStep step(int frame, const glm::ivec2& pixel) override;
  twin::PixelRecord record(int frame, const glm::ivec2& pixel) override;
  const twin::Texels& reference(int frame) override;
  const twin::Texels& steps(int frame) override;
  int object(int frame, const glm::ivec2& pixel) override;
  void expect(int frame, const std::vector<gl::Rect>& parts) override;
  /// All of a reference.
  Image wholeReference(int frame);
  /// All of the steps to a frame that does not start history. Cheapest in rising order.
  Image wholeSteps(int frame);

  /// The way back of the surface that a pixel shows, latest first: `frames` at most, as long as it was seen.
  /// Their records are made when the frame is read for whatever else.
  std::vector<SurfaceMoment> moments(int frame, const glm::ivec2& pixel, int frames);
  /// Fills in the values of moments, frame by frame.
  void fill(std::vector<SurfaceMoment>& moments);
  const Settings& settings() const { return frames_.settings(); }
  const ShotState& state() const { return frames_.state(); }
  int lane() const { return lane_; }
  int samples() const { return samples_.pictures; } ///< of whole references
  /// Standard error of the reference at a pixel, as shown, 0 to 1, of the largest channel: not known where it
  /// came with a capture.
  std::optional<double> referenceError(int frame, const glm::ivec2& pixel);

 private:
  /// A moment's pixel, and its record once its frame was read.
  struct Awaited {
    glm::ivec2 pixel{0};
    std::optional<twin::PixelRecord> record{};
  };

  const twin::Inputs& inputs(int frame, const glm::ivec2& pixel);
  /// What of a frame is read, where that is known, or the pixel.
  std::vector<gl::Rect> partsRead(int frame, const glm::ivec2& pixel) const;
  ReferenceKey keyOf(int frame) const;
  /// Of the four texels around the moment's place, and all between them, what is nearest to `now`.
  glm::dvec3 formerTruth(const SurfaceMoment& moment, const glm::dvec3& now);
  Image referencePart(int frame, const gl::Rect& part);
  Image stepsPart(int frame, const gl::Rect& part);

  References& references_;
  TwinFrames frames_;
  int lane_;
  EvidenceSamples samples_;
  const Progress& progress_;
  bool isWhole_; // of each frame all or nothing
  std::map<int, twin::Texels> means_, steps_;
  std::map<int, Awaited> awaited_;                 // by frame
  std::pair<int, std::vector<gl::Rect>> expected_; // of a frame, the latest
  DrawnSurfaces seen_;                             // of whole frames
  SurfaceParts surfaces_;
  FrameInputs drawn_; // the latest of references and surfaces
};

} // namespace taa
