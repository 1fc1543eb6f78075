// Where panels are: in windows of their own, on other screens, or as at a first start.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class PanelCycle;
class Workspace;

class LayoutMenu : public CommandMenu {
  Q_OBJECT
 public:
  LayoutMenu(Commands& commands, Workspace& workspace, PanelCycle& cycle, QWidget* parent);

 private:
  void addWindows(Workspace& workspace);
};

} // namespace taa::app
