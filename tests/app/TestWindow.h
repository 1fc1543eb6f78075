// The window with its parts as tests reach them: by what they are, among its children.
#pragma once

#include "app/window/MainWindow.h"

#include <QJsonObject>
#include <QString>

namespace taa::app::test {

class TestWindow : public MainWindow {
 public:
  using MainWindow::MainWindow;

  ViewArea* views() const;
  Workspace* workspace() const;
  LeftArea* left() const;
  PipelinePanel* pipeline() const;
  ScenePanel* scene() const;
  ProbePanel* probe() const;
  LowerArea* lower() const;
  ProfilerPanel* profiler() const;
  PlotsPanel* plots() const;
  JitterPanel* jitter() const;
  WeightsPanel* weights() const;
  LineagePanel* lineage() const;
  DoctorPanel* doctor() const;
  TimelinePanel* timeline() const;
  MessagesBar* messages() const;
  StatusLine* statusLine() const;
  FlightBar* flightBar() const;
  SessionKeeper* keeper() const;
  Exports* exports() const;
  Flight* flight() const;
  OwnPresets* presets() const;
  ProbeCommands* probeCommands() const;
  DoctorCommands* doctorCommands() const;
  GoToPrompts* prompts() const;
  ViewChoices* choices() const;
  CommandLists* lists() const;

  void openSource(const QString& source);
  /// In the active view.
  void showIntermediate(IntermediateId id);
  /// What a session file keeps of the window.
  QJsonObject state() const;
};

} // namespace taa::app::test
