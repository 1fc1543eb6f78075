// What is opened, saved and exported.
#pragma once

#include "app/menus/Commands.h"

namespace taa::app {

class Exports;
class ImportFrames;
class SessionKeeper;

class FileMenu : public CommandMenu {
  Q_OBJECT
 public:
  FileMenu(Commands& commands, SessionKeeper& keeper, ImportFrames& imports, Exports& exports,
           QWidget* parent);

 private:
  void addRecent();
  void addExports();

  SessionKeeper& keeper_;
  Exports& exports_;
};

} // namespace taa::app
