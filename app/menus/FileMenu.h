// What is opened, saved and exported.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class DoctorCommands;
class Exports;
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
  };
  FileMenu(Commands& commands, const Targets& on, QWidget* parent);

 private:
  void addRecent();
  void addExports();

  SessionKeeper& keeper_;
  Exports& exports_;
  DoctorCommands& doctor_;
};

} // namespace taa::app
