#include "app/panels/TimelinePanel.h"

#include "app/Theme.h"
#include "app/views/Timeline.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/NumberField.h"

#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace taa::app {

namespace {

QString minus(QString text) {
  return text.replace(QLatin1Char('-'), QChar(0x2212));
}

} // namespace

TimelinePanel::TimelinePanel(QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  layout->setSpacing(2);
  makeButtons();
  timeline_ = new Timeline;
  connect(timeline_, &Timeline::seekRequested, this, &TimelinePanel::seekRequested);
  connect(timeline_, &Timeline::stepRequested, this, &TimelinePanel::stepRequested);
  layout->addSpacing(2 * kUnit);
  layout->addWidget(timeline_, 1);
  layout->addSpacing(2 * kUnit);
  makeReadouts();
}

void TimelinePanel::makeButtons() {
  const auto add = [this](const char* icon, const QString& tip, auto act) {
    auto* button = new IconButton(QLatin1String(icon), tip);
    connect(button, &IconButton::clicked, this, act);
    static_cast<QHBoxLayout*>(layout())->addWidget(button);
    return button;
  };
  add("first", tr("First frame (Home)"), [this] { Q_EMIT seekRequested(0); });
  add("previous", tr("One frame back (,)"), [this] { Q_EMIT stepRequested(-1); });
  play_ = add("play", tr("Play or pause (Space)"), [this] { Q_EMIT playToggled(); });
  play_->setObjectName(QStringLiteral("play"));
  add("next", tr("One frame on (.)"), [this] { Q_EMIT stepRequested(1); });
  add("last", tr("Last frame (End)"), [this] { Q_EMIT seekRequested(std::max(0, frameCount_ - 1)); });
  loop_ =
      add("loop", tr("Start again at the end (Ctrl+L)"), [this] { Q_EMIT loopToggled(loop_->isChecked()); });
  loop_->setCheckable(true);
}

QLabel* TimelinePanel::makeReadout(const QString& widest) {
  auto* label = new QLabel;
  label->setFont(numberFont());
  label->setMinimumWidth(QFontMetrics(numberFont()).horizontalAdvance(widest) + kUnit);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  layout()->addWidget(label);
  return label;
}

void TimelinePanel::makeReadouts() {
  auto* name = new QLabel(tr("frame"));
  name->setFont(secondaryFont());
  layout()->addWidget(name);
  frame_ = new NumberField({0, 1, true});
  frame_->setObjectName(QStringLiteral("frame"));
  frame_->setToolTip(tr("Go to a frame (G)"));
  frame_->setMaximumWidth(56);
  connect(frame_, &NumberField::valueEdited, this,
          [this](double value) { Q_EMIT seekRequested(static_cast<int>(value)); });
  layout()->addWidget(frame_);
  count_ = makeReadout(QStringLiteral("of 000"));
  count_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  jitter_ = makeReadout(QStringLiteral("jitter 16 of 16 (−0.00, −0.00)"));
  jitter_->setToolTip(
      tr("Place in the jitter pattern, and the displacement of the picture in px (x right, y down)"));
  time_ = makeReadout(QStringLiteral("t = 00.000 s"));
}

void TimelinePanel::setStatus(const Status& status) {
  frameCount_ = status.frameCount;
  timeline_->setFrameCount(status.frameCount);
  const int frame = status.goal.value_or(status.info.frame); // stays under the mouse
  timeline_->setFrame(frame);
  play_->setIconName(status.playing ? QStringLiteral("pause") : QStringLiteral("play"));
  frame_->setScale({0, std::max(1.0, status.frameCount - 1.0), true});
  frame_->setValue(frame);
  count_->setText(tr("of %1").arg(status.frameCount));
  const FrameInfo& info = status.info;
  jitter_->setText(status.jitterPeriod > 1
                       ? tr("jitter %1 of %2 (%3, %4)")
                             .arg(info.jitterIndex)
                             .arg(status.jitterPeriod)
                             .arg(minus(QString::number(static_cast<double>(info.jitterPx.x), 'f', 2)),
                                  minus(QString::number(static_cast<double>(info.jitterPx.y), 'f', 2)))
                       : tr("no jitter"));
  time_->setText(tr("t = %1 s").arg(info.time, 0, 'f', 3));
}

void TimelinePanel::setLooping(bool looping) {
  loop_->setChecked(looping);
}

QString TimelinePanel::readout() const {
  return QStringLiteral("frame %1 %2  %3  %4")
      .arg(QString::number(frame_->value()), count_->text(), jitter_->text(), time_->text());
}

} // namespace taa::app
