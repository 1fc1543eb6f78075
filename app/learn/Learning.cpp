#include "app/learn/Learning.h"

#include "app/background/LessonWork.h"
#include "app/learn/PartFrame.h"
#include "app/session/Session.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/style/Text.h"
#include "core/settings/Faults.h"

#include <QFileDialog>
#include <QSettings>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string>
#include <utility>

namespace taa::app {

namespace {

QString doneKey(const Lesson& lesson, int step) {
  return QStringLiteral("lessons/done/%1/%2").arg(qtext(lesson.id)).arg(step);
}
QString lessonKey() {
  return QStringLiteral("lessons/lesson");
}
QString stepKey() {
  return QStringLiteral("lessons/step");
}
QString lessonFolderKey() {
  return QStringLiteral("lessons/folder");
}
QString tourKey() {
  return QStringLiteral("lessons/tourOffered");
}

} // namespace

Learning::Learning(const Holders& of, QWidget* window)
    : QObject(window), of_(of), window_(window), work_(new LessonWork({}, {}, this)),
      frame_(new PartFrame(window)) {
  LearnPanel& panel = of_.panel;
  connect(&panel, &LearnPanel::lessonChosen, this, [this](int lesson) { chooseLesson(lesson, 0); });
  connect(&panel, &LearnPanel::stepChosen, this, &Learning::chooseStep);
  connect(&panel, &LearnPanel::returnRequested, this, &Learning::setState);
  connect(&panel, &LearnPanel::checkRequested, this, &Learning::check);
  connect(&panel, &LearnPanel::hintRequested, this, &Learning::giveHint);
  connect(&panel, &LearnPanel::numbersRequested, this, &Learning::measure);
  connect(&panel, &LearnPanel::closeRequested, this, &Learning::close);
  connect(&panel, &LearnPanel::rungChosen, this, [this](const QString& preset) {
    // A link of anybody's text may say anything.
    if (std::ranges::count(shownStep().ladder, preset.toStdString(), &Rung::preset) > 0)
      Q_EMIT rungChosen(preset);
  });
  connect(work_, &LessonWork::checked, this, &Learning::takeChecked);
  connect(work_, &LessonWork::measured, this, &Learning::takeNumbers);
  connect(work_, &LessonWork::recorded, this, [this](const LessonState& state) {
    if (!notes_.isSolutionShown) notes_.answer.clear();
    openOnItsFrames(state);
    show();
  });
  connect(work_, &LessonWork::ended, this, [this](const QString& error) {
    notes_.isChecking = false;
    if (!error.isEmpty()) notes_.answer = sentence(error.toStdString());
    show();
  });
}

void Learning::readLessons() {
  lessons_ = builtinLessons();
  if (folder().isEmpty()) return;
  LessonFolder own = taa::readLessons(folder().toStdString());
  for (Lesson& lesson : own.lessons) lessons_.push_back(std::move(lesson));
  for (const std::string& error : own.errors) Q_EMIT failed(sentence(error));
}

bool Learning::isOpen() const {
  return !of_.panel.isHidden();
}

void Learning::open() {
  readLessons();
  int lesson = 0, step = 0;
  if (of_.settings) {
    const std::string id = of_.settings->value(lessonKey()).toString().toStdString();
    const auto found = std::ranges::find(lessons_, id, &Lesson::id);
    if (found != lessons_.end()) {
      lesson = static_cast<int>(found - lessons_.begin());
      step = of_.settings->value(stepKey()).toInt();
    }
  }
  of_.panel.show();
  chooseLesson(lesson, step);
  Q_EMIT changed();
}

void Learning::openTour() {
  readLessons();
  of_.panel.show();
  chooseLesson(0, 0);
  Q_EMIT changed();
}

void Learning::close() {
  work_->cancel();
  notes_ = {};
  frame_->surround(nullptr);
  of_.panel.hide();
  Q_EMIT changed();
}

void Learning::chooseLesson(int lesson, int step) {
  lesson_ = lesson;
  step_ = std::clamp(step, 0, static_cast<int>(shown().steps.size()) - 1);
  showLessons();
  beginStep();
}

/// Who goes on has read the step, which was its task. Beyond the last step the next lesson begins.
void Learning::chooseStep(int step) {
  if (of_.settings && step > step_ && !shownStep().task)
    of_.settings->setValue(doneKey(shown(), step_), true);
  if (step >= static_cast<int>(shown().steps.size())) {
    chooseLesson(lesson_ + 1, 0);
    return;
  }
  step_ = std::max(0, step);
  beginStep();
}

void Learning::beginStep() {
  notes_ = {.isDone = isDone(shown(), step_)}; // before what still works says that it has ended
  work_->cancel();
  if (of_.settings) {
    of_.settings->setValue(lessonKey(), qtext(shown().id));
    of_.settings->setValue(stepKey(), step_);
  }
  setState();
  show();
  Q_EMIT stepBegun();
}

void Learning::setState() {
  openState(shownStep().state);
  frame_->surround(of_.part(qtext(shownStep().state.highlight)));
}

// What was open before the first lesson is kept, as when the program begins anew.
void Learning::openState(const LessonState& state) {
  if (!isBegun_) of_.keeper.keepWhatIsOpen();
  isBegun_ = true;
  if (!state.recording) {
    openOnItsFrames(state);
    return;
  }
  notes_.answer = tr("Frames are being drawn and written, as an engine would hand them out.");
  work_->record(state);
}

void Learning::openOnItsFrames(const LessonState& state) {
  opened_ = state.shot;
  of_.keeper.openFile(lessonSession(state));
  if (state.plays) of_.session.post(request::SetPlaying{true});
}

void Learning::show() {
  of_.panel.setStep(shown(), step_, notes_);
  Q_EMIT stepShown();
}

void Learning::tellAnswer() {
  show();
  Q_EMIT answered();
}

bool Learning::hidesFault() const {
  return isOpen() && shownStep().task && isFaulty(shownStep().state.shot.settings.settings) &&
         !notes_.isDone && !notes_.isSolutionShown;
}

QString Learning::place() const {
  return tr("%1, step %2 of %3").arg(qtext(shown().title)).arg(step_ + 1).arg(shown().steps.size());
}

void Learning::stepBy(int steps) {
  const int to = step_ + steps;
  const bool isBeyond = to >= static_cast<int>(shown().steps.size());
  if (to < 0 || (isBeyond && lesson_ + 1 >= static_cast<int>(lessons_.size()))) return;
  chooseStep(to);
}

void Learning::openStep(const QString& lesson, int step) {
  readLessons();
  const auto found = std::ranges::find(lessons_, lesson.toStdString(), &Lesson::id);
  if (found == lessons_.end()) {
    Q_EMIT failed(tr("There is no lesson \"%1\".").arg(lesson));
    return;
  }
  of_.panel.show();
  chooseLesson(static_cast<int>(found - lessons_.begin()), step - 1);
  Q_EMIT changed();
}

void Learning::showLessons() {
  QStringList titles;
  for (const Lesson& lesson : lessons_) {
    int done = 0;
    const int steps = static_cast<int>(lesson.steps.size());
    for (int step = 0; step < steps; ++step) done += isDone(lesson, step) ? 1 : 0;
    const QString title = qtext(lesson.title);
    titles << (done == steps ? tr("%1 (done)").arg(title)
               : done > 0    ? tr("%1 (%2 of %3)").arg(title).arg(done).arg(steps)
                             : title);
  }
  of_.panel.setLessons(titles, lesson_);
}

bool Learning::isDone(const Lesson& lesson, int step) const {
  return of_.settings && of_.settings->value(doneKey(lesson, step)).toBool();
}

/// What is open now, with the step's own lanes and samples; nothing: it is of something else, which is said.
std::optional<LessonState> Learning::stateNow() {
  LessonState now = shownStep().state;
  const SessionFile file = of_.session.file();
  now.recording.reset();
  notes_.numbers.clear();
  if (file.source != opened_.source || file.size != opened_.size) {
    notes_.answer = tr("Another scene or size is open: reset the step first.");
    show();
    return {};
  }
  now.shot = file;
  now.probes.clear();
  if (const auto pixel = of_.session.probes().pixel()) now.probes.push_back(*pixel);
  notes_.answer.clear();
  notes_.isChecking = true;
  show();
  return now;
}

void Learning::check() {
  if (notes_.isChecking) return;
  notes_.isAsked = true;
  if (const auto now = stateNow()) work_->begin(*now, shownStep().task->conditions);
}

void Learning::measure() {
  if (notes_.isChecking) return;
  notes_.isAsked = true;
  if (const auto now = stateNow()) work_->measure(*now, shownStep().claims);
}

void Learning::takeNumbers(const std::vector<LessonNumber>& numbers) {
  notes_.isChecking = false;
  notes_.numbers = qtext(numbersMarkdown(numbers, shownStep().state, tr("now").toStdString()));
  tellAnswer();
}

void Learning::takeChecked(const std::vector<CheckedCondition>& conditions) {
  notes_.isChecking = false;
  if (allHold(conditions)) {
    notes_.isDone = true;
    notes_.answer = tr("Solved.");
    if (of_.settings) of_.settings->setValue(doneKey(shown(), step_), true);
    showLessons();
    tellAnswer();
    return;
  }
  QStringList missing;
  const SpaceSettings space = of_.session.file().settings.settings.space;
  for (const CheckedCondition& checked : conditions)
    if (!checked.holds) missing << qtext(lackText(checked, space));
  notes_.answer = tr("Not yet. %1.").arg(missing.join(QStringLiteral("; ")));
  tellAnswer();
}

void Learning::giveHint() {
  notes_.isAsked = true;
  const Task& task = *shownStep().task;
  if (notes_.hints < static_cast<int>(task.hints.size())) {
    ++notes_.hints;
    tellAnswer();
    return;
  }
  notes_.isSolutionShown = true;
  openState(task.solution);
  notes_.answer = tr("This is a solution: check it.");
  tellAnswer();
}

QString Learning::folder() const {
  return of_.settings ? of_.settings->value(lessonFolderKey()).toString() : QString();
}

void Learning::setFolder(const QString& folder) {
  if (of_.settings) of_.settings->setValue(lessonFolderKey(), folder);
  open();
}

void Learning::askForFolder() {
  auto* dialog = new QFileDialog(window_, tr("Folder of lessons"), folder());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, &Learning::setFolder);
  dialog->open();
}

bool Learning::shouldOfferTour() const {
  return of_.settings && !of_.settings->value(tourKey()).toBool();
}

void Learning::rememberOffer() {
  if (of_.settings) of_.settings->setValue(tourKey(), true);
}

} // namespace taa::app
