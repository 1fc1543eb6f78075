// What a picture is compared with, and how both sides are shown.
#pragma once

#include "core/taa/Intermediates.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace taa {

enum class OtherKind : std::uint8_t {
  Nothing,
  Row,
  Preset,
  Frame,
  FramesBefore,
  AlongMotion ///< the frame before, each pixel where it came from
};

/// The other side of a picture. What it does not say is as in the first one: row, settings, frame.
struct Comparison {
  OtherKind kind = OtherKind::Nothing;
  IntermediateId id{};  ///< Row
  std::string preset{}; ///< Preset: id of a built-in one, or the path of a file
  int frame = 0;        ///< Frame: its number; FramesBefore: how many
  bool operator==(const Comparison&) const = default;
  explicit operator bool() const { return kind != OtherKind::Nothing; }
};

/// "resolved", "preset:sharp", "frame:12", "frame:-1" (the one before), "motion:-1" (the same along the
/// motion), "nothing".
std::string comparisonText(const Comparison& comparison);
/// Also understands "row:resolved". Throws Error saying what there is. The preset is not looked for.
Comparison parseComparison(const std::string& text);
/// What comparisons can be said with, for a help text.
inline constexpr char kComparisonHelp[] = "an intermediate (reference is one), preset:NAME, frame:N, "
                                          "frame:-N for N frames before, or motion:-1 for "
                                          "the frame before, each pixel where it came from";

/// What of both sides is seen.
enum class Showing : std::uint8_t { First, Other, Difference, Wipe };
/// "first", "other", "difference", "wipe".
std::string_view showingName(Showing showing);
/// Throws Error naming those there are.
Showing showingNamed(std::string_view name);

} // namespace taa
