// Lessons, keys and manual.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class CommandLists;
class Learning;
class Session;

class HelpMenu : public CommandMenu {
  Q_OBJECT
 public:
  HelpMenu(Commands& commands, const Session& session, CommandLists& lists, Learning& learning,
           QWidget* parent);
};

} // namespace taa::app
