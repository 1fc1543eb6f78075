// What can be done while the camera is flown, over the lower edge of the views.
#pragma once

#include <QFrame>

#include <optional>
#include <utility>

class QLabel;
class QPushButton;

namespace taa::app {

class FlightBar : public QFrame {
  Q_OBJECT
 public:
  /// Lies over `over`, `bottom` px above its lower edge.
  FlightBar(QWidget* over, int bottom);

  /// What is flown, world units a second.
  void setFlight(bool isOn, double speed);
  /// Frames and seconds of a recording so far; nothing: there is none.
  void setRecording(std::optional<std::pair<int, double>> recorded);
  QString text() const;

 Q_SIGNALS:
  void recordRequested();
  void resetRequested();
  void endRequested();

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void place();

  void showText();

  int bottom_;
  double speed_ = 1.0;
  std::optional<std::pair<int, double>> recorded_;
  QLabel* label_;
  QPushButton* record_;
};

} // namespace taa::app
