#include "app/panels/StatusLine.h"

#include "app/Icons.h"
#include "app/Theme.h"

#include "core/render/SceneRenderer.h"

#include <QHBoxLayout>
#include <QLabel>

namespace taa::app {

namespace {

/// "rendered at 640 × 360 · " where that is not the picture's size.
QString drawnText(const Status& status) {
  if (!isUpsampled(status.settings)) return {};
  const glm::ivec2 drawn = drawnSize({status.width, status.height}, status.settings.inputs.renderScale);
  return StatusLine::tr("rendered at %1 × %2 · ").arg(drawn.x).arg(drawn.y);
}

/// Why the picture is not what is wished for; empty when it is.
QString cautionText(const Status& status) {
  if (status.goal)
    return StatusLine::tr("frame %1 until %2 is there").arg(status.info.frame).arg(*status.goal);
  return status.exact ? QString() : StatusLine::tr("history from old settings");
}

} // namespace

StatusLine::StatusLine(QWidget* parent)
    : QWidget(parent), hover_(new QLabel), driver_(new QLabel), times_(new QLabel), badgeIcon_(new QLabel),
      badge_(new QLabel) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 0);
  layout->setSpacing(3 * kUnit);
  hover_->setFont(numberFont());
  times_->setFont(numberFont());
  driver_->setFont(secondaryFont());
  badge_->setFont(secondaryFont());
  for (QLabel* label : {hover_, driver_, times_, badge_}) label->setMinimumWidth(0);
  hover_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout->addWidget(hover_, 1);
  layout->addWidget(driver_);
  layout->addWidget(times_);
  auto* pair = new QHBoxLayout;
  pair->setSpacing(kUnit);
  pair->addWidget(badgeIcon_);
  pair->addWidget(badge_);
  layout->addLayout(pair);
  setFixedHeight(24);
  times_->setToolTip(tr("Time of the last frame: drawing the scene, and the resolve"));
  badge_->setToolTip(
      tr("Whether the picture is exactly what these settings give from frame 0 on. "
         "After a change the old history is used until it has been made anew, and on the way to a "
         "frame the nearest one that was kept is shown."));
  refreshBadge({});
}

void StatusLine::setHover(const QString& text) {
  hover_->setText(text);
}

void StatusLine::setStatus(const Status& status) {
  driver_->setText(status.driver.isSoftware ? tr("software renderer") : QString());
  driver_->setToolTip(QString::fromStdString(status.driver.renderer));
  if (status.frameCount > 0)
    times_->setText(drawnText(status) + tr("scene %1 ms · resolve %2 ms")
                                            .arg(status.times.scene, 0, 'f', 1)
                                            .arg(status.times.resolve, 0, 'f', 1));
  if (const QString caution = cautionText(status); caution != caution_) refreshBadge(caution);
}

void StatusLine::refreshBadge(const QString& caution) {
  caution_ = caution;
  const bool exact = caution.isEmpty();
  const ThemeColors& colors = themeColors(this);
  badge_->setText(exact ? tr("history from these settings") : caution);
  badgeIcon_->setPixmap(exact
                            ? iconPixmap(QStringLiteral("right"), colors.right, 14, devicePixelRatioF())
                            : iconPixmap(QStringLiteral("caution"), colors.caution, 14, devicePixelRatioF()));
}

QString StatusLine::hover() const {
  return hover_->text();
}

bool StatusLine::showsBadge() const {
  return !caution_.isEmpty();
}

} // namespace taa::app
