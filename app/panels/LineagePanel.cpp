#include "app/panels/LineagePanel.h"

#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/plots/FootprintView.h"
#include "app/views/plots/LineageBars.h"
#include "app/widgets/areas/FittingArea.h"

#include "core/verdict/lineage/LineageWords.h"

#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QShowEvent>

#include <string>

namespace taa::app {

LineagePanel::LineagePanel(QWidget* parent)
    : QWidget(parent), bars_(new LineageBars), footprint_(new FootprintView), summary_(new QLabel) {
  summary_->setFont(secondaryFont());
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  columns->setSpacing(4 * kUnit);
  columns->addWidget(bars_, 6);
  columns->addWidget(footprint_, 4);
  summary_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  columns->addWidget(scrolled(summary_), 5);
  connect(bars_, &LineageBars::hovered, this, &LineagePanel::highlight);
  connect(footprint_, &FootprintView::hovered, this, &LineagePanel::highlight);
  connect(bars_, &LineageBars::chosen, this, &LineagePanel::seekRequested);
  connect(footprint_, &FootprintView::chosen, this, &LineagePanel::seekRequested);
  describe();
}

void LineagePanel::show(bool isProbed, const std::optional<LineageDelivery>& delivery, bool isCurrent) {
  const bool isOther = lineage() != (delivery ? delivery->lineage : nullptr);
  const auto frameOf = [](const auto& known) { return known ? std::optional(known->frame) : std::nullopt; };
  const bool isSaid =
      !isOther && isProbed == isProbed_ && isCurrent == isCurrent_ && frameOf(delivery) == frameOf(delivery_);
  if (isSaid) return;
  delivery_ = delivery;
  isProbed_ = isProbed;
  isCurrent_ = isCurrent;
  if (isOther) {
    bars_->setLineage(lineage());
    footprint_->setLineage(lineage());
  }
  describe();
}

void LineagePanel::highlight(std::optional<int> frame) {
  bars_->setHighlighted(frame);
  footprint_->setHighlighted(frame);
}

void LineagePanel::describe() {
  if (!isProbed_) {
    summary_->setText(tr("Right-click a pixel: the samples that it is made of are drawn here."));
    return;
  }
  if (!delivery_) {
    summary_->setText(tr("Its samples are being followed."));
    return;
  }
  const std::shared_ptr<const Lineage> lineage = this->lineage();
  if (!lineage) {
    summary_->setText(tr("The probe is not in the picture of frame %1.").arg(delivery_->frame));
    return;
  }
  const QString place =
      tr("Pixel (%1, %2) of frame %3").arg(lineage->pixel.x).arg(lineage->pixel.y).arg(lineage->frame);
  QStringList lines{isCurrent_ ? place : tr("%1, which is no longer on show").arg(place)};
  for (const std::string& clause : lineageSentences(*lineage)) lines << sentence(clause);
  summary_->setText(lines.join(QLatin1Char('\n')));
}

QString LineagePanel::summary() const {
  return summary_->text();
}

void LineagePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!event->spontaneous()) Q_EMIT shownChanged(true);
}

void LineagePanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!event->spontaneous()) Q_EMIT shownChanged(false);
}

} // namespace taa::app
