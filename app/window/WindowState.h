// The window as JSON: views, probes, panels and layout, for session files and the next start.
#pragma once

#include <QJsonObject>

namespace taa::app {

class LeftArea;
class LowerArea;
class PipelinePanel;
class PlotsPanel;
class ProbePanel;
class ScenePanel;
class Session;
class TimelinePanel;
class ViewArea;
class Workspace;

class WindowState {
 public:
  /// What has a part in it.
  struct Holders {
    Session& session;
    ViewArea& views;
    LeftArea& left;
    PipelinePanel& pipeline;
    ScenePanel& scene;
    ProbePanel& probe;
    LowerArea& lower;
    PlotsPanel& plots;
    TimelinePanel& timeline;
    Workspace& workspace; ///< places the panels
  };
  explicit WindowState(const Holders& of) : of_(of) {}

  QJsonObject capture() const;
  /// What they may make of a state, also of another window; undo notes nothing of it.
  void apply(const QJsonObject& state) const;

 private:
  QJsonObject panels() const;
  void applyPanels(const QJsonObject& panels) const;
  void applySession(const QJsonObject& state) const;

  Holders of_;
};

} // namespace taa::app
