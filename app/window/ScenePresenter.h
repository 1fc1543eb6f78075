// Keeps the tree of the scene up to date, and does what it asks for; a probe selects its object there.
#pragma once

#include <QObject>

namespace taa::app {

class ScenePanel;
class Session;
class ViewArea;

class ScenePresenter : public QObject {
  Q_OBJECT
 public:
  ScenePresenter(Session& session, ViewArea& views, ScenePanel& panel);

 private:
  void connectPanel();
  void connectProbes();
  void showStatus();
  void showArea();
  void selectProbed();

  Session& session_;
  ViewArea& views_;
  ScenePanel& panel_;
  bool selectsProbed_ = false; ///< the object at the probe, once it is known
  bool reveals_ = false;       ///< the next probe is of the selected object
};

} // namespace taa::app
