#include "app/widgets/bars/ProbeBar.h"

#include "app/style/Theme.h"
#include "app/widgets/parameters/SegmentedButtons.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace taa::app {

ProbeBar::ProbeBar(QWidget* parent) : QWidget(parent) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 2 * kUnit);
  line->setSpacing(0);
  for (int probe = 0; probe < kMaxProbes; ++probe) {
    auto* button = new QToolButton;
    button->setText(QString::number(probe + 1));
    button->setFont(numberFont());
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setAccessibleName(tr("Probe %1").arg(probe + 1));
    button->setToolTip(tr("Probe %1 (J: the next one); Shift+right click sets another").arg(probe + 1));
    connect(button, &QToolButton::clicked, this, [this, probe] { Q_EMIT probeChosen(probe); });
    line->addWidget(button);
    buttons_[static_cast<std::size_t>(probe)] = button;
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

void ProbeBar::setWhyNoSurfaces(const QString& whyNot) {
  follow_->setEnabled(whyNot.isEmpty());
  follow_->setExplanations({tr("Stays on this pixel of the screen"),
                            whyNot.isEmpty()
                                ? tr("Stays on the point of the surface that is here now, wherever it goes")
                                : whyNot});
}

void ProbeBar::setProbes(const std::vector<Probe>& probes, int active) {
  for (std::size_t probe = 0; probe < buttons_.size(); ++probe) {
    buttons_[probe]->setVisible(probe < probes.size());
    buttons_[probe]->setChecked(static_cast<int>(probe) == active);
  }
  if (active >= 0) follow_->setCurrent(static_cast<int>(probes[static_cast<std::size_t>(active)].follow));
}

} // namespace taa::app
