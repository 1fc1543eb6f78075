// Long work under way: a thin bar at the upper edge of what is worked on, what is left in words, a stop
// button.
#pragma once

#include <QString>
#include <QTimer>
#include <QWidget>

class QLabel;

namespace taa::app {

class WorkBar : public QWidget {
  Q_OBJECT
 public:
  /// Lies over `over`, `top` px below its upper edge.
  WorkBar(QWidget* over, int top);

  /// `what` empty: nothing is under way. Short work never shows.
  void setWork(const QString& what, int done, int total);
  QString text() const;

 Q_SIGNALS:
  void stopRequested();

 protected:
  void paintEvent(QPaintEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void place();
  void uncover();
  QRect words() const; ///< what label and button lie on

  int top_;
  QLabel* label_;
  QTimer delay_;
  double fraction_ = 0.0;
};

} // namespace taa::app
