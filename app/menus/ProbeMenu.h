// The probes: where they are set, which is active, what it follows.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class GoToPrompts;
class ProbeChoices;
class ProbeCommands;
class ProbePanel;
class SceneChoices;
class Session;
class VerdictChoices;
class ViewArea;

class ProbeMenu : public CommandMenu {
  Q_OBJECT
 public:
  struct Targets {
    ProbeChoices& probes;
    VerdictChoices& verdicts;
    ViewArea& views;
    ProbePanel& panel;
    ProbeCommands& probe;
    GoToPrompts& prompts;
    const SceneChoices& scene;
    Session& session;
  };
  ProbeMenu(Commands& commands, const Targets& on, QWidget* parent);

 private:
  void addPlaces(const Targets& on);
  void addProbes(const Targets& on);
  void addWorst(ProbeCommands& probe);
  void addRegion(const Targets& on);
  void addVerdicts(const Targets& on);
  void addRemedies(VerdictChoices& verdicts);
  void addPages(ProbePanel& panel, Session& session);
  void addPlot(ProbePanel& panel);
};

} // namespace taa::app
