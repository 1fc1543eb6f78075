// The menus and keys of the window: everything the mouse does has a key, and every key stands in a menu.
#pragma once

#include "core/Inspector.h"

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QAction;
class QMenu;

namespace taa::app {

class MainWindow;

class Menus : public QObject {
  Q_OBJECT
 public:
  explicit Menus(MainWindow& window);

  /// Brings checks and lists up to date with the session and the views.
  void refresh();

  struct Command {
    QString menu;
    QAction* action;
  };
  /// Everything that can be asked for, in the order of the menus.
  const std::vector<Command>& commands() const { return commands_; }

 private:
  QAction* add(QMenu* menu, const QString& text, const QList<QKeySequence>& keys, std::function<void()> act);
  QAction* addCheck(QMenu* menu, const QString& text, const QKeySequence& key, std::function<void(bool)> act);
  void makeFile();
  void makeEdit();
  void makeView();
  void makePictures(QMenu* menu);
  void makeFrame();
  void makePipeline();
  void makeProbe();
  void makeHelp();
  void makeCameras();
  void makeObjects();

  MainWindow& window_;
  std::vector<Command> commands_;
  QAction *twoViews_ = nullptr, *linked_ = nullptr, *looping_ = nullptr, *marks_ = nullptr, *play_ = nullptr;
  QAction* profiler_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr;
  QList<QAction*> themes_, arrangements_, budgets_;
  QMenu *cameras_ = nullptr, *objects_ = nullptr;
  std::vector<std::string> cameraNames_, objectNames_;
};

} // namespace taa::app
