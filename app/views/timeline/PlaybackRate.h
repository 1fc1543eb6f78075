// How many frames a second come on show while a shot plays.
#pragma once

#include <deque>
#include <optional>
#include <utility>

namespace taa::app {

class PlaybackRate {
 public:
  /// A status says that this frame is on show. `seconds`: by any clock that only goes forward.
  void note(int frame, double seconds);
  void stop() { shown_.clear(); }
  /// Frames a second over the last second, or between the last two where they came slower; nothing before the
  /// second one.
  std::optional<double> value() const;

 private:
  std::deque<std::pair<int, double>> shown_; // frame and time
};

} // namespace taa::app
