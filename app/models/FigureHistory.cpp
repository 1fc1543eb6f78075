#include "app/models/FigureHistory.h"

#include "app/style/Text.h"

#include <cmath>
#include <optional>

namespace taa::app {

bool FigureHistory::setShotVersion(std::uint64_t shotVersion) {
  if (shotVersion == shotVersion_) return false;
  shotVersion_ = shotVersion;
  known_.clear();
  return true;
}

bool FigureHistory::add(const FrameFigures& figures) {
  if (figures.lane != 0 || !figures.exact || figures.shotVersion < shotVersion_) return false;
  setShotVersion(figures.shotVersion);
  // What a delivery leaves out, because nobody asked for it or a reference is missing, stays known.
  FrameFigures& known = known_[figures.frame];
  for (std::size_t index = 0; index < figures.values.size(); ++index)
    if (figures.values[index]) known.values[index] = figures.values[index];
  return true;
}

TimelineStrip FigureHistory::strip(Figure figure, int frameCount) const {
  const FigureInfo& info = figureInfo(figure);
  TimelineStrip strip{
      tableText(info.label), info.unit.empty() ? QString() : QLatin1Char(' ') + tableText(info.unit), {}};
  strip.values.resize(static_cast<std::size_t>(frameCount));
  for (const auto& [frame, figures] : known_) {
    const std::optional<double> value = figures.at(figure);
    if (frame < frameCount && value && std::isfinite(*value))
      strip.values[static_cast<std::size_t>(frame)] = value;
  }
  return strip;
}

} // namespace taa::app
