// Keeps the verdict in the probe's panel up to date, and does what its buttons say.
#pragma once

#include <QObject>

namespace taa::app {

class ProbePanel;
class Session;
class ViewArea;

class VerdictPresenter : public QObject {
  Q_OBJECT
 public:
  VerdictPresenter(Session& session, ViewArea& views, ProbePanel& panel);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void show();
  void showSentence();
  void showWork();
  bool isExpected() const;

  Session& session_;
  ViewArea& views_;
  ProbePanel& panel_;
};

} // namespace taa::app
