#include "core/probe/PartlyDrawn.h"

#include "core/probe/NearParts.h"
#include "core/probe/TwinInputs.h"
#include "core/render/FrameSource.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <utility>

namespace taa {

namespace {

/// Texels around those of a pixel that it reads, with most settings.
constexpr int kReadAround = 4;

/// The texels that a part of a picture lies on.
gl::Rect texelsOf(const gl::Rect& part, const glm::ivec2& picturePx, const glm::ivec2& drawnPx) {
  const glm::ivec2 low = glm::ivec2(part.x, part.y) * drawnPx / picturePx;
  const glm::ivec2 high = glm::ivec2(part.x + part.width - 1, part.y + part.height - 1) * drawnPx / picturePx;
  return {low.x, low.y, high.x - low.x + 1, high.y - low.y + 1};
}

/// `part` of a picture whose upper left corner is that of `held`.
Image cutOut(const Image& picture, const gl::Rect& held, const gl::Rect& part) {
  Image cut(part.width, part.height, picture.channels);
  for (int row = 0; row < part.height; ++row)
    std::copy_n(picture.at(part.x - held.x, part.y - held.y + row), picture.channels * part.width,
                cut.at(0, row));
  return cut;
}

} // namespace

twin::Inputs PartlyDrawn::open(FrameSource& frames, const FrameRequest& request, int frame,
                               const History* previous, const std::vector<gl::Rect>& parts) {
  frames_ = &frames;
  request_ = request;
  frame_ = frame;
  parts_.clear();
  if (frames.capture()) { // all is there, whatever is asked for
    request_.part.reset();
    frames.draw(request_, frame, inputs_);
    return twinInputs(inputs_, previous, TwinReading::Parts);
  }
  const glm::ivec2 picturePx(request.width, request.height);
  const glm::ivec2 drawnPx = drawnSize(picturePx, request.inputs.renderScale);
  std::vector<gl::Rect> places;
  for (const gl::Rect& part : parts)
    places.push_back(gl::grown(texelsOf(part, picturePx, drawnPx), kReadAround, drawnPx));
  for (const gl::Rect& place : nearParts(places)) draw(place);
  const auto readDrawn = [this](const gl::Texture& texture, const gl::Rect& texels) {
    return read(texture, texels);
  };
  return twinInputs(inputs_, previous, readDrawn);
}

Image PartlyDrawn::read(const gl::Texture& texture, const gl::Rect& part) {
  const auto holds = [&](const DrawnPart& drawn) { return gl::contains(drawn.place, part); };
  const auto known = std::ranges::find_if(parts_, holds);
  const glm::ivec2 drawnPx(inputs_.width(), inputs_.height());
  const DrawnPart& drawn = known == parts_.end() ? draw(gl::grown(part, kReadAround, drawnPx)) : *known;
  return cutOut(drawn.images.at(&texture), drawn.place, part);
}

// The next part that is drawn takes the place of this one in the textures.
const PartlyDrawn::DrawnPart& PartlyDrawn::draw(const gl::Rect& place) {
  DrawnPart drawn{place};
  request_.part = place;
  frames_->draw(request_, frame_, inputs_);
  for (const gl::Texture* texture :
       {&inputs_.color, &inputs_.depth, &inputs_.motion, &inputs_.normal, &inputs_.objectId,
        &inputs_.previousDepth, &inputs_.mask, &inputs_.overlay, &inputs_.fog, &inputs_.forwardCount})
    if (*texture) drawn.images.emplace(texture, texture->download(place));
  return parts_.emplace_back(std::move(drawn));
}

} // namespace taa
