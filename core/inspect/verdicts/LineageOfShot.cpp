#include "core/inspect/verdicts/LineageOfShot.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/gl/PassTimer.h"
#include "core/measure/Profiler.h"
#include "core/probe/TwinInputs.h"
#include "core/replay/ShotPlayer.h"
#include "core/verdict/lineage/TwinStep.h"

#include <optional>
#include <utility>

namespace taa {

namespace {

/// One frame at a time, read where the twin looks.
class LineageFrames : public LineageSource {
 public:
  LineageFrames(ShotPlayer& player, int lane, const Progress& progress)
      : player_(player), state_(player.onlyLane(lane)), lane_(lane), progress_(progress) {}
  ~LineageFrames() override { close(); }

  PixelStep step(int frame, const glm::ivec2& pixel) override {
    if (frame_ != frame) open(frame);
    return pixelStep(inputs_, state_.lanes[0], pixel);
  }

 private:
  void open(int frame) {
    close();
    const ShownLane& shown = player_.lane(lane_);
    if (frame == player_.shown().frame && shown.exact) {
      inputs_ = twinInputs(player_.inputs(lane_), shown.previous.get(), TwinReading::Parts);
    } else {
      made_ = player_.makeInBackground(frame, kept_, progress_, lane_);
      const FrameInputs& drawn = player_.maker().inputs(state_, *made_, 0);
      inputs_ = twinInputs(drawn, made_->lanes[0].previous.get(), TwinReading::Parts);
    }
    frame_ = frame;
  }
  // Textures go back after what reads them has gone.
  void close() {
    frame_.reset();
    inputs_ = {};
    if (made_) player_.maker().recycle(std::move(*made_));
    made_.reset();
  }

  ShotPlayer& player_;
  ShotState state_; // of the lane alone
  int lane_;
  const Progress& progress_;
  Checkpoints kept_;
  std::optional<ShownFrame> made_; // nothing: the frame on show is read, or none
  std::optional<int> frame_;
  twin::Inputs inputs_;
};

} // namespace

LineageOfShot::LineageOfShot(ShotPlayer& player) : player_(player) {}

Lineage LineageOfShot::of(int frame, const glm::ivec2& pixel, int lane, const LineageOptions& options,
                          const Progress& progress) {
  const glm::ivec2 size = player_.picturePx();
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y)
    throw Error(
        say<"pixel (%1, %2) lies outside the picture of %3 × %4 pixels">(pixel.x, pixel.y, size.x, size.y));
  const int count = player_.state().scene->shot.frames;
  if (frame < 0 || frame >= count)
    throw Error(say<"there is no frame %1: the shot has frames 0 to %2">(frame, count - 1));
  const gl::PassGroup group(pass_group::kProbe);
  LineageFrames frames(player_, lane, progress);
  return lineageOf(frames, frame, pixel, options, progress);
}

} // namespace taa
