// How large the text of the whole window is, for a room or for tired eyes: fonts, and what is as high as they
// are.
#pragma once

namespace taa::app {

/// A property of a widget: its limits are of pictures, and stay.
inline constexpr const char* kKeepsLimits = "keepsLimits";

inline constexpr int kMinTextPercent = 100, kMaxTextPercent = 200, kTextStep = 25;

/// Makes texts `percent` of their size by design, in all widgets there are and in those to come: fonts, rows,
/// icons and the limits that widgets were given for them grow alike, distances stay. From 100 to 200; back at
/// a size everything is as it was there. applyTheme() is to follow, then fitFonts().
void resizeText(int percent);
int textPercent();
/// Gives widgets with fonts of their own those of the size in force; `percentBefore`: the size they were
/// given at. A theme that is applied takes them back.
void fitFonts(int percentBefore);

} // namespace taa::app
