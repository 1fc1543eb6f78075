// Keeps the probe's panel and the marks in the views up to date, and does what they ask for.
#pragma once

#include <QObject>
#include <QTimer>

namespace taa::app {

class ProbeChoices;
class ProbePanel;
class Session;
class ViewArea;

class ProbePresenter : public QObject {
  Q_OBJECT
 public:
  ProbePresenter(Session& session, ViewArea& views, ProbePanel& panel);

 private:
  void connectWhatIf();
  void showActive();
  void showProbe();
  void showGlimpse();
  void askForOtherSide();

  Session& session_;
  ProbeChoices& probes_;
  ViewArea& views_;
  ProbePanel& panel_;
  QTimer late_; ///< runs out when the values at a new place are not there at once
};

} // namespace taa::app
