// What of the window is a figure by itself, and what captions say of frame and settings.
#pragma once

#include "app/figures/Figure.h"

#include <QString>

#include <vector>

namespace taa::app {

class JitterPanel;
class LineagePanel;
class PlotsPanel;
class ProbePanel;
class ProfilerPanel;
class Session;
class ViewArea;
class WeightsPanel;

struct FigurePanels {
  Session& session;
  ViewArea& views;
  ProbePanel& probe;
  ProfilerPanel& profiler;
  PlotsPanel& plots;
  JitterPanel& jitter;
  WeightsPanel& weights;
  LineagePanel& lineage;
};

/// Views with their legends first, in the order of their letters.
std::vector<Figure> windowFigures(const FigurePanels& of);
/// "builtin:fan, 640×360, frame 40, balanced, probe (415, 216)."
QString figureFacts(const Session& session);

} // namespace taa::app
