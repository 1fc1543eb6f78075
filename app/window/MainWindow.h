// The window: makes the panels around the views and what keeps them in touch with the session.
#pragma once

#include "app/session/Session.h"
#include "app/style/Theme.h"

#include <QMainWindow>

#include <functional>
#include <memory>
#include <string>
#include <vector>

class QSettings;

namespace taa::app {

class CameraFiles;
class CommandLists;
class Commands;
class DoctorCommands;
class DoctorPanel;
class EscapeKey;
class Exports;
class FigureExport;
class Flight;
class FlightBar;
class FlightPresenter;
class GoToPrompts;
class ImportFrames;
class JitterPanel;
class LadderSteps;
class LearnPanel;
class Learning;
class LeftArea;
class LineagePresenter;
class LineagePanel;
class LowerArea;
class MenuTitle;
class MessagesBar;
class OwnPresets;
class PanelCycle;
class PipelinePanel;
class PlotPresenter;
class PlotsPanel;
class Presenter;
class ProbeCommands;
class ProbePresenter;
class ProbePanel;
class ProfilerPanel;
class ScenePresenter;
class ScenePanel;
class SessionKeeper;
class StatusLine;
class ThemeSetting;
class TimelinePanel;
class VerdictPresenter;
class ViewArea;
class ViewChoices;
class ViewPresenter;
class WeightsPanel;
class WindowState;
class WindowUndo;
class WorkBar;
class Workspace;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// `settings` remembers layout, theme and the hint; null: nothing is remembered.
  MainWindow(Session& session, QSettings* settings, QWidget* parent = nullptr);
  ~MainWindow() override;

  ViewArea& views() { return *views_; }
  SessionKeeper& keeper() { return *keeper_; }
  /// Offers the tour in a line across the window, unless that was done before.
  void offerTour();
  void setTheme(ThemeChoice choice);
  /// For this start alone.
  void setTextPercent(int percent);
  /// Opens the page Learn at a step, counted from 1.
  void openLesson(const std::string& lesson, int step);
  /// Opens a page by its name: "profiler", "plots" … below, "colorspace", "whatif" or "sensitivity" of the
  /// probe, "scene" on the left, "learn"; anything else: nothing.
  void openPage(const std::string& name);
  /// One of dialogNames(); expects an open source.
  void openDialog(const std::string& name);
  /// Writes a picture of the window once all of this frame has arrived in it, and calls `done` with an exit
  /// code and what to say. `dialog` is opened before; empty: none. `figure`: of one alone; empty: of all.
  void takeScreenshot(const QString& file, int frame, const std::string& dialog, const std::string& figure,
                      std::function<void(int code, const QString& text)> done);

 protected:
  void showEvent(QShowEvent*) override;
  void closeEvent(QCloseEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dropEvent(QDropEvent*) override;

 private:
  void makePanels();
  QWidget* partNamed(const QString& name) const;
  void layOut();
  std::vector<QWidget*> panelsInOrder() const;
  void orderPanels();
  void makeKeeper();
  void makeCommands();
  void makeRoom();
  void makeMenus();
  void makeFeeds();
  void connectMenus();
  void connectPanels();
  void connectProfiler();
  void connectSession();
  void connectMessages();
  void watchShaders();
  void showStatus();
  void startSource(const Status& status);
  void showTitle();
  void showOffer(QWidget* bar);
  void showHint();
  void showSettings();
  void restore();
  void remember();

  Session& session_;
  QSettings* settings_;
  bool wasShown_ = false;
  std::string shownSource_; ///< whose warnings and first probe are shown
  // Panels
  ViewArea* views_ = nullptr;
  PipelinePanel* pipeline_ = nullptr;
  ScenePanel* scene_ = nullptr;
  LeftArea* left_ = nullptr;
  LearnPanel* learn_ = nullptr;
  ProbePanel* probe_ = nullptr;
  LowerArea* lower_ = nullptr;
  ProfilerPanel* profiler_ = nullptr;
  PlotsPanel* plots_ = nullptr;
  JitterPanel* jitter_ = nullptr;
  WeightsPanel* weights_ = nullptr;
  LineagePanel* lineage_ = nullptr;
  DoctorPanel* doctor_ = nullptr;
  TimelinePanel* timeline_ = nullptr;
  MessagesBar* messages_ = nullptr;
  StatusLine* statusLine_ = nullptr;
  WorkBar* work_ = nullptr;
  FlightBar* flightBar_ = nullptr;
  Workspace* workspace_ = nullptr;
  MenuTitle* title_ = nullptr; ///< what is open
  // What commands do
  SessionKeeper* keeper_ = nullptr;
  ThemeSetting* theme_ = nullptr;
  Flight* flight_ = nullptr;
  EscapeKey* escape_ = nullptr;
  Exports* exports_ = nullptr;
  FigureExport* figures_ = nullptr;
  ImportFrames* imports_ = nullptr;
  CameraFiles* cameras_ = nullptr;
  OwnPresets* presets_ = nullptr;
  ProbeCommands* probeCommands_ = nullptr;
  DoctorCommands* doctorCommands_ = nullptr;
  GoToPrompts* prompts_ = nullptr;
  ViewChoices* choices_ = nullptr;
  LadderSteps* ladder_ = nullptr;
  Learning* learning_ = nullptr;
  Presenter* presenter_ = nullptr;
  CommandLists* lists_ = nullptr;
  PanelCycle* panels_ = nullptr;
  // What ends before the panels do: they have more to say while they are destroyed
  std::unique_ptr<WindowState> state_;
  std::unique_ptr<Commands> commands_;
  std::unique_ptr<ProbePresenter> probePresenter_;
  std::unique_ptr<VerdictPresenter> verdictPresenter_;
  std::unique_ptr<PlotPresenter> plotPresenter_;
  std::unique_ptr<LineagePresenter> lineagePresenter_;
  std::unique_ptr<ScenePresenter> scenePresenter_;
  std::unique_ptr<FlightPresenter> flightPresenter_;
  std::unique_ptr<ViewPresenter> viewPresenter_;
  std::unique_ptr<WindowUndo> undo_;
};

} // namespace taa::app
