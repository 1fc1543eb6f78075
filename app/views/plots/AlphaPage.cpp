#include "app/views/plots/AlphaPage.h"

#include "app/style/Theme.h"
#include "app/widgets/Note.h"

#include <QHideEvent>
#include <QLabel>
#include <QShowEvent>

namespace taa::app {

namespace {
constexpr int kHistoryRefresh = 100; ///< ms
} // namespace

AlphaPage::AlphaPage(QWidget* parent) : QWidget(parent), summary_(makeNote()) {
  refresh_.setSingleShot(true);
  refresh_.setInterval(kHistoryRefresh);
  connect(&refresh_, &QTimer::timeout, this, [this] {
    if (isVisible()) refresh();
  });
}

QLabel* AlphaPage::makeNote() {
  QLabel* label = newNote();
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QString AlphaPage::stillNote() {
  return tr("Where the surface moves, its history came from other pixels: the page Lineage follows it.");
}

void AlphaPage::setSeries(const AlphaSeries& series) {
  series_ = series;
  if (isVisible() && !refresh_.isActive()) refresh_.start();
}

void AlphaPage::setSummary(const QStringList& parts, QChar between) {
  summary_->setText(parts.join(between));
}

QString AlphaPage::summary() const {
  return summary_->text();
}

void AlphaPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (event->spontaneous()) return;
  refresh();
  Q_EMIT shownChanged(true);
}

void AlphaPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!event->spontaneous()) Q_EMIT shownChanged(false);
}

} // namespace taa::app
