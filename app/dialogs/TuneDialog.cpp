#include "app/dialogs/TuneDialog.h"

#include "app/background/BackgroundBar.h"
#include "app/dialogs/TuneChoices.h"
#include "app/models/verdict/VerdictWords.h"
#include "app/session/Session.h"
#include "app/style/DialogSize.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/plots/CurveChart.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QStringList>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

constexpr int kTuneDigits = 4;

QTreeWidgetItem* tuneLine(const QStringList& cells, int firstNumber, int lastNumber) {
  auto* line = new QTreeWidgetItem(cells);
  for (int column = firstNumber; column <= lastNumber; ++column) {
    line->setFont(column, numberFont());
    line->setTextAlignment(column, Qt::AlignVCenter | Qt::AlignRight);
  }
  return line;
}

QString tunedText(const std::optional<double>& number) {
  return number ? shortText(*number, kTuneDigits) : QStringLiteral("–");
}

} // namespace

TuneDialog::TuneDialog(Session& session, TuneExits exits, QWidget* parent, TuneWork::Tune tune)
    : WorkDialog(work_, parent), session_(session), exits_(std::move(exits)), work_(std::move(tune)),
      choices_(new TuneChoices(session)), numbers_(new QTreeWidget), steps_(new QTreeWidget),
      chart_(new CurveChart(tr("Goal"), tr("evaluation"))), bar_(new BackgroundBar(work_, tr("Tune"))) {
  setWindowTitle(tr("Tune"));
  choices_->setFixedWidth(scaled(60 * kUnit));
  makeTables();
  makeButtons();
  auto* right = new QVBoxLayout;
  right->setSpacing(2 * kUnit);
  right->addWidget(numbers_);
  right->addWidget(chart_, 1);
  right->addWidget(steps_, 1);
  auto* sides = new QHBoxLayout;
  sides->setSpacing(3 * kUnit);
  sides->addWidget(choices_);
  sides->addLayout(right, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kUnit, 3 * kUnit, 3 * kUnit, 3 * kUnit);
  layout->setSpacing(2 * kUnit);
  layout->addLayout(sides, 1);
  layout->addWidget(bar_);
  connect(choices_, &TuneChoices::changed, this, &TuneDialog::refresh);
  connect(&session_, &Session::statusChanged, this, &TuneDialog::refresh);
  connect(&work_, &TuneWork::told, this, &TuneDialog::showWay);
  connect(&work_, &TuneWork::ended, this, &TuneDialog::finish);
  refresh();
  resize(sizeOver(parent, {scaled(210 * kUnit), scaled(150 * kUnit)}));
}

void TuneDialog::openAt(Session& session, const TuneExits& exits, QWidget* window) {
  auto* dialog = window->findChild<TuneDialog*>();
  if (!dialog) dialog = new TuneDialog(session, exits, window);
  dialog->present();
}

void TuneDialog::makeTables() {
  numbers_->setAccessibleName(tr("What the goal counts, at the start and at best"));
  numbers_->setHeaderLabels({tr("Goal"), tr("Weight"), tr("Start"), tr("Best")});
  numbers_->setFixedHeight(40 * kUnit);
  steps_->setAccessibleName(tr("The way it went"));
  steps_->setHeaderLabels({tr("Evaluation"), tr("Goal"), tr("Change that was kept")});
  for (QTreeWidget* table : {numbers_, steps_}) {
    table->setRootIsDecorated(false);
    table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  }
}

void TuneDialog::makeButtons() {
  export_ = bar_->addButton(tr("Export GLSL…"), tr("Export what was found as GLSL"));
  save_ = bar_->addButton(tr("Save as preset…"), tr("Save what was found as a preset"));
  apply_ = bar_->addButton(tr("Apply"), tr("Apply what was found"));
  apply_->setToolTip(tr("Take all changes up as one step; it can be undone"));
  connect(bar_, &BackgroundBar::startRequested, this, &TuneDialog::begin);
  connect(apply_, &QPushButton::clicked, this, [this] {
    if (const auto better = found()) session_.presets().change(*better, tr("tuned settings"));
  });
  connect(save_, &QPushButton::clicked, this, [this] {
    if (const auto better = found()) exits_.savePreset(better->settings);
  });
  connect(export_, &QPushButton::clicked, this, [this] {
    if (const auto better = found()) exits_.exportGlsl(better->settings);
  });
}

