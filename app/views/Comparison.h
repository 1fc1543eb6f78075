// What a view is compared with, and how both are shown.
#pragma once

#include "core/taa/Intermediates.h"

#include <QString>

#include <cstdint>
#include <string>

namespace taa::app {

enum class OtherKind : std::uint8_t { Nothing, Row, Preset, Frame, FramesBefore };

/// The other side of a view. What it does not say is as in the view: row, settings, frame.
struct Comparison {
  OtherKind kind = OtherKind::Nothing;
  IntermediateId id{}; ///< Row
  QString preset{};    ///< Preset: id of a built-in one, or the path of a file
  int frame = 0;       ///< Frame: its number; FramesBefore: how many
  bool operator==(const Comparison&) const = default;
  explicit operator bool() const { return kind != OtherKind::Nothing; }
};

/// "resolved", "preset:sharp", "frame:12", "frame:-1" (the one before), "nothing".
std::string comparisonText(const Comparison& comparison);
/// Throws Error saying what there is. The preset is not looked for.
Comparison parseComparison(const std::string& text);

/// What of both sides is on the screen.
enum class Showing : std::uint8_t { First, Other, Difference, Wipe };
/// "first", "other", "difference", "wipe".
std::string_view showingName(Showing showing);
/// Throws Error naming those there are.
Showing showingNamed(std::string_view name);

/// What can be laid over a picture, besides the marks of what is no color.
enum class Overlay : std::uint8_t { Clipped, Rejected, Outlines, Arrows, Grid };
inline constexpr int kOverlayCount = 5;

} // namespace taa::app
