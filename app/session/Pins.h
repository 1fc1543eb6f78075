// The list of pinned probes, in the order of their numbers, with what last arrived for each.
#pragma once

#include "core/requests/Results.h"

#include <optional>
#include <vector>

namespace taa::app {

/// A pin as the views draw it.
struct PinMark {
  int number = 1;
  glm::ivec2 pixel{0}; ///< of the frame on show
  PinState state = PinState::Seen;
  bool isActive = false;
  bool followsSurface = false;
  bool operator==(const PinMark&) const = default;
};

class Pins {
 public:
  const std::vector<ProbePin>& all() const { return pins_; }
  int count() const { return static_cast<int>(pins_.size()); }
  /// Index of the one that keys and the probe panel are about; −1 without pins.
  int active() const { return active_; }
  /// What last arrived for a pin; null: nothing yet.
  const ProbeResult* result(int pin) const;
  /// Where a pin is in the frame that last arrived, or where it was set.
  glm::ivec2 pixel(int pin) const;
  /// Those that can be seen in the picture, the active one last.
  std::vector<PinMark> marks() const;

  // Each returns whether anything changed.
  bool add(const ProbePin& pin); ///< and makes it active, or the one that is there already
  bool remove(int pin);
  bool clear();
  bool setActive(int pin);
  /// Puts another in place of it, whose result is that of the old one until its own arrives.
  bool replace(int pin, const ProbePin& by);
  bool set(const std::vector<ProbePin>& pins, int active);
  /// Surfaces of another scene: their pins stay where they are.
  bool forgetSurfaces();
  /// Keeps a result and what it found out about its pin; false when the pin is no longer there.
  bool take(ProbeResult&& result);

 private:
  std::vector<ProbePin> pins_;
  std::vector<std::optional<ProbeResult>> results_; ///< one a pin
  int active_ = -1;
};

} // namespace taa::app
