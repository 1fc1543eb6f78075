// Objects of the scene, and the camera that is flown.
#pragma once

#include "app/menus/Commands.h"
#include "app/session/SceneChoices.h"

namespace taa::app {

class CameraFiles;
class Flight;
class LeftArea;
class ScenePanel;

class SceneMenu : public CommandMenu {
  Q_OBJECT
 public:
  struct Targets {
    const SceneChoices& choices;
    Flight& flight;
    CameraFiles& cameras;
    LeftArea& left;
    ScenePanel& scene; ///< on the left
  };
  SceneMenu(Commands& commands, const Targets& on, QWidget* parent);

 private:
  void addFlight(Flight& flight);
  void addCameras(CameraFiles& cameras);
  QString whyFixed() const { return choices_.whyFixed(); }
  void addTree(LeftArea& left, ScenePanel& scene);
  void addSelection(ScenePanel& scene);

  const SceneChoices& choices_;
};

} // namespace taa::app
