// What is opened, saved and exported.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class DoctorCommands;
class Exports;
class FigureExport;
class ImportFrames;
class SessionKeeper;

class FileMenu : public CommandMenu {
  Q_OBJECT
 public:
  struct Targets {
    SessionKeeper& keeper;
    ImportFrames& imports;
    Exports& exports;
    DoctorCommands& doctor;
    FigureExport& figures;
  };
  FileMenu(Commands& commands, const Targets& on, QWidget* parent);

 private:
  void addRecent();
  void addExports();

  SessionKeeper& keeper_;
  Exports& exports_;
  DoctorCommands& doctor_;
  FigureExport& figures_;
};

} // namespace taa::app
