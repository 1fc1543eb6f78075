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
  /// Lies over the upper edge of `over`.
  explicit WorkBar(QWidget* over);

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

  QLabel* label_;
  QTimer delay_;
  double fraction_ = 0.0;
};

} // namespace taa::app
