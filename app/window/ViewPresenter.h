// Tells the session what the views want, and hands them the pictures; says what is under the mouse.
#pragma once

#include <QObject>

namespace taa::app {

class PipelinePanel;
class Session;
class StatusLine;
class ViewArea;

class ViewPresenter : public QObject {
  Q_OBJECT
 public:
  ViewPresenter(Session& session, ViewArea& views, PipelinePanel& pipeline, StatusLine& statusLine);

 private:
  void request();
  void showPicture(int view);
  void markShown();

  Session& session_;
  ViewArea& views_;
  PipelinePanel& pipeline_;
  StatusLine& statusLine_;
};

} // namespace taa::app
