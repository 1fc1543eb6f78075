// What a TAA makes of the frames that the doctor reads: an engine's own, or this program's.
#pragma once

#include "core/base/Image.h"
#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/render/FrameSource.h"
#include "core/settings/Settings.h"
#include "core/taa/History.h"
#include "core/taa/TaaPass.h"

namespace taa::doctor {

class EngineOutput {
 public:
  EngineOutput() = default;
  EngineOutput(const EngineOutput&) = delete;
  EngineOutput& operator=(const EngineOutput&) = delete;
  virtual ~EngineOutput() = default;
  /// Of a frame of the source that `drawn` holds: three channels or more, scene-linear; empty: there is
  /// none. A function of the source, the request and the frame. Throws Error.
  virtual Image read(FrameSource& source, const FrameRequest& request, const FrameInputs& drawn,
                     int frame) = 0;
};

/// What came with the frames of a capture.
class CapturedOutput final : public EngineOutput {
 public:
  Image read(FrameSource& source, const FrameRequest& request, const FrameInputs& drawn, int frame) override;
};

/// What this program's resolve makes of the frames. Needs the current context for its whole life.
class OwnOutput final : public EngineOutput {
 public:
  explicit OwnOutput(const Settings& settings);
  Image read(FrameSource& source, const FrameRequest& request, const FrameInputs& drawn, int frame) override;

 private:
  void resolve(const FrameRequest& request, const FrameInputs& inputs, int frame);

  Settings settings_;
  TaaPass pass_;
  History last_, next_;
  int lastFrame_ = -1;
  FrameInputs own_; ///< with the masks that the settings ask for
};

} // namespace taa::doctor
