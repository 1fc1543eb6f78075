#include "app/doctor/DoctorPanel.h"

#include "app/background/BackgroundBar.h"
#include "app/doctor/FindingDetails.h"
#include "app/doctor/FindingList.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/Line.h"

#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>
#include <QShowEvent>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <string>

namespace taa::app {

DoctorPanel::DoctorPanel(QWidget* parent) : QWidget(parent), pages_(new QStackedWidget), empty_(new QLabel) {
  empty_->setWordWrap(true);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setMargin(2 * kUnit);
  empty_->setForegroundRole(QPalette::PlaceholderText);
  empty_->setText(
      tr("The doctor measures, region by region, whether jitter, depth and motion vectors fit the "
         "pictures, and says what is wrong and what to change.\nExamine looks at the frames above "
         "while the window goes on; a fault of the menu Faults shows what it finds."));
  pages_->addWidget(empty_);
  pages_->addWidget(makeResult());
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  rows->setSpacing(kUnit);
  rows->addWidget(makeTop());
  rows->addWidget(new Line);
  rows->addWidget(pages_, 1);
  connect(&work_, &DoctorWork::told, this, &DoctorPanel::take);
  connect(&work_, &DoctorWork::ended, this, &DoctorPanel::finish);
  refresh();
}

QWidget* DoctorPanel::makeTop() {
  auto* top = new QWidget;
  auto* line = new QHBoxLayout(top);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(kUnit);
  first_ = new QSpinBox;
  last_ = new QSpinBox;
  first_->setAccessibleName(tr("First frame to examine"));
  last_->setAccessibleName(tr("Last frame to examine"));
  bar_ = new BackgroundBar(work_, tr("Examine"));
  save_ = bar_->addButton(tr("Save report…"), tr("Save the doctor's report as HTML"));
  save_->setToolTip(tr("One HTML page without scripts, to put into a bug tracker"));
  line->addWidget(new QLabel(tr("Frames")));
  line->addWidget(first_);
  line->addWidget(new QLabel(tr("to")));
  line->addWidget(last_);
  line->addSpacing(kUnit);
  line->addWidget(bar_, 1);
  for (QSpinBox* field : {first_, last_})
    connect(field, &QSpinBox::valueChanged, this, &DoctorPanel::refresh);
  connect(bar_, &BackgroundBar::startRequested, this, &DoctorPanel::examineRequested);
  connect(save_, &QPushButton::clicked, this, &DoctorPanel::reportRequested);
  return top;
}

QWidget* DoctorPanel::makeResult() {
  auto* result = new QWidget;
  auto* columns = new QHBoxLayout(result);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4 * kUnit);
  list_ = new FindingList;
  details_ = new FindingDetails;
  columns->addWidget(list_, 2);
  columns->addWidget(details_, 3);
  connect(list_, &FindingList::choiceChanged, this, &DoctorPanel::showChoice);
  connect(list_, &FindingList::placeRequested, this, [this] {
    if (!places().empty()) Q_EMIT placeRequested();
  });
  connect(details_, &FindingDetails::placeRequested, this, &DoctorPanel::placeRequested);
  connect(details_, &FindingDetails::correctedRequested, this, &DoctorPanel::correctedRequested);
  return result;
}

void DoctorPanel::setShot(int frameCount) {
  work_.cancel();
  diagnosis_.reset();
  isComplete_ = isOutdated_ = false;
  frameCount_ = frameCount;
  const QSignalBlocker first(first_), last(last_);
  for (QSpinBox* field : {first_, last_}) field->setRange(0, std::max(0, frameCount - 1));
  setFrames(0, std::min(doctor::kDoctorFrames, frameCount) - 1);
  pages_->setCurrentIndex(0);
  refresh();
  Q_EMIT changed();
}

void DoctorPanel::setOutdated(bool outdated) {
  if (outdated == isOutdated_) return;
  isOutdated_ = outdated;
  refresh();
}

int DoctorPanel::first() const {
  return first_->value();
}

int DoctorPanel::last() const {
  return last_->value();
}

void DoctorPanel::setFrames(int first, int last) {
  first_->setValue(first);
  last_->setValue(last);
}

