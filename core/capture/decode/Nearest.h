// Values of another size: each pixel takes the one whose place its own center lies in.
#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace taa::capture {

/// Of each pixel of a side of `to` the pixel of a side of `from` that lies there.
inline std::vector<std::size_t> nearestPlaces(int from, int to) {
  std::vector<std::size_t> places(static_cast<std::size_t>(to));
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = (2 * i + 1) * static_cast<std::size_t>(from) / (2 * places.size());
  return places;
}

/// `values`: `channels` of each pixel of a picture of `from`, row by row.
template <typename Value>
std::vector<Value> resized(const std::vector<Value>& values, const glm::ivec2& from, const glm::ivec2& to,
                           std::size_t channels) {
  const std::vector<std::size_t> columns = nearestPlaces(from.x, to.x), rows = nearestPlaces(from.y, to.y);
  std::vector<Value> result(columns.size() * rows.size() * channels);
  auto at = result.begin();
  for (const std::size_t row : rows) {
    const Value* line = values.data() + row * static_cast<std::size_t>(from.x) * channels;
    for (const std::size_t column : columns) at = std::copy_n(line + column * channels, channels, at);
  }
  return result;
}

} // namespace taa::capture
