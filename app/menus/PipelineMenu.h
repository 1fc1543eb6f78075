// Presets, stages, shaders.
#pragma once

#include "app/menus/Commands.h"
#include "core/taa/Intermediates.h"

namespace taa::app {

class Exports;
class LadderSteps;
class LowerArea;
class OwnPresets;
class PipelinePanel;
class Session;
class ViewArea;

class PipelineMenu : public CommandMenu {
  Q_OBJECT
 public:
  struct Targets {
    Session& session;
    PipelinePanel& pipeline;
    OwnPresets& presets;
    ViewArea& views;
    LowerArea& lower; ///< where what stages cost is shown
    Exports& exports;
    LadderSteps& ladder;
  };
  PipelineMenu(Commands& commands, const Targets& on, QWidget* parent);

 private:
  void addPresets(Session& session);
  void addOwnPresets(Session& session, OwnPresets& presets, Exports& exports);
  void addRungs(LadderSteps& ladder);
  void addShaders(const Targets& on);
  void addReferences(Session& session, ViewArea& views);
  void addReferenceRow(QMenu* menu, ViewArea& views, IntermediateId id, const QString& text, const char* key);

  IntermediateId beforeReference_ = IntermediateId::resolved; ///< what a key goes back to
};

} // namespace taa::app