QString DoctorPanel::whyNot() const {
  const int count = last() - first() + 1;
  if (frameCount_ < doctor::kLeastDoctorFrames)
    return tr("There is one frame alone, and each is compared with the one before it.");
  if (count < doctor::kLeastDoctorFrames)
    return tr("At least two frames are examined: each is compared with the one before it.");
  if (count > doctor::kMaxDoctorFrames)
    return tr("At most %1 frames are examined.").arg(doctor::kMaxDoctorFrames);
  return {};
}

const doctor::Finding* DoctorPanel::finding() const {
  const FindingList::Choice choice = list_->choice();
  if (!diagnosis_ || choice.line != DoctorLine::Finding || choice.index < 0) return nullptr;
  return &diagnosis_->findings[static_cast<std::size_t>(choice.index)];
}

std::vector<doctor::RegionPlace> DoctorPanel::places() const {
  const doctor::Finding* chosen = finding();
  if (!chosen) return {};
  const int region = list_->choice().region;
  if (region < 0) return chosen->regions;
  return {chosen->regions[static_cast<std::size_t>(region)]};
}

void DoctorPanel::take(const doctor::Diagnosis& diagnosis, bool isComplete) {
  diagnosis_ = diagnosis;
  isComplete_ = isComplete;
  list_->setDiagnosis(diagnosis, isComplete); // before it is shown: its choice is of the last one until then
  pages_->setCurrentIndex(1);
  refresh();
}

void DoctorPanel::finish(const QString& error) {
  refresh();
  if (!error.isEmpty()) bar_->setNote(error);
}

void DoctorPanel::showChoice() {
  const FindingList::Choice choice = list_->choice();
  const auto index = static_cast<std::size_t>(std::max(0, choice.index));
  if (!diagnosis_ || choice.index < 0)
    details_->showText({}, {});
  else if (choice.line == DoctorLine::Finding)
    details_->showFinding(diagnosis_->findings[index], choice.region, diagnosis_->frameNames);
  else if (choice.line == DoctorLine::Undecided)
    details_->showUndecided(diagnosis_->parts.undecided()[index]);
  else if (choice.line == DoctorLine::Right)
    details_->showText(tr("Right"), {{QString(), sentence(diagnosis_->parts.right()[index].sentence)}});
  else if (choice.line == DoctorLine::Note)
    details_->showText(tr("Note"), {{QString(), sentence(diagnosis_->notes[index])}});
  else
    details_->showText(isComplete_ ? qtext(diagnosis_->healthySentence())
                                   : tr("Nothing wrong was found so far."),
                       {{tr("Examined"), summary()}, {tr("Right"), rightSentences()}});
  Q_EMIT changed();
}

QString DoctorPanel::rightSentences() const {
  QStringList lines;
  for (const doctor::RightPart& right : diagnosis_->parts.right()) lines << sentence(right.sentence);
  return lines.join(QLatin1Char('\n'));
}

QString DoctorPanel::summary() const {
  return qtext(diagnosis_->lookedText());
}

void DoctorPanel::refresh() {
  save_->setEnabled(diagnosis_ && isComplete_ && !work_.isRunning());
  const QString whyNot = this->whyNot();
  QString note = whyNot;
  if (note.isEmpty() && !diagnosis_)
    note = tr("Frames %1 to %2 are looked at, each beside the one before it.").arg(first()).arg(last());
  else if (note.isEmpty() && isOutdated_)
    note = tr("%1; settings have changed since.").arg(summary());
  else if (note.isEmpty())
    note = isComplete_ ? tr("%1.").arg(summary())
                       : tr("%1; it was stopped before it had seen all.").arg(summary());
  bar_->setReady(whyNot.isEmpty() && frameCount_ > 0, note);
  for (QSpinBox* field : {first_, last_}) field->setEnabled(!work_.isRunning());
}

void DoctorPanel::begin(const ExaminationRequest& request) {
  diagnosis_.reset();
  isComplete_ = isOutdated_ = false;
  work_.begin(request);
  pages_->setCurrentIndex(0);
  refresh();
  Q_EMIT changed();
}

void DoctorPanel::correct(const ExaminationRequest& request, const Settings& healthy) {
  work_.correct(request, *diagnosis_, healthy);
  refresh();
}

QString DoctorPanel::note() const {
  return bar_->note();
}

void DoctorPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!event->spontaneous()) Q_EMIT changed();
}

void DoctorPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!event->spontaneous()) Q_EMIT changed();
}

} // namespace taa::app
