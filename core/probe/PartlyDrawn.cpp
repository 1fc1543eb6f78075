#include "core/probe/PartlyDrawn.h"

#include "core/probe/TwinInputs.h"
#include "core/render/FrameSource.h"
#include "core/render/SceneRenderer.h"

namespace taa {

namespace {

/// Around what is read, px: what the pixels beside it read, too.
constexpr int kReadAround = 24;

} // namespace

twin::Inputs PartlyDrawn::open(FrameSource& frames, const FrameRequest& request, int frame,
                               const History* previous, const glm::ivec2& pixel) {
  frames_ = &frames;
  request_ = request;
  frame_ = frame;
  if (frames.capture()) {
    draw({});
  } else {
    const glm::ivec2 picturePx(request.width, request.height);
    const glm::ivec2 drawnPx = drawnSize(picturePx, request.inputs.renderScale);
    const glm::ivec2 texel = pixel * drawnPx / picturePx;
    draw(gl::grown({texel.x, texel.y, 1, 1}, kReadAround, drawnPx));
  }
  return twinInputs(inputs_, previous, [this](const gl::Rect& part) { require(part); });
}

void PartlyDrawn::require(const gl::Rect& part) {
  if (gl::contains(drawn_, part)) return;
  draw(gl::rectAround(drawn_, gl::grown(part, kReadAround, {inputs_.width(), inputs_.height()})));
}

// Of a capture all is there, whatever is asked for.
void PartlyDrawn::draw(const gl::Rect& part) {
  const bool isPart = part.width > 0;
  request_.part = isPart ? std::optional(part) : std::nullopt;
  frames_->draw(request_, frame_, inputs_);
  drawn_ = isPart ? part : gl::Rect{0, 0, inputs_.width(), inputs_.height()};
}

} // namespace taa
