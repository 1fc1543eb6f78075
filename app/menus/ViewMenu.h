// Views, panels, how pictures are drawn.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class LeftArea;
class LowerArea;
class MessagesBar;
class PipelinePanel;
class PlotsPanel;
class Presenter;
class PresetChoices;
class ProbePanel;
class SceneChoices;
class ThemeSetting;
class ViewArea;
class ViewChoices;

class ViewMenu : public CommandMenu {
  Q_OBJECT
 public:
  struct Targets {
    const PresetChoices& presets;
    const SceneChoices& scene;
    ViewArea& views;
    ViewChoices& choices;
    LeftArea& left;
    PipelinePanel& pipeline; ///< on the left
    ProbePanel& probe;
    LowerArea& lower;
    PlotsPanel& plots; ///< a page of `lower`
    ThemeSetting& theme;
    Presenter& presenter;
    MessagesBar& messages;
  };
  ViewMenu(Commands& commands, const Targets& on, QWidget* parent);

 private:
  void addViews(const Targets& on);
  void addEngine(const Targets& on);
  void addZoom(ViewArea& views);
  void addPanels(const Targets& on);
  void addLowerPages(LowerArea& lower);
  void addPlots(LowerArea& lower, PlotsPanel& plots);
  void addArrangement(ViewArea& views);
  void addPictures(ViewArea& views);
  void addThemes(ThemeSetting& theme);
  void addTextSizes(ThemeSetting& theme);
  void addRoom(Presenter& presenter);
  void addMessages(MessagesBar& messages);
};

} // namespace taa::app
