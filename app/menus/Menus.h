// The menus and keys of the window: everything the mouse does has a key, and every key stands in a menu.
#pragma once

#include "core/inspect/Inspector.h"

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

class QAction;
class QMenu;

namespace taa::app {

class MainWindow;

/// Keys by their names, "Ctrl+O".
QList<QKeySequence> keys(std::initializer_list<const char*> names);

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
  /// What refresh() does for a part of a menu.
  void onRefresh(std::function<void()> bringUpToDate);
  // One file each
  void makeFile();
  void makeEdit();
  void makeView();
  void makeFrame();
  void makePipeline();
  void makeProbe();
  void makeProbePages(QMenu* menu);
  void makeHelp();
  void makeScene();
  // Submenus
  void makeRecent(QMenu* menu);
  void makeExport(QMenu* menu);
  void makeArrangement(QMenu* menu);
  void makeLowerPages(QMenu* menu);
  void makeViews(QMenu* menu);
  void makeComparing(QMenu* menu);
  void makeOverlays(QMenu* menu);
  void makePlots(QMenu* menu);
  void makePictures(QMenu* menu);
  void makeThemes(QMenu* menu);
  void makePlayback(QMenu* menu);
  void makeFrameMarks(QMenu* menu);
  void makeFigures(QMenu* menu);
  void makeSizes(QMenu* menu);
  void makeBudgets(QMenu* menu);
  void makeCameras(QMenu* menu);
  void makeObjects(QMenu* menu);
  void makeReferences(QMenu* menu);
  void refreshObjects(QMenu* menu);

  MainWindow& window_;
  std::vector<Command> commands_;
  std::vector<std::function<void()>> refreshers_;
  std::vector<std::string> cameraNames_, objectNames_;
  IntermediateId beforeReference_ = IntermediateId::resolved; ///< what a key goes back to
};

} // namespace taa::app
