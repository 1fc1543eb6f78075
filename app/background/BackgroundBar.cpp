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

BackgroundBar::BackgroundBar(BackgroundWork& work, const QString& startText, NotePlace notePlace,
                             QWidget* parent)
    : QWidget(parent), notePlace_(notePlace), work_(work), startText_(startText),
      start_(new QPushButton(startText)), progress_(new QProgressBar), note_(new QLabel),
      line_(new QHBoxLayout) {
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(kUnit);
  lines->addLayout(line_);
  line_->setSpacing(2 * kUnit);
  progress_->setTextVisible(false);
  progress_->setMinimumWidth(10 * kUnit);
  progress_->setMaximumWidth(40 * kUnit);
  progress_->setVisible(false);
  note_->setWordWrap(true);
  start_->setAutoDefault(false);
  line_->addWidget(start_);
  line_->addWidget(progress_);
  if (notePlace == NotePlace::Beside)
    line_->addWidget(note_, 1);
  else
    lines->addWidget(note_);
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

QSize BackgroundBar::minimumSizeHint() const {
  const QSize least = QWidget::minimumSizeHint();
  return notePlace_ == NotePlace::Beside ? least : QSize(start_->sizeHint().width(), least.height());
}

bool BackgroundBar::event(QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) arrange();
  return QWidget::event(event);
}

void BackgroundBar::arrange() {
  if (notePlace_ == NotePlace::Beside) return;
  const auto direction =
      buttonsWidth() > contentsRect().width() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
  if (line_->direction() != direction) line_->setDirection(direction);
}

int BackgroundBar::buttonsWidth() const {
  int width = -line_->spacing();
  for (int item = 0; item < line_->count(); ++item)
    if (!line_->itemAt(item)->isEmpty()) width += line_->itemAt(item)->sizeHint().width() + line_->spacing();
  return width;
}

QString BackgroundBar::note() const {
  return note_->text();
}

} // namespace taa::app
