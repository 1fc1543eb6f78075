// What can be laid over a picture.
#pragma once

#include <QString>

#include <cstdint>

namespace taa::app {

/// Besides the marks of what is no color.
enum class Overlay : std::uint8_t { Clipped, Rejected, Outlines, Arrows, Grid, WholeLegend };
inline constexpr int kOverlayCount = 6;

/// As menus say it.
QString overlayText(Overlay overlay);

} // namespace taa::app
