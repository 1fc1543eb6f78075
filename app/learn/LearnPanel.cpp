#include "app/learn/LearnPanel.h"

#include "app/learn/LessonText.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/Line.h"
#include "core/lessons/LessonHtml.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <string>

namespace taa::app {

namespace {

/// A line of the answer; hints are Markdown, as the text of the step is.
QString answerLine(const std::string& html) {
  return qtext(html).replace(QLatin1String("<p>"), QLatin1String("<p style=\"margin:0\">"));
}
QString plainLine(const QString& text) {
  return answerLine("<p>" + text.toHtmlEscaped().toStdString() + "</p>");
}

} // namespace

LearnPanel::LearnPanel(QWidget* parent) : QWidget(parent) {
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  setAccessibleName(tr("Learn"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, 2 * kUnit, 2 * kUnit, 2 * kUnit);
  layout->setSpacing(kUnit);
  makeHead();
  text_ = new LessonText;
  text_->setAccessibleName(tr("Text of the step"));
  layout->addWidget(text_, 1);
  makeFoot();
  hide();
}

void LearnPanel::makeHead() {
  lessons_ = new QComboBox;
  lessons_->setAccessibleName(tr("Lesson"));
  lessons_->view()->setAccessibleName(lessons_->accessibleName());
  lessons_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  close_ = new IconButton(QStringLiteral("close"), tr("Close the page Learn; Help, Learn opens it again"));
  title_ = new QLabel;
  title_->setFont(titleFont());
  title_->setWordWrap(true);
  place_ = new QLabel;
  place_->setFont(secondaryFont());
  place_->setForegroundRole(QPalette::PlaceholderText);
  auto* first = new QHBoxLayout;
  first->addWidget(lessons_, 1);
  first->addWidget(close_);
  auto* second = new QHBoxLayout;
  second->addWidget(title_, 1);
  second->addWidget(place_, 0, Qt::AlignTop);
  auto* rows = qobject_cast<QVBoxLayout*>(layout());
  rows->addLayout(first);
  rows->addLayout(second);
  connect(lessons_, &QComboBox::activated, this, &LearnPanel::lessonChosen);
  connect(close_, &QToolButton::clicked, this, &LearnPanel::closeRequested);
}

void LearnPanel::makeFoot() {
  answer_ = new QLabel;
  answer_->setWordWrap(true);
  answer_->setTextFormat(Qt::RichText);
  answer_->setAccessibleName(tr("What became of the task"));
  back_ = new QPushButton(tr("Back"));
  next_ = new QPushButton(tr("Next"));
  return_ = new QPushButton(tr("Return to the step"));
  return_->setToolTip(tr("Sets scene, frame, settings and views as the step has them"));
  check_ = new QPushButton(tr("Check"));
  check_->setToolTip(tr("Whether what is open now is what the step asks for"));
  hint_ = new QPushButton(tr("Hint"));
  auto* task = new QHBoxLayout;
  task->addWidget(check_);
  task->addWidget(hint_);
  task->addStretch(1);
  auto* way = new QHBoxLayout;
  way->addWidget(back_);
  way->addWidget(next_);
  way->addStretch(1);
  way->addWidget(return_);
  auto* rows = qobject_cast<QVBoxLayout*>(layout());
  rows->addWidget(answer_);
  rows->addLayout(task);
  rows->addWidget(new Line);
  rows->addLayout(way);
  connect(back_, &QPushButton::clicked, this, [this] { Q_EMIT stepChosen(step_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] { Q_EMIT stepChosen(step_ + 1); });
  connect(return_, &QPushButton::clicked, this, &LearnPanel::returnRequested);
  connect(check_, &QPushButton::clicked, this, &LearnPanel::checkRequested);
  connect(hint_, &QPushButton::clicked, this, &LearnPanel::hintRequested);
}

void LearnPanel::setLessons(const QStringList& titles, int current) {
  const QSignalBlocker quiet(lessons_);
  lessons_->clear();
  lessons_->addItems(titles);
  lessons_->setCurrentIndex(current);
}

void LearnPanel::setStep(const Lesson& lesson, int step, const StepNotes& notes) {
  step_ = step;
  const LessonStep& shown = lesson.steps.at(static_cast<std::size_t>(step));
  title_->setText(qtext(shown.title));
  place_->setText(tr("%1 of %2").arg(step + 1).arg(lesson.steps.size()));
  text_->setText(qtext(step == 0 ? lesson.summary + "\n" + shown.text : shown.text));
  back_->setEnabled(step > 0);
  // After the last step the next lesson comes, where there is one.
  const bool isLast = step + 1 == static_cast<int>(lesson.steps.size());
  next_->setText(isLast ? tr("Next lesson") : tr("Next"));
  next_->setEnabled(!isLast || lessons_->currentIndex() + 1 < lessons_->count());
  showTask(shown, notes);
}

void LearnPanel::showTask(const LessonStep& step, const StepNotes& notes) {
  const bool hasTask = step.task.has_value();
  check_->setVisible(hasTask);
  check_->setEnabled(!notes.isChecking);
  const int hints = hasTask ? static_cast<int>(step.task->hints.size()) : 0;
  hint_->setVisible(hasTask && !notes.isSolutionShown);
  hint_->setText(notes.hints < hints ? tr("Hint") : tr("Show the solution"));
  QStringList lines;
  for (int hint = 0; hint < std::min(notes.hints, hints); ++hint)
    lines << answerLine(htmlOfMarkdown(
        tr("Hint: %1").arg(qtext(step.task->hints[static_cast<std::size_t>(hint)])).toStdString()));
  if (notes.isChecking)
    lines << plainLine(tr("Checking…"));
  else if (!notes.answer.isEmpty())
    lines << plainLine(notes.answer);
  else if (notes.isDone)
    lines << plainLine(tr("Solved."));
  answer_->setText(lines.join(QString()));
  answer_->setVisible(!lines.isEmpty());
}

} // namespace taa::app
