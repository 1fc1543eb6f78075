#include "core/measure/FlickerRows.h"

#include "core/measure/ReferenceRows.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {

void keepOnly(FlickerWindow& window, int first, int last) {
  std::erase_if(window.frames, [&](const auto& entry) { return entry.first < first || entry.first > last; });
}

FlickerMaps flickerMaps(const FlickerWindow& window, int first, int last, const Progress& progress) {
  std::vector<const FlickerFrame*> newestFirst;
  for (int frame = last; frame >= first; --frame) newestFirst.push_back(&window.frames.at(frame));
  const int frames = last - first + 1;
  const Progress told = [&](std::string_view what, int, int) {
    return !progress || progress(what, frames, frames); // all are made: this is the end of it
  };
  return flickerMaps(newestFirst, told);
}

std::size_t flickerBytes(const glm::ivec2& picturePx, int frames) {
  constexpr std::size_t kFloats = 3 + 3 + kStepChannels; // what is shown, of the reference too, and the steps
  return kFloats * sizeof(float) * static_cast<std::size_t>(picturePx.x) *
         static_cast<std::size_t>(picturePx.y) * static_cast<std::size_t>(frames);
}

FlickerWindow& FlickerRows::windowOf(const FlickerKey& key) {
  if (!(key_ == key)) {
    forget();
    key_ = key;
  }
  return window_;
}

void FlickerRows::set(int frame, int frames, int samples, FlickerMaps maps) {
  textures_.clear(); // the old pictures first: there may not be room for both
  frame_ = frame;
  frames_ = frames;
  samples_ = samples;
  maps_ = std::move(maps);
}

std::optional<int> FlickerRows::samples(const FlickerKey& key, int frame, int frames) const {
  if (frame_ != frame || frames_ != frames || !(key_ == key)) return {};
  return samples_;
}

const Image& FlickerRows::map(IntermediateId id) const {
  assert(isOverTime(id) && frame_ >= 0);
  if (id == IntermediateId::deviationOverTime) return maps_.deviation;
  return id == IntermediateId::framesFollowed ? maps_.frames : maps_.flicker;
}

Image FlickerRows::image(IntermediateId id, const gl::Rect& region) const {
  const Image& whole = map(id);
  Image part(region.width, region.height, 1);
  for (int y = 0; y < region.height; ++y)
    std::copy_n(whole.at(region.x, region.y + y), region.width, part.at(0, y));
  return part;
}

const gl::Texture& FlickerRows::texture(IntermediateId id) {
  gl::Texture& texture = textures_[id];
  if (!texture) texture = rowTexture(map(id), "flicker row");
  return texture;
}

} // namespace taa
