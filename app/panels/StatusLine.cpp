#include "app/panels/StatusLine.h"

#include "app/style/Icons.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/bars/ElidedLabel.h"

#include "core/render/CaptureFacts.h"
#include "core/render/FrameInputs.h"
#include "core/requests/RequestKinds.h"
#include "core/settings/Faults.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QStringList>

#include <string>
#include <vector>

namespace taa::app {

namespace {

/// "rendered at 640 × 360 · " where that is not the picture's size.
QString drawnText(const Status& status) {
  const glm::ivec2 picture(status.width, status.height);
  const glm::ivec2 drawn =
      status.capture ? status.capture->renderPx : drawnSize(picture, status.settings.inputs.renderScale);
  if (drawn == picture) return {};
  return StatusLine::tr("rendered at %1 × %2 · ").arg(drawn.x).arg(drawn.y);
}

/// What the history of a picture that is not exact is of.
QString historyText(const Status& status) {
  if (status.inexactSince.empty()) return StatusLine::tr("history not exact yet");
  switch (onlyCause(status.inexactSince).value_or(RequestKind::None)) {
  case RequestKind::Settings:
    return StatusLine::tr("history from old settings");
  case RequestKind::Camera:
    return StatusLine::tr("no history of this camera yet");
  case RequestKind::Size:
    return StatusLine::tr("no history of this size yet");
  case RequestKind::MotionModes:
    return StatusLine::tr("history with the old motion of objects");
  case RequestKind::Objects:
    return StatusLine::tr("history with the objects drawn before");
  case RequestKind::Classes:
    return StatusLine::tr("history with the old classes of objects");
  case RequestKind::Restarts:
    return StatusLine::tr("history with the old starts");
  case RequestKind::Shaders:
    return StatusLine::tr("history from old shaders");
  default:
    return StatusLine::tr("history from before several changes");
  }
}

/// What is wrong on purpose; empty: nothing.
QString faultsText(const Status& status, bool areNamed) {
  const std::vector<std::string> faults = injectedFaults(status.settings);
  if (faults.empty()) return {};
  const QString first = qtext(faults.front());
  const int more = static_cast<int>(faults.size()) - 1;
  if (!areNamed) return StatusLine::tr("fault injected: find it");
  return more == 0 ? StatusLine::tr("fault injected: %1").arg(first)
                   : StatusLine::tr("faults injected: %1 and %2 more").arg(first).arg(more);
}

/// Why the picture is not what is wished for; empty when it is.
QString cautionText(const Status& status, bool areFaultsNamed) {
  QStringList texts;
  if (status.goal)
    texts << StatusLine::tr("frame %1 until %2 is there").arg(status.info.frame).arg(*status.goal);
  else if (!status.exact)
    texts << historyText(status);
  if (const QString faults = faultsText(status, areFaultsNamed); !faults.isEmpty()) texts << faults;
  return texts.join(QStringLiteral(" · "));
}

} // namespace

StatusLine::StatusLine(QWidget* parent)
    : QWidget(parent), hover_(new QLabel), driver_(new ElidedLabel), times_(new ElidedLabel),
      badgeIcon_(new QLabel), badge_(new ElidedLabel) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 0);
  layout->setSpacing(3 * kUnit);
  hover_->setObjectName(QStringLiteral("hover"));
  hover_->setFont(numberFont());
  times_->setFont(numberFont());
  driver_->setFont(secondaryFont());
  badge_->setFont(secondaryFont());
  hover_->setMinimumWidth(0);
  hover_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout->addWidget(hover_, 1);
  layout->addWidget(driver_);
  layout->addWidget(times_);
  auto* pair = new QHBoxLayout;
  pair->setSpacing(kUnit);
  pair->addWidget(badgeIcon_);
  pair->addWidget(badge_);
  layout->addLayout(pair);
  setFixedHeight(scaled(24));
  times_->setTip(
      tr("Time of the last frame by the clock: drawing the scene, and the resolve. Both hold what lies "
         "between their passes; the profiler times each pass alone and has that in its own row."));
  badge_->setTip(tr("Whether the picture is exactly what these settings give from frame 0 on. "
                    "After a change the old history is used until it has been made anew, and on the way to a "
                    "frame the nearest one that was kept is shown."));
  refreshBadge();
}

void StatusLine::setFaultsNamed(bool areNamed) {
  areFaultsNamed_ = areNamed;
  refreshBadge();
}

void StatusLine::setHover(const QString& text) {
  hover_->setText(text);
}

void StatusLine::setStatus(const Status& status) {
  driver_->setWhole(status.driver.isSoftware ? tr("software renderer") : QString());
  driver_->setTip(QString::fromStdString(status.driver.renderer));
  if (status.frameCount > 0)
    times_->setWhole(drawnText(status) + tr("scene %1 ms · resolve %2 ms")
                                             .arg(status.times.scene, 0, 'f', 1)
                                             .arg(status.times.resolve, 0, 'f', 1));
  status_ = status;
  refreshBadge();
}

void StatusLine::setPicture(std::uint64_t shotVersion) {
  if (shotVersion <= shotVersion_) return;
  shotVersion_ = shotVersion;
  refreshBadge();
}

// A picture may be here before its status, but only where it is exact.
void StatusLine::refreshBadge() {
  if (status_.frameCount == 0) {
    show(Badge::None, {});
    return;
  }
  if (const QString caution = cautionText(status_, areFaultsNamed_); !caution.isEmpty()) {
    show(Badge::Caution, caution);
    return;
  }
  if (shotVersion_ < status_.shotVersion) {
    show(Badge::None, tr("no picture yet"));
    return;
  }
  show(Badge::Exact, tr("history from these settings"));
}

void StatusLine::show(Badge badge, const QString& text) {
  if (badge == shown_ && text == badge_->whole()) return;
  shown_ = badge;
  badge_->setWhole(text);
  badgeIcon_->setVisible(badge != Badge::None);
  drawBadge();
}

void StatusLine::drawBadge() {
  const ThemeColors& colors = themeColors(this);
  if (shown_ == Badge::Exact)
    badgeIcon_->setPixmap(iconPixmap(QStringLiteral("right"), colors.right, scaled(14), devicePixelRatioF()));
  else if (shown_ == Badge::Caution)
    badgeIcon_->setPixmap(
        iconPixmap(QStringLiteral("caution"), colors.caution, scaled(14), devicePixelRatioF()));
}

// A picture grows with the texts beside it.
void StatusLine::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) drawBadge();
}

QString StatusLine::badge() const {
  return badge_->whole();
}

QString StatusLine::hover() const {
  return hover_->text();
}

bool StatusLine::showsBadge() const {
  return shown_ == Badge::Caution;
}

} // namespace taa::app
