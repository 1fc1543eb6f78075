// View menu: the plots of the probes over frames, whose page is opened if need be.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class LowerArea;
class PlotsPanel;

class PlotsMenu : public CommandMenu {
  Q_OBJECT
 public:
  /// `plots` is a page of `lower`.
  PlotsMenu(Commands& commands, LowerArea& lower, PlotsPanel& plots, QWidget* parent);
};

} // namespace taa::app
