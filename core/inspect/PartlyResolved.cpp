#include "core/inspect/PartlyResolved.h"

#include "core/base/Say.h"
#include "core/gl/Context.h"
#include "core/render/FrameRequest.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

namespace taa {

namespace {

/// Texels around its own that a pixel may take the motion of: × reaches two, and Godot's corner one more.
constexpr int kDilatedBy = 3;
/// Pixels around its place that filters and tests of history read.
constexpr int kReadBy = 3;
/// Texels around it that a pixel reads of the inputs.
constexpr int kInputsAround = 8;

glm::ivec2 pictureSize(const FrameInputs& inputs) {
  return {inputs.outputWidth(), inputs.outputHeight()};
}

/// The texels that were drawn for a part of the picture, and `around` them.
gl::Rect drawnFor(const gl::Rect& part, int around, const glm::ivec2& picturePx, const glm::ivec2& drawnPx) {
  const glm::ivec2 low = glm::ivec2(part.x, part.y) * drawnPx / picturePx;
  const glm::ivec2 high = glm::ivec2(part.x + part.width - 1, part.y + part.height - 1) * drawnPx / picturePx;
  return gl::grown({low.x, low.y, high.x - low.x + 1, high.y - low.y + 1}, around, drawnPx);
}

/// As printed, the search for the closest begins in the corner of the picture.
bool looksAround(const Settings& settings) {
  return settings.dilate.method != DilateMethod::Closest3x3AsPrinted;
}

gl::Rect rectOf(const glm::ivec2& pixel) {
  return {pixel.x, pixel.y, 1, 1};
}

} // namespace

gl::Rect historyReach(const FrameInputs& inputs, const gl::Rect& part) {
  const glm::ivec2 picturePx = pictureSize(inputs), drawnPx(inputs.width(), inputs.height());
  const glm::vec2 scale = glm::vec2(picturePx) / glm::vec2(drawnPx);
  const gl::Rect around = drawnFor(part, kDilatedBy + 1, picturePx, drawnPx);
  const Image motions = inputs.motion.download(around);
  glm::ivec2 low(part.x, part.y), high(part.x + part.width - 1, part.y + part.height - 1);
  for (int y = 0; y < motions.height; ++y)
    for (int x = 0; x < motions.width; ++x) {
      const glm::vec2 motion(motions.at(x, y)[0], motions.at(x, y)[1]);
      if (!std::isfinite(motion.x) || !std::isfinite(motion.y)) continue; // read in place
      const glm::vec2 place = (glm::vec2(around.x + x, around.y + y) + 0.5f - motion) * scale;
      const glm::ivec2 texel(glm::clamp(glm::floor(place), glm::vec2(0.0f), glm::vec2(picturePx - 1)));
      low = glm::min(low, texel);
      high = glm::max(high, texel);
    }
  const int reach =
      kReadBy + static_cast<int>(std::ceil(static_cast<float>(kDilatedBy + 1) * std::max(scale.x, scale.y)));
  return gl::grown({low.x, low.y, high.x - low.x + 1, high.y - low.y + 1}, reach, picturePx);
}

PartlyResolved::PartlyResolved(const ShotState& state, int first, const std::map<int, glm::ivec2>& wanted,
                               const Progress& progress)
    : wanted_(wanted) {
  assert(!wanted.empty() && wanted.rbegin()->first >= first);
  const glm::ivec2 picturePx(state.width, state.height);
  FrameRequest request = state.request(0);
  const glm::ivec2 drawnPx = drawnSize(picturePx, request.inputs.renderScale);
  const bool isWhole = !looksAround(state.lanes[0]);
  const int last = wanted.rbegin()->first;
  std::optional<gl::Rect> read; // by the frame after
  for (int number = last; number >= first; --number) {
    report(progress, say<"Trying remedies">(), last - number, last - first + 1);
    Frame frame;
    frame.number = number;
    if (read) frame.part = *read;
    if (const auto at = wanted.find(number); at != wanted.end())
      frame.part = read ? gl::rectAround(*read, rectOf(at->second)) : rectOf(at->second);
    if (isWhole) frame.part = {0, 0, picturePx.x, picturePx.y};
    request.part = drawnFor(frame.part, kInputsAround, picturePx, drawnPx);
    state.frames->draw(request, number, frame.inputs);
    read = historyReach(frame.inputs, frame.part);
    frames_.push_back(std::move(frame));
  }
}

std::map<int, glm::dvec3> PartlyResolved::colors(TaaPass& pass, const HistoryHandle& before,
                                                 const Settings& settings, const Progress& progress) {
  std::map<int, glm::dvec3> colors;
  const History* previous = before.get();
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
    report(progress, say<"Trying remedies">(), static_cast<int>(frame - frames_.rbegin()),
           static_cast<int>(frames_.size()));
    pass.resolvePart(frame->inputs, frame->inputs.info.startsHistory ? nullptr : previous, settings, next_,
                     frame->part);
    std::swap(made_, next_);
    previous = &made_;
    const auto wanted = wanted_.find(frame->number);
    if (wanted == wanted_.end()) continue;
    const Image color = made_.color.download(rectOf(wanted->second));
    colors[frame->number] = glm::dvec3(color.at(0, 0)[0], color.at(0, 0)[1], color.at(0, 0)[2]);
  }
  gl::checkErrors(say<"trying other settings">());
  return colors;
}

} // namespace taa
