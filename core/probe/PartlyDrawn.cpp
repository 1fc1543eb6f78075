#include "core/probe/PartlyDrawn.h"

#include "core/probe/TwinInputs.h"
#include "core/render/FrameSource.h"
#include "core/render/SceneRenderer.h"

#include <algorithm>

namespace taa {

namespace {

/// Around what is read, px: what the pixels beside it read, too.
constexpr int kReadAround = 24;

bool contains(const gl::Rect& whole, const gl::Rect& part) {
  return part.x >= whole.x && part.y >= whole.y && part.x + part.width <= whole.x + whole.width &&
         part.y + part.height <= whole.y + whole.height;
}

gl::Rect grown(const gl::Rect& part, int border, const glm::ivec2& sizePx) {
  const int left = std::max(part.x - border, 0), top = std::max(part.y - border, 0);
  return {left, top, std::min(part.x + part.width + border, sizePx.x) - left,
          std::min(part.y + part.height + border, sizePx.y) - top};
}

gl::Rect regionAround(const gl::Rect& a, const gl::Rect& b) {
  const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
  return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
          std::max(a.y + a.height, b.y + b.height) - top};
}

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
    draw(grown({texel.x, texel.y, 1, 1}, kReadAround, drawnPx));
  }
  return twinInputs(inputs_, previous, [this](const gl::Rect& part) { require(part); });
}

void PartlyDrawn::require(const gl::Rect& part) {
  if (contains(drawn_, part)) return;
  draw(regionAround(drawn_, grown(part, kReadAround, {inputs_.width(), inputs_.height()})));
}

// Of a capture all is there, whatever is asked for.
void PartlyDrawn::draw(const gl::Rect& part) {
  const bool isPart = part.width > 0;
  request_.part = isPart ? std::optional(part) : std::nullopt;
  frames_->draw(request_, frame_, inputs_);
  drawn_ = isPart ? part : gl::Rect{0, 0, inputs_.width(), inputs_.height()};
}

} // namespace taa
