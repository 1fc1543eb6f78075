#include "app/learn/LearnPanel.h"

#include "app/learn/LessonText.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/Note.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "core/lessons/Ladder.h"
#include "core/lessons/LessonHtml.h"
#include "core/lessons/LessonNumbers.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
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
  makeWay();
  text_ = new LessonText;
  text_->setAccessibleName(tr("Text of the step"));
  connect(text_, &LessonText::rungChosen, this, &LearnPanel::rungChosen);
  layout->addWidget(text_, 1);
  makeTask();
  layout->addStretch();
  hide();
}

void LearnPanel::makeHead() {
  head_ = new QWidget;
  lessons_ = new ChoiceButton;
  lessons_->setObjectName(QStringLiteral("lessons"));
  lessons_->setAccessibleName(tr("Lesson"));
  lessons_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  place_ = new QLabel;
  setSecondary(*place_);
  close_ = new IconButton(QStringLiteral("close"), tr("Close the page Learn; Help, Learn opens it again"));
  auto* row = new QHBoxLayout(head_);
  row->setContentsMargins(2 * kUnit, kUnit, kUnit, kUnit);
  row->setSpacing(2 * kUnit);
  row->addWidget(new QLabel(tr("Learn")));
  row->addWidget(lessons_, 1);
  row->addWidget(place_);
  row->addWidget(close_);
  connect(lessons_, &ChoiceButton::chosen, this, &LearnPanel::lessonChosen);
  connect(close_, &QToolButton::clicked, this, &LearnPanel::closeRequested);
}

// Above the text, which is longer in one step than in the next: so nobody has to look for it.
void LearnPanel::makeWay() {
  back_ = new QPushButton(tr("Back"));
  next_ = new QPushButton(tr("Next"));
  return_ = new QPushButton(tr("Reset"));
  return_->setToolTip(tr("Sets scene, frame, settings and views as the step has them"));
  auto* way = new QHBoxLayout;
  way->addWidget(back_);
  way->addWidget(next_);
  way->addStretch(1);
  way->addWidget(return_);
  qobject_cast<QVBoxLayout*>(layout())->addLayout(way);
  connect(back_, &QPushButton::clicked, this, [this] { Q_EMIT stepChosen(step_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] { Q_EMIT stepChosen(step_ + 1); });
  connect(return_, &QPushButton::clicked, this, &LearnPanel::returnRequested);
}

// Right below the text, however long it is; hints come below the buttons, which stay where they are.
void LearnPanel::makeTask() {
  answer_ = new QLabel;
  answer_->setWordWrap(true);
  answer_->setTextFormat(Qt::RichText);
  answer_->setAccessibleName(tr("What became of the task"));
  check_ = new QPushButton(tr("Check"));
  check_->setToolTip(tr("Whether what is open now is what the step asks for"));
  hint_ = new QPushButton(tr("Hint"));
  measure_ = new QPushButton(tr("Measure"));
  measure_->setToolTip(tr("The numbers that the text rests on: of what is open now, and of the settings that "
                          "it is compared with"));
  auto* task = new QHBoxLayout;
  task->addWidget(check_);
  task->addWidget(hint_);
  task->addWidget(measure_);
  task->addStretch(1);
  auto* rows = qobject_cast<QVBoxLayout*>(layout());
  rows->addLayout(task);
  rows->addWidget(answer_);
  connect(check_, &QPushButton::clicked, this, &LearnPanel::checkRequested);
  connect(hint_, &QPushButton::clicked, this, &LearnPanel::hintRequested);
  connect(measure_, &QPushButton::clicked, this, &LearnPanel::numbersRequested);
}

void LearnPanel::setLessons(const QStringList& titles, int current) {
  lessons_->setChoices(titles);
  lessons_->setCurrent(current);
  lessons_->setCaption(titles.value(current)); // chosen again it begins again
  lessonCount_ = static_cast<int>(titles.size());
}

void LearnPanel::setStep(const Lesson& lesson, int step, const StepNotes& notes) {
  step_ = step;
  const LessonStep& shown = lesson.steps.at(static_cast<std::size_t>(step));
  place_->setText(tr("%1 of %2").arg(step + 1).arg(lesson.steps.size()));
  // Its title goes with the text, which may have room for few lines.
  const std::string title = "## " + shown.title + "\n\n";
  const QString text = qtext(title + (step == 0 ? lesson.summary + "\n" : "") + shown.text + "\n" +
                             ladderMarkdown(shown.ladder, {.isLinked = true}));
  text_->setText(notes.numbers.isEmpty() ? text : text + QStringLiteral("\n\n") + notes.numbers);
  back_->setEnabled(step > 0);
  // After the last step the next lesson comes, where there is one.
  const bool isLast = step + 1 == static_cast<int>(lesson.steps.size());
  next_->setText(isLast ? tr("Next lesson") : tr("Next"));
  next_->setEnabled(!isLast || lessons_->current() + 1 < lessonCount_);
  showTask(shown, notes);
}

void LearnPanel::showTask(const LessonStep& step, const StepNotes& notes) {
  const bool hasTask = step.task.has_value();
  check_->setVisible(hasTask);
  const int hints = hasTask ? static_cast<int>(step.task->hints.size()) : 0;
  hint_->setVisible(hasTask && !notes.isSolutionShown);
  hint_->setText(notes.hints < hints ? tr("Hint") : tr("Show the solution"));
  measure_->setVisible(hasNumbers(step));
  QStringList lines;
  for (int hint = 0; hint < std::min(notes.hints, hints); ++hint)
    lines << answerLine(htmlOfMarkdown(
        tr("Hint: %1").arg(qtext(step.task->hints[static_cast<std::size_t>(hint)])).toStdString()));
  if (notes.isChecking)
    lines << plainLine(hasTask ? tr("Checking…") : tr("Measuring…"));
  else if (!notes.answer.isEmpty())
    lines << plainLine(notes.answer);
  else if (notes.isDone)
    lines << plainLine(tr("Solved."));
  // What is checked has a line from the first, so that nothing moves when it is answered.
  answer_->setText(lines.isEmpty() && hasTask ? plainLine(QStringLiteral("\u00a0")) : lines.join(QString()));
  answer_->setVisible(hasTask || !lines.isEmpty());
  text_->setKeepsEnd(notes.isAsked);
}

} // namespace taa::app
