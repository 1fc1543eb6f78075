// Numbers and names that are typed: a pixel, a frame, a size, the name of a mark.
#pragma once

#include <QObject>

class QWidget;

namespace taa::app {

class Session;
class TimelinePanel;
class ViewArea;

class GoToPrompts : public QObject {
  Q_OBJECT
 public:
  /// They open over `window`.
  GoToPrompts(Session& session, ViewArea& views, TimelinePanel& timeline, QWidget* window);

  void askForPixel();
  /// Of the active view, to describe its values; nothing typed removes it.
  void askForRegion();
  void askForFrame();
  void askForLength();
  void askForSize();
  void askForMarkName();

 private:
  Session& session_;
  ViewArea& views_;
  TimelinePanel& timeline_;
  QWidget* window_;
};

} // namespace taa::app
