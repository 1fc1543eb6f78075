// The command line of taa-inspector.
#pragma once

#include "app/style/Theme.h"
#include "app/views/Overlays.h"

#include "core/inspect/Comparison.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/SceneCost.h"
#include "core/scene/ShotChoice.h"
#include "core/scene/camera/CameraTrack.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace taa::app {

struct Arguments {
  std::string source = "builtin:fan";
  std::string screenshot;           ///< file to write a picture of the window to; empty: open a window
  bool force = false;               ///< that picture replaces a file that is there
  glm::ivec2 windowSize{1600, 900}; ///< logical pixels; of a screenshot
  std::optional<glm::ivec2> size;   ///< render size, px
  std::optional<double> zoom;       ///< screen pixels a pixel, around the probe
  std::optional<int> frame;         ///< go there and pause
  std::optional<glm::ivec2> pixel;  ///< probe
  std::optional<int> checkpoints;   ///< memory for kept histories, MiB
  SceneBudget sceneBudget;          ///< what a scene may ask for
  std::optional<ThemeChoice> theme;
  std::string shaders;                 ///< folder to read shaders from; empty: the ones built in
  std::string camera, preset;          ///< empty: the source's own, "balanced"
  std::vector<IntermediateId> views;   ///< up to four; three show as four
  std::vector<Comparison> comparisons; ///< of view A, B, …
  std::optional<Showing> showing;      ///< of all that compare
  std::vector<Overlay> overlays;       ///< over all views
  std::string panel;                   ///< page of the lower area to show, or "scene"; empty: none
  std::string dialog;                  ///< of dialogNames(), in a picture of the window; empty: none
  std::string figure;                  ///< of the window's, in a picture of it alone; empty: the whole window
  std::string lesson;                  ///< id of the lesson to open; empty: none
  int lessonStep = 1;                  ///< counted from 1
  std::optional<int> textPercent;      ///< size of the window's text
  std::optional<CameraTrack> track;    ///< looked through
  ShotChoice choice;                   ///< of a scene's animations and length
  ObjectFilter filter;
  bool reopens = false; ///< nothing says what to show: go on from where the program was closed
  bool timing = false;  ///< say on stderr when the first picture was there
};

/// What to do instead of running, with the exit code: help, version, a usage error.
struct EarlyEnd {
  int code = 0;
  std::string text;
};

/// Fills `arguments`; returns why the program shall end at once, if it shall.
std::optional<EarlyEnd> parseArguments(int argc, const char* const* argv, Arguments& arguments);

} // namespace taa::app
