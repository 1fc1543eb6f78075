#include "core/inspect/LineageOfShot.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/gl/PassTimer.h"
#include "core/inspect/TwinFrames.h"
#include "core/measure/Profiler.h"
#include "core/replay/ShotPlayer.h"
#include "core/verdict/lineage/TwinStep.h"

namespace taa {

namespace {

class LineageFrames : public LineageSource {
 public:
  LineageFrames(ShotPlayer& player, int lane, const Progress& progress) : frames_(player, lane, progress) {}
  PixelStep step(int frame, const glm::ivec2& pixel) override {
    constexpr int kNearPx = 16; // what is followed besides lies that near, as a rule
    const ShotState& state = frames_.state();
    const gl::Rect near = gl::grown({pixel.x, pixel.y, 1, 1}, kNearPx, {state.width, state.height});
    return pixelStep(frames_.at(frame, {near}), frames_.settings(), pixel);
  }

 private:
  TwinFrames frames_;
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
