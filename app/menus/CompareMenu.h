// Submenus of views: how many there are, what they are compared with, what lies over their pictures.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class PresetChoices;
class ViewArea;
class ViewChoices;

class ViewCountMenu : public CommandMenu {
  Q_OBJECT
 public:
  ViewCountMenu(Commands& commands, ViewArea& views, QWidget* parent);
};

class CompareMenu : public CommandMenu {
  Q_OBJECT
 public:
  CompareMenu(Commands& commands, const PresetChoices& presets, ViewArea& views, ViewChoices& choices,
              QWidget* parent);

 private:
  void addSides(ViewArea& views);
};

class OverlayMenu : public CommandMenu {
  Q_OBJECT
 public:
  OverlayMenu(Commands& commands, ViewArea& views, QWidget* parent);
};

} // namespace taa::app
