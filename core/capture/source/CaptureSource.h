// A capture as the source of a shot's frames: decoded planes become the textures that a renderer would draw.
#pragma once

#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/format/Manifest.h"
#include "core/render/FrameSource.h"

#include <functional>
#include <memory>

namespace taa {
struct CaptureFacts;
}

namespace taa::capture {

class Capture;

/// Frame `index`, decoded. Throws Error.
using FrameReader = std::function<std::shared_ptr<const DecodedFrame>(int index)>;

/// Of a request, precision, motion from depth and restarts count; all else is the capture's own.
class CaptureSource : public FrameSource {
 public:
  /// Throws Error where the capture's size is none that a picture can have.
  explicit CaptureSource(std::shared_ptr<const Capture> capture); // also owned by who asks for its manifest
  /// `frames` gives what `manifest` says.
  CaptureSource(Manifest manifest, FrameReader frames);
  ~CaptureSource() override;

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
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace taa::capture
