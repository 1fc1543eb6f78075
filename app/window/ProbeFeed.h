// Keeps the probe's panel and the marks in the views up to date, and does what they ask for.
#pragma once

#include <QObject>

namespace taa::app {

class PinnedProbes;
class ProbePanel;
class ViewArea;

class ProbeFeed : public QObject {
  Q_OBJECT
 public:
  ProbeFeed(PinnedProbes& probes, ViewArea& views, ProbePanel& panel);

 private:
  void showPick();
  void showProbe();

  PinnedProbes& probes_;
  ViewArea& views_;
  ProbePanel& panel_;
};

} // namespace taa::app
