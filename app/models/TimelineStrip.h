// A metric of each frame, as the timeline draws it.
#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace taa::app {

struct TimelineStrip {
  QString name, unit;                        ///< no name: no strip
  std::vector<std::optional<double>> values; ///< by frame; nothing: not known
  bool operator==(const TimelineStrip&) const = default;
};

} // namespace taa::app
