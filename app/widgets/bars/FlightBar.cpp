#include "app/widgets/bars/FlightBar.h"

#include "app/style/Theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace taa::app {

FlightBar::FlightBar(QWidget* over, int bottom)
    : QFrame(over), bottom_(bottom), label_(new QLabel), record_(new QPushButton) {
  setObjectName(QStringLiteral("popup"));
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Flying the camera"));
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(2 * kUnit, kUnit, kUnit, kUnit);
  line->setSpacing(kUnit);
  label_->setFont(secondaryFont());
  line->addWidget(label_);
  const auto add = [&](QPushButton* button, const QString& toolTip, void (FlightBar::*signal)()) {
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    button->setAutoDefault(false);
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QPushButton::clicked, this, signal);
    line->addWidget(button);
  };
  add(record_, tr("Play, and keep where the camera is in each frame as a camera (Ctrl+Shift+R)"),
      &FlightBar::recordRequested);
  add(new QPushButton(tr("Back")), tr("Back to the camera that was left (Backspace)"),
      &FlightBar::resetRequested);
  add(new QPushButton(tr("End")), tr("End the flight and stay here (Esc)"), &FlightBar::endRequested);
  over->installEventFilter(this);
  hide();
}

void FlightBar::setFlight(bool isOn, double speed) {
  speed_ = speed;
  showText();
  setVisible(isOn);
  if (isOn) place();
}

void FlightBar::setRecording(std::optional<std::pair<int, double>> recorded) {
  recorded_ = recorded;
  showText();
  if (isVisible()) place();
}

void FlightBar::showText() {
  const QString doing =
      recorded_
          ? tr("● Recording: %n frames, %1 s", nullptr, recorded_->first).arg(recorded_->second, 0, 'f', 2)
          : tr("Flying");
  label_->setText(tr("%1  W A S D Q E: move   drag: look   wheel: %2 a second   Shift: faster   Ctrl: slower")
                      .arg(doing, QString::number(speed_, 'g', 2)));
  record_->setText(recorded_ ? tr("Stop recording") : tr("Record"));
}

QString FlightBar::text() const {
  return label_->text();
}

void FlightBar::place() {
  const QWidget* over = parentWidget();
  const QSize size = sizeHint().boundedTo({over->width(), over->height()});
  setGeometry((over->width() - size.width()) / 2, over->height() - bottom_ - size.height(), size.width(),
              size.height());
  raise();
}

bool FlightBar::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return false;
}

} // namespace taa::app
