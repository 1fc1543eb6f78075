// The window: panels around the views, and what connects them to the session.
#pragma once

#include "app/models/FigureHistory.h"
#include "app/session/Session.h"
#include "app/style/Theme.h"

#include <QElapsedTimer>
#include <QJsonObject>
#include <QMainWindow>

#include <optional>
#include <string>

class QLabel;
class QSettings;
class QSplitter;
class QTabWidget;

namespace taa::app {

enum class LowerPage;
class JitterPanel;
class LowerArea;
class Drags;
struct EscapeState;
class Flight;
class FlightBar;
class Menus;
class Exports;
class MessagesBar;
class PipelinePanel;
class PlotsPanel;
class ProbePanel;
class ProfilerPanel;
class SessionKeeper;
class ShaderWatch;
class ScenePanel;
class StateWatch;
class StatusLine;
class TimelinePanel;
class ViewArea;
class WeightsPanel;
class WorkBar;

enum class ProbeTab;
/// How a probe is copied; JSON is what taa-batch probe prints.
enum class ProbeFormat { Text, Markdown, Json };

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// `settings` remembers layout, theme and the hint; null: nothing is remembered.
  MainWindow(Session& session, QSettings* settings, QWidget* parent = nullptr);
  ~MainWindow() override;

  Session& session() { return session_; }
  ViewArea* views() const { return views_; }
  PipelinePanel* pipeline() const { return pipeline_; }
  ProbePanel* probe() const { return probe_; }
  LowerArea* lower() const { return lower_; }
  ProfilerPanel* profiler() const { return profiler_; }
  PlotsPanel* plots() const { return plots_; }
  JitterPanel* jitter() const { return jitter_; }
  WeightsPanel* weights() const { return weights_; }
  TimelinePanel* timeline() const { return timeline_; }
  MessagesBar* messages() const { return messages_; }
  StatusLine* statusLine() const { return statusLine_; }
  QTabWidget* left() const { return left_; } ///< pipeline and scene
  ScenePanel* scene() const { return scene_; }
  Flight* flight() const { return flight_; }
  FlightBar* flightBar() const { return flightBar_; }

  SessionKeeper* keeper() const { return keeper_; }
  Exports* exports() const { return exports_; }

  /// Opens a session and pauses at its frame, or a file or "builtin:NAME" and plays.
  void openSource(const QString& source);
  /// Views, probes, panels and layout; what they may make of a session of another window.
  QJsonObject state() const;
  void setState(const QJsonObject& state);
  /// The GLSL of the active view's stage.
  void readGlsl();
  void setTheme(ThemeChoice choice);
  ThemeChoice theme() const { return theme_; }
  /// Shows an intermediate in the active view or the other one.
  void showIntermediate(IntermediateId id, bool inOtherView);
  void setPanelVisible(QWidget* panel, bool visible);
  /// Opens the area above the timeline at this page, or closes it.
  void setLowerPage(LowerPage page, bool shown);
  /// The scene's tree on the left, or the pipeline.
  void showScene(bool shown);
  void searchPipeline();

  // What menus and keys ask for
  void escape(); ///< ends the innermost thing, see EscapeKey.h
  void askForFile();
  void askForPixel();
  void askForFrame();
  void askForMarkName();
  void askForSize();
  void askForPresetName();
  void askForPresetFile();
  void comparePresets();
  void showUserPresets();
  void askToSaveCamera();
  void askForCamera();
  void askForCameraName();
  CameraTrackHandle flownCamera() const; ///< that is looked through; null: one of the scene's
  QString presetFolder() const;          ///< of the user's own
  void chooseIntermediate(int view);
  void chooseComparison(int view);
  void showCommands();
  void showKeys();
  void copyValue();
  void copyProbe(ProbeFormat format);
  /// Opens the panel at a page.
  void setProbeTab(ProbeTab tab);
  void pinAnother();
  void copyProfile(bool asCsv);
  /// Opens the profiler if need be.
  void measureStages();

 protected:
  void showEvent(QShowEvent*) override;
  void closeEvent(QCloseEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dropEvent(QDropEvent*) override;

 private:
  void makeParts();
  void makeLeft();
  void connectScene();
  void orderFocus();
  void layOut();
  void connectPanels();
  void connectProbe();
  void connectProfiler();
  void connectLower();
  void connectViews();
  void connectSession();
  void connectFiles();
  void connectUndo();
  EscapeState escapeState() const;
  void showStatus();
  void showSettings();
  void showPick();
  void showHistory();
  void showTraces();
  void showFigure();
  void showProbe();
  void showHover(int view);
  void connectComparing();
  void askForComparedFrame(int view);
  void pickAtFirstStart();
  void restore();
  void remember();

  Session& session_;
  QSettings* settings_;
  ThemeChoice theme_ = ThemeChoice::System;
  bool wasShown_ = false;
  std::string shownSource_; ///< whose warnings and first pick are shown
  ViewArea* views_ = nullptr;
  PipelinePanel* pipeline_ = nullptr;
  ProbePanel* probe_ = nullptr;
  LowerArea* lower_ = nullptr;
  ProfilerPanel* profiler_ = nullptr;
  PlotsPanel* plots_ = nullptr;
  JitterPanel* jitter_ = nullptr;
  WeightsPanel* weights_ = nullptr;
  TimelinePanel* timeline_ = nullptr;
  MessagesBar* messages_ = nullptr;
  StatusLine* statusLine_ = nullptr;
  WorkBar* work_ = nullptr;
  QSplitter *columns_ = nullptr, *rows_ = nullptr;
  QLabel* sourceLabel_ = nullptr;
  QTabWidget* left_ = nullptr;
  ScenePanel* scene_ = nullptr;
  Flight* flight_ = nullptr;
  FlightBar* flightBar_ = nullptr;
  bool selectsPicked_ = false; ///< the object at the probe, once it is known
  bool reveals_ = false;       ///< the next pick is of the selected object
  FigureHistory figures_;      ///< for the timeline
  Menus* menus_ = nullptr;
  SessionKeeper* keeper_ = nullptr;
  Exports* exports_ = nullptr;
  Drags* drags_ = nullptr;
  StateWatch *viewsWatch_ = nullptr, *timelineWatch_ = nullptr;
  QElapsedTimer workEnded_;
  ShaderWatch* shaders_ = nullptr; ///< null: they come from the program itself
};

} // namespace taa::app