void TuneDialog::begin() {
  if (!choices_->whyNot().isEmpty()) return;
  start_ = session_.presets().choice();
  request_ = choices_->request();
  way_.reset();
  numbers_->clear();
  steps_->clear();
  chart_->setCurves({});
  work_.begin({session_.file(), start_.settings, request_});
  refresh();
}

void TuneDialog::showNumbers(const TuneWay& way) {
  numbers_->clear();
  const TuneGoal goal(request_.goal);
  for (const GoalTerm& term : goal.terms()) {
    const QString id = qtext(term.metric ? metricInfo(*term.metric).id : kCostGoal);
    numbers_->addTopLevelItem(
        tuneLine({goalTitle(id), shortText(term.weight, kTuneDigits), tunedText(termNumber(term, way.start)),
                  tunedText(termNumber(term, way.best))},
                 1, 3));
  }
  const std::vector<Metric> counted = goal.metrics();
  for (const Metric metric : kGuardedMetrics) {
    const auto index = static_cast<std::size_t>(metric);
    if (!way.start.means[index] || std::ranges::find(counted, metric) != counted.end()) continue;
    numbers_->addTopLevelItem(tuneLine({goalTitle(qtext(metricInfo(metric).id)), tr("may not rise"),
                                        tunedText(way.start.means[index]), tunedText(way.best.means[index])},
                                       2, 3));
  }
  numbers_->addTopLevelItem(tuneLine(
      {tr("All together"), QString(), tunedText(way.result.startGoal), tunedText(way.result.goal)}, 1, 3));
}

// The goal stays between two steps.
void TuneDialog::showWay(const TuneWay& way) {
  way_ = way;
  showNumbers(way);
  steps_->clear();
  Curve curve{tr("best so far"), curveColor(0), Qt::SolidLine, {{1.0, way.result.startGoal}}, {}};
  double before = way.result.startGoal;
  for (const TuneStep& step : way.result.steps) {
    curve.points.emplace_back(step.evaluation, before);
    curve.points.emplace_back(step.evaluation, step.goal);
    before = step.goal;
    steps_->addTopLevelItem(tuneLine(
        {QString::number(step.evaluation), shortText(step.goal, kTuneDigits), changeText(step.change)}, 0,
        1));
  }
  const int last = std::max(2, way.result.evaluations);
  curve.points.emplace_back(last, before);
  chart_->setBounds({1.0, static_cast<double>(last)});
  chart_->setCurves({std::move(curve)});
  steps_->scrollToBottom();
  refresh();
}

std::optional<PresetChoice> TuneDialog::found() const {
  if (!way_ || way_->result.steps.empty()) return {};
  PresetChoice better = start_;
  better.settings = way_->result.settings;
  return better;
}

void TuneDialog::refresh() {
  const bool hasBetter = found().has_value();
  for (QPushButton* button : {apply_, save_, export_}) button->setEnabled(hasBetter);
  const QString whyNot = choices_->whyNot();
  bar_->setReady(whyNot.isEmpty() && session_.isOpen(),
                 whyNot.isEmpty() ? tr("It begins with the present settings.") : whyNot);
}

void TuneDialog::finish(const QString& error) {
  refresh();
  if (!error.isEmpty()) {
    bar_->setNote(error);
    return;
  }
  if (!way_) {
    bar_->setNote(tr("It was ended before the start was measured."));
    return;
  }
  const QString end =
      way_->result.isComplete ? tr("no single change is better") : tr("it was not at its end");
  bar_->setNote(tr("Settings measured: %1; %2.").arg(way_->result.evaluations).arg(end));
}

} // namespace taa::app
