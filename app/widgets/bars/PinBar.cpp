#include "app/widgets/bars/PinBar.h"

#include "app/style/Theme.h"
#include "app/widgets/parameters/SegmentedButtons.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace taa::app {

PinBar::PinBar(QWidget* parent) : QWidget(parent) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 2 * kUnit);
  line->setSpacing(0);
  for (int pin = 0; pin < kMaxPins; ++pin) {
    auto* button = new QToolButton;
    button->setText(QString::number(pin + 1));
    button->setFont(numberFont());
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setAccessibleName(tr("Probe %1").arg(pin + 1));
    button->setToolTip(tr("Probe %1 (J: the next one); Shift+right click pins another").arg(pin + 1));
    connect(button, &QToolButton::clicked, this, [this, pin] { Q_EMIT pinChosen(pin); });
    line->addWidget(button);
    buttons_[static_cast<std::size_t>(pin)] = button;
  }
  line->addStretch(1);
  follow_ = new SegmentedButtons({tr("Screen"), tr("Surface")});
  follow_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  follow_->setAccessibleName(tr("What the probe follows"));
  setWhyNoSurfaces({});
  connect(follow_, &SegmentedButtons::chosen, this,
          [this](int index) { Q_EMIT followChosen(static_cast<Follow>(index)); });
  line->addWidget(follow_);
}

void PinBar::setWhyNoSurfaces(const QString& whyNot) {
  follow_->setEnabled(whyNot.isEmpty());
  follow_->setExplanations({tr("Stays on this pixel of the screen"),
                            whyNot.isEmpty()
                                ? tr("Stays on the point of the surface that is here now, wherever it goes")
                                : whyNot});
}

void PinBar::setPins(const std::vector<ProbePin>& pins, int active) {
  for (std::size_t pin = 0; pin < buttons_.size(); ++pin) {
    buttons_[pin]->setVisible(pin < pins.size());
    buttons_[pin]->setChecked(static_cast<int>(pin) == active);
  }
  if (active >= 0) follow_->setCurrent(static_cast<int>(pins[static_cast<std::size_t>(active)].follow));
}

} // namespace taa::app
