// Time, cameras, objects, size.
#pragma once

#include "app/menus/Commands.h"

#include <string>
#include <vector>

namespace taa::app {

class GoToPrompts;
class Session;
class TimelinePanel;

class FrameMenu : public CommandMenu {
  Q_OBJECT
 public:
  FrameMenu(Commands& commands, Session& session, TimelinePanel& timeline, GoToPrompts& prompts,
            QWidget* parent);

 private:
  void addSteps(GoToPrompts& prompts);
  void addLooping(TimelinePanel& timeline);
  void addRestarts(TimelinePanel& timeline);
  void addCameras();
  void refreshCameras(QMenu* menu);
  void addAnimations();
  void refreshAnimations(QMenu* menu);
  void addObjects();
  void refreshObjects(QMenu* menu);
  void addSizes(GoToPrompts& prompts);
  void addBudgets();

  Session& session_;
  std::vector<std::string> cameraNames_, animationNames_, objectNames_;
};

} // namespace taa::app
