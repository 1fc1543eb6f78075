// How time goes on while a shot plays.
#pragma once

#include <optional>
#include <utility>

namespace taa {

struct Playback {
  double framesPerSecond = 0.0;             ///< 0: the shot's own
  double speed = 1.0;                       ///< of it, kSlowestPlayback to kFastestPlayback
  std::optional<std::pair<int, int>> range; ///< first and last frame of what is repeated; nothing: the shot
  bool operator==(const Playback&) const = default;
};
inline constexpr double kSlowestPlayback = 0.05, kFastestPlayback = 8.0;

} // namespace taa
