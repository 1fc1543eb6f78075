// Mistakes of an integration, injected on purpose: an entry for each of the core's table.
#pragma once

#include "app/menus/Commands.h"
#include "core/settings/Faults.h"

namespace taa::app {

class DoctorCommands;
class LowerArea;
class Session;

class FaultsMenu : public CommandMenu {
  Q_OBJECT
 public:
  FaultsMenu(Commands& commands, Session& session, LowerArea& lower, DoctorCommands& doctor, QWidget* parent);

  /// Whether those that are injected have a mark. Where a task asks for one, none has.
  void setFaultsNamed(bool areNamed);

 private:
  void addExamine(LowerArea& lower, DoctorCommands& doctor);
  void addCorrected(DoctorCommands& doctor);
  void addNone(Session& session);
  void addPart(Session& session, FaultPart part);
  void addFault(Session& session, QMenu* menu, const FaultInfo& info);

  bool areNamed_ = true;
};

} // namespace taa::app
