// What is told below a picture: what is shown, in which range and colors, and what lies over it.
#pragma once

#include "app/views/legend/LegendFlow.h"

#include "core/requests/Results.h"
#include "core/settings/Settings.h"

#include <QString>

namespace taa::app {

/// A side of a view.
struct LegendSide {
  Intermediate row; ///< of a difference: a signed one
  ViewStyle style;
  bool isDifference = false;
  QString note{};                        ///< of the reference: samples and errors
  const ReasonCounts* reasons = nullptr; ///< of this picture; null: not known yet
  SpaceSettings space{};                 ///< names the channels
  QString absence{};                     ///< what the checkers mean; empty: there are none
};

/// One side of what is looked at.
struct ViewContent {
  Intermediate row; ///< of a difference: a signed one
  ViewStyle style;
  QString text;          ///< row and settings
  SpaceSettings space{}; ///< of the settings that make it: names the channels
};

/// What it shows, in which range and colors.
void addRowLegend(LegendFlow& flow, const LegendSide& side, const ThemeColors& colors);
/// The short legend of a low picture: name, range and colors, and a sign for what is left out. Of categories
/// the name alone: they take lines of their own in a narrow strip.
void addScaleLegend(LegendFlow& flow, const LegendSide& side, const ThemeColors& colors);
/// What its legend begins with.
QString rowName(const LegendSide& side);
/// What lies over it, as `transform` draws it. `other`: of the side beside it, null without one.
void addOverlayLegend(LegendFlow& flow, const LegendSide& side, const ReasonCounts* other,
                      const ViewTransform& transform, const ThemeColors& colors);

/// Where a legend would cover much of the pictures what it says of overlays is folded away, and where that is
/// not enough all but the name and its scale.
enum class LegendFold { Nothing, Overlays, AllButName };

/// On the screen. What is folded comes back while the mouse is on the sign that stands for it.
struct ShownLegend {
  LegendFlow flow;
  QRect place;
  QRect sign; ///< empty where nothing was folded
};

} // namespace taa::app
