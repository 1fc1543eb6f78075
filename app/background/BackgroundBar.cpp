#include "app/background/BackgroundBar.h"

#include "app/background/BackgroundWork.h"
#include "app/style/Theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace taa::app {

BackgroundBar::BackgroundBar(BackgroundWork& work, const QString& startText, QWidget* parent)
    : QWidget(parent), work_(work), startText_(startText), start_(new QPushButton(startText)),
      progress_(new QProgressBar), note_(new QLabel), lines_(new QVBoxLayout(this)), line_(new QHBoxLayout) {
  lines_->setContentsMargins(0, 0, 0, 0);
  lines_->setSpacing(kUnit);
  lines_->addLayout(line_);
  line_->setSpacing(2 * kUnit);
  progress_->setTextVisible(false);
  progress_->setMinimumWidth(10 * kUnit);
  progress_->setMaximumWidth(40 * kUnit);
  progress_->setVisible(false);
  note_->setWordWrap(true);
  start_->setAutoDefault(false);
  line_->addWidget(start_);
  line_->addWidget(progress_);
  line_->addWidget(note_, 1);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(start_, &QPushButton::clicked, this, [this] {
    if (work_.isRunning())
      work_.cancel();
    else
      Q_EMIT startRequested();
  });
  connect(&work_, &BackgroundWork::progressed, this, [this](const QString& what, int done, int total) {
    note_->setText(tr("%1: %2 of %3").arg(what).arg(done).arg(total));
    progress_->setRange(0, total);
    progress_->setValue(done);
  });
}

QPushButton* BackgroundBar::addButton(const QString& text, const QString& accessibleName) {
  auto* button = new QPushButton(text);
  button->setAccessibleName(accessibleName);
  button->setAutoDefault(false);
  line_->addWidget(button);
  return button;
}

void BackgroundBar::placeNote() {
  constexpr int kLeastLetters = 24;
  int room = width() - contentsMargins().left() - contentsMargins().right();
  for (int i = 0; i < line_->count(); ++i)
    if (const QWidget* beside = line_->itemAt(i)->widget(); beside != note_ && !beside->isHidden())
      room -= beside->sizeHint().width() + line_->spacing();
  const bool isBelow = lines_->indexOf(note_) >= 0;
  if ((room < kLeastLetters * fontMetrics().averageCharWidth()) == isBelow) return;
  if (isBelow) {
    lines_->removeWidget(note_);
    line_->insertWidget(line_->indexOf(progress_) + 1, note_, 1);
  } else {
    line_->removeWidget(note_);
    lines_->addWidget(note_);
  }
}

bool BackgroundBar::event(QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) placeNote();
  return QWidget::event(event);
}

void BackgroundBar::setReady(bool canStart, const QString& note) {
  const bool isRunning = work_.isRunning();
  start_->setText(isRunning ? tr("Stop") : startText_);
  start_->setEnabled(isRunning || canStart);
  if (isRunning != !progress_->isHidden()) progress_->setVisible(isRunning);
  if (!isRunning) note_->setText(note);
}

void BackgroundBar::setNote(const QString& note) {
  note_->setText(note);
}

QString BackgroundBar::note() const {
  return note_->text();
}

} // namespace taa::app
