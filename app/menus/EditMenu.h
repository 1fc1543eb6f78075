// Undo, copies, search.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class CommandLists;
class EscapeKey;
class Exports;
class LeftArea;
class PipelinePanel;
class ProbeCommands;
class ProfilerPanel;
class Session;

class EditMenu : public CommandMenu {
  Q_OBJECT
 public:
  struct Targets {
    Session& session;
    EscapeKey& escape;
    ProbeCommands& probe;
    Exports& exports;
    ProfilerPanel& profiler;
    LeftArea& left;
    PipelinePanel& pipeline; ///< on the left
    CommandLists& lists;
  };
  EditMenu(Commands& commands, const Targets& on, QWidget* parent);

 private:
  void addUndo(Session& session);
  void addCopies(const Targets& on);
};

} // namespace taa::app
