// Submenus of time: speed and the part that is repeated, marks, the metric under the timeline.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class GoToPrompts;
class TimelinePanel;

class PlaybackMenu : public CommandMenu {
  Q_OBJECT
 public:
  PlaybackMenu(Commands& commands, TimelinePanel& timeline, QWidget* parent);

 private:
  void addSpeeds(TimelinePanel& timeline);
  void addRates(TimelinePanel& timeline);
};

class MarksMenu : public CommandMenu {
  Q_OBJECT
 public:
  MarksMenu(Commands& commands, TimelinePanel& timeline, GoToPrompts& prompts, QWidget* parent);
};

class MetricsMenu : public CommandMenu {
  Q_OBJECT
 public:
  MetricsMenu(Commands& commands, TimelinePanel& timeline, QWidget* parent);
};

} // namespace taa::app
