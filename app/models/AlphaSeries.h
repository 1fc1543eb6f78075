// α of a pixel over the frames up to the one on show: as the settings say, and as it was measured.
#pragma once

#include "core/render/JitterWay.h"
#include "core/settings/Settings.h"

#include <QString>

#include <optional>
#include <vector>

namespace taa::app {

struct AlphaSeries {
  Settings settings;
  int frame = 0;
  int start = 0; ///< where history starts at the latest: the first frame, the last cut or the last restart
  /// Of the active probe, oldest first, up to `frame`; empty: not known.
  std::vector<double> measured;
  QString place;                       ///< of that probe: "(412, 207)"
  std::vector<glm::vec2> jitterPx;     ///< of a capture, one period; empty: as the settings say
  std::optional<glm::dvec2> jitterWay; ///< of the frame, where it is known

  /// Frames since history started, as many as can still count.
  int length() const;
  /// What the settings come to in a still gray pixel, oldest first.
  std::vector<double> nominal() const;
};

/// Frames before that weigh nothing any more that could be seen.
inline constexpr int kMaxFramesBack = 512;

} // namespace taa::app
