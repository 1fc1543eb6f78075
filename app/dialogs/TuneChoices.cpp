#include "app/dialogs/TuneChoices.h"

#include "app/dialogs/FramesField.h"
#include "app/session/Session.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "core/render/CaptureFacts.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStringList>
#include <QVBoxLayout>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace taa::app {

namespace {

struct FirstWeight {
  std::string_view id;
  double weight;
};
/// Ghost, flicker, blur and the error of all together; the cost where somebody minds it.
constexpr FirstWeight kFirstWeights[] = {
    {"ghostEnergy", 1.0}, {"flicker", 1.0}, {"sharpness", 1.0}, {"rmse", 1.0}, {kCostGoal, 0.0}};
constexpr double kMaxWeight = 100.0, kWeightStep = 0.5;
constexpr int kTunedFrames = 8; ///< up to the one on show
constexpr int kFirstEvaluations = 100, kMaxEvaluations = 10'000;

} // namespace

QString goalTitle(const QString& id) {
  if (id == QLatin1String(kCostGoal)) return TuneChoices::tr("Cost of the resolve");
  return qtext(metricInfo(*findMetric(id.toStdString())).label);
}

TuneChoices::TuneChoices(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), stages_(new QListWidget),
      frames_(new FramesField(session, kTunedFrames)), evaluations_(new QSpinBox) {
  stages_->setAccessibleName(tr("Stages whose settings may change"));
  evaluations_->setAccessibleName(tr("Settings to measure at most"));
  evaluations_->setRange(1, kMaxEvaluations);
  evaluations_->setValue(kFirstEvaluations);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2 * kUnit);
  layout->addWidget(new QLabel(tr("Weights of the goal")));
  layout->addWidget(makeGoal());
  layout->addWidget(new QLabel(tr("What may change")));
  layout->addWidget(stages_, 1);
  layout->addWidget(frames_);
  auto* limit = new QFormLayout;
  limit->addRow(tr("Settings at most"), evaluations_);
  layout->addLayout(limit);
  listStages();
  connect(stages_, &QListWidget::itemChanged, this, &TuneChoices::changed);
  connect(frames_, &FramesField::changed, this, &TuneChoices::changed);
  connect(evaluations_, &QSpinBox::valueChanged, this, &TuneChoices::changed);
}

QWidget* TuneChoices::makeGoal() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  for (const FirstWeight& first : kFirstWeights) {
    const Weight weight{qtext(first.id), new QDoubleSpinBox};
    weight.field->setRange(0.0, kMaxWeight);
    weight.field->setSingleStep(kWeightStep);
    weight.field->setValue(first.weight);
    weight.field->setAccessibleName(tr("Weight of %1").arg(goalTitle(weight.id)));
    if (const auto metric = findMetric(first.id))
      weight.field->setToolTip(qtext(metricInfo(*metric).description));
    form->addRow(goalTitle(weight.id), weight.field);
    connect(weight.field, &QDoubleSpinBox::valueChanged, this, &TuneChoices::changed);
    weights_.push_back(weight);
  }
  return page;
}

// What varies is told by groups, the words before the dots of paths; a stage may have more than one.
void TuneChoices::listStages() {
  std::map<Stage, QListWidgetItem*> listed;
  for (const Parameter* row : tunableRows()) {
    QListWidgetItem*& item = listed[row->stage];
    if (!item) {
      item = new QListWidgetItem(qtext(stageInfo(row->stage).label), stages_);
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
      item->setCheckState(Qt::Checked);
    }
    QStringList groups = item->data(Qt::UserRole).toStringList();
    groups << qtext(row->path.substr(0, row->path.find('.')));
    groups.removeDuplicates();
    item->setData(Qt::UserRole, groups);
    item->setToolTip(groups.join(QStringLiteral(", ")));
  }
}

QDoubleSpinBox* TuneChoices::weight(const QString& id) const {
  const auto found = std::ranges::find(weights_, id, &Weight::id);
  return found == weights_.end() ? nullptr : found->field;
}

QString TuneChoices::goal() const {
  QStringList terms;
  for (const Weight& weight : weights_)
    if (weight.field->value() > 0.0)
      terms << weight.id + u'=' + QString::number(weight.field->value(), 'g', 6);
  return terms.join(u',');
}

std::vector<std::string> TuneChoices::varied() const {
  std::vector<std::string> ticked;
  for (int line = 0; line < stages_->count(); ++line)
    if (stages_->item(line)->checkState() == Qt::Checked)
      for (const QString& group : stages_->item(line)->data(Qt::UserRole).toStringList())
        ticked.push_back(group.toStdString());
  return ticked;
}

QString TuneChoices::whyNot() const {
  if (!frames_->isOrdered()) return tr("The last frame is before the first.");
  if (goal().isEmpty()) return tr("No weight is above 0: nothing would be better.");
  if (varied().empty()) return tr("No stage is ticked: nothing may change.");
  return {};
}

TuneRequest TuneChoices::request() const {
  const auto captured = session_.status().capture;
  const int samples = captured && !captured->hasReference ? 0 : session_.status().referenceGoal;
  TuneRequest made{goal().toStdString(), varied(), {frames_->first(), frames_->last(), {}, samples}};
  made.evaluations = evaluations_->value();
  return made;
}

} // namespace taa::app
