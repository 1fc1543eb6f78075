// A source of frames with faults injected: what stands between a renderer or a capture and all that uses
// their frames (manual, faults).
#pragma once

#include "core/render/FrameSource.h"
#include "core/render/faults/FaultPass.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <functional>
#include <memory>
#include <optional>

namespace taa {

/// Whether inputs of frames differ from those without faults, somewhere and in some frame.
bool changesInputs(const FaultSettings& faults);

/// Jitter with faults: displacements of image content, px, x right, y down.
struct FaultyJitter {
  glm::vec2 applied{0.0f};  ///< by what the picture is displaced
  glm::vec2 reported{0.0f}; ///< what the resolve believes
};

/// Jitter of a frame of the sequence without faults, px; frames from 0 on.
using JitterOfFrame = std::function<glm::vec2(int frame)>;

/// Whether inputs of the frame are faulty: it lies in the frames that the faults say.
bool isFaultyFrame(const FaultSettings& faults, int frame);

/// `isDrawn`: the picture is drawn for the request. A capture's is drawn already: of it only what is reported
/// can be wrong.
FaultyJitter faultyJitter(const FaultSettings& faults, const JitterOfFrame& given, int frame, bool isDrawn);

/// Frame n stays a pure function: what is taken from earlier frames is drawn anew. Without faults in a
/// request all is what the source gives.
class FaultySource : public FrameSource {
 public:
  explicit FaultySource(std::unique_ptr<FrameSource> source);

  void draw(const FrameRequest& request, int frame, FrameInputs& out) override;
  FrameInfo info(const FrameRequest& request, int frame) const override;
  CameraState camera(const FrameRequest& request, int frame) const override;
  void warmUp(const FrameRequest& request, const Progress& progress) override;
  const DrawCounts& counts() const override;
  void reloadShaders() override;
  std::shared_ptr<const CaptureFacts> capture() const override;
  std::shared_ptr<const Image> reference(int frame) override;
  std::shared_ptr<const Image> engineOutput(int frame) override;

 private:
  bool isDrawn() const { return !source_->capture(); }
  FaultyJitter jitter(const FrameRequest& request, int frame) const;
  FrameRequest plain(const FrameRequest& request, int frame, float jitterScale = 1.0f) const;
  void drawFaulty(const FrameRequest& request, int frame, FrameInputs& out);
  void followOlder(const FrameRequest& request, int frame, FrameInputs& out);
  const gl::Texture& motionOf(const FrameRequest& request, int frame, FrameInputs& out);
  void report(const FrameRequest& request, int frame, FrameInputs& out) const;

  std::unique_ptr<FrameSource> source_;
  std::optional<FaultPass> pass_; ///< made when planes are first faulty
  FrameInputs other_;             ///< of an earlier frame, or with another jitter
};

} // namespace taa
