// What can be done while the camera is flown, over the lower edge of the views.
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace taa::app {

class FlightBar : public QFrame {
  Q_OBJECT
 public:
  /// Lies over `over`, `bottom` px above its lower edge.
  FlightBar(QWidget* over, int bottom);

  /// `speed`: world units a second.
  void setFlight(bool isOn, bool isRecording, double speed);
  QString text() const;

 Q_SIGNALS:
  void recordRequested();
  void resetRequested();
  void endRequested();

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void place();

  int bottom_;
  QLabel* label_;
  QPushButton* record_;
};

} // namespace taa::app
