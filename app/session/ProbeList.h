// The list of probes, in the order of their numbers, with what last arrived for each.
#pragma once

#include "core/requests/Results.h"

#include <optional>
#include <vector>

namespace taa::app {

/// A probe as the views draw it.
struct ProbeMark {
  int number = 1;
  glm::ivec2 pixel{0}; ///< of the frame on show
  ProbeState state = ProbeState::Seen;
  bool isActive = false;
  bool followsSurface = false;
  bool operator==(const ProbeMark&) const = default;
};

class ProbeList {
 public:
  const std::vector<Probe>& all() const { return probes_; }
  int count() const { return static_cast<int>(probes_.size()); }
  /// Index of the one that keys and the probe panel are about; −1 without probes.
  int active() const { return active_; }
  /// What last arrived for a probe; null: nothing yet.
  const ProbeResult* result(int probe) const;
  /// Whether that is of the probe as it is set now.
  bool hasOwnResult(int probe) const;
  /// Where a probe is in the frame that last arrived, or where it was set.
  glm::ivec2 pixel(int probe) const;
  /// Those that can be seen in the picture, the active one last.
  std::vector<ProbeMark> marks() const;

  // Each returns whether anything changed.
  bool add(const Probe& probe); ///< and makes it active, or the one that is there already
  bool remove(int probe);
  bool clear();
  bool setActive(int probe);
  /// Puts another in place of it, whose result is that of the old one until its own arrives.
  bool replace(int probe, const Probe& by);
  bool set(const std::vector<Probe>& probes, int active);
  /// Surfaces of another scene: their probes stay where they are.
  bool forgetSurfaces();
  /// Keeps a result and what it found out about its probe; false when the probe is no longer there.
  bool take(ProbeResult&& result);

 private:
  std::vector<Probe> probes_;
  std::vector<std::optional<ProbeResult>> results_; ///< one a probe
  int active_ = -1;
};

} // namespace taa::app
