#include "app/dialogs/SweepChoices.h"

#include "app/session/Session.h"
#include "app/session/UserPresets.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "core/render/CaptureFacts.h"
#include "core/settings/Presets.h"
#include "core/sweep/SweepSpec.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStringList>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <vector>

namespace taa::app {

namespace {

enum AxisPage { PresetPage, NumberPage, ValuesPage };
constexpr int kMaxSweepSteps = 100, kFirstSteps = 5, kRangeDecimals = 4;
constexpr double kFirstReach = 4.0; ///< times the present value, down and up

bool isSweptNumber(const Parameter& row) {
  return row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer;
}

QString sweptValueText(const Parameter& row, double value) {
  if (row.kind == ParameterKind::Choice) return qtext(row.choices[static_cast<std::size_t>(value)].label);
  const QString text = QString::fromStdString(valueText(row, value));
  return row.unit.empty() ? text : text + u' ' + qtext(row.unit);
}

/// All that a choice or a switch has.
std::vector<double> allValues(const Parameter& row) {
  std::vector<double> values;
  for (double value = row.minimum; value <= row.maximum; ++value) values.push_back(value);
  return values;
}

} // namespace

SweepChoices::SweepChoices(Session& session, const QString& folder, QWidget* parent)
    : QWidget(parent), session_(session), folder_(folder), axis_(new QComboBox), pages_(new QStackedWidget),
      presets_(new QListWidget), from_(new QDoubleSpinBox), to_(new QDoubleSpinBox), steps_(new QSpinBox),
      byFactor_(new QCheckBox(tr("By a constant factor"))), all_(new QLabel) {
  axis_->setAccessibleName(tr("What changes"));
  axis_->view()->setAccessibleName(axis_->accessibleName());
  presets_->setAccessibleName(tr("Presets to measure"));
  presets_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // a long name ends in dots
  all_->setWordWrap(true);
  all_->setAlignment(Qt::AlignTop);
  pages_->addWidget(presets_);
  pages_->addWidget(makeRange());
  pages_->addWidget(all_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2 * kUnit);
  layout->addWidget(axis_);
  layout->addWidget(pages_, 1);
  listParameters();
  listPresets();
  connect(axis_, &QComboBox::currentIndexChanged, this, &SweepChoices::showAxis);
  connect(presets_, &QListWidget::itemChanged, this, &SweepChoices::changed);
  showAxis();
}

void SweepChoices::refresh() {
  listParameters();
  listPresets();
  Q_EMIT changed();
}

// The chosen one stays, also where it does not count any more: somebody may have typed its range.
void SweepChoices::listParameters() {
  const QString chosen = axis_->currentData().toString();
  const auto captured = session_.status().capture;
  const QSignalBlocker quiet(axis_);
  axis_->clear();
  axis_->addItem(tr("Presets"));
  for (const Parameter& row : parameters())
    if (qtext(row.path) == chosen ||
        (isRelevant(row, session_.presets().settings()) && !(captured && isFixedBy(*captured, row))))
      axis_->addItem(tr("%1: %2").arg(qtext(stageInfo(row.stage).label), qtext(row.label)), qtext(row.path));
  if (!chosen.isEmpty()) axis_->setCurrentIndex(axis_->findData(chosen));
}

// At first those are ticked that are there to compare with.
void SweepChoices::listPresets() {
  std::map<QString, Qt::CheckState> ticked;
  for (int line = 0; line < presets_->count(); ++line)
    ticked[presets_->item(line)->data(Qt::UserRole).toString()] = presets_->item(line)->checkState();
  const QSignalBlocker quiet(presets_);
  presets_->clear();
  const auto add = [&](const QString& label, const QString& idOrPath, bool isTicked) {
    auto* item = new QListWidgetItem(label, presets_);
    item->setData(Qt::UserRole, idOrPath);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    const auto before = ticked.find(idOrPath);
    item->setCheckState(before != ticked.end() ? before->second : isTicked ? Qt::Checked : Qt::Unchecked);
  };
  add(tr("The present settings"), {}, true);
  for (const Preset& preset : builtinPresets())
    add(qtext(preset.label), QString::fromStdString(preset.id),
        preset.group == kPresetGroups.front().id && preset.step == 0);
  for (const UserPreset& own : userPresets(folder_)) add(tr("%1 (mine)").arg(own.label), own.path, false);
}

QWidget* SweepChoices::makeRange() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  from_->setAccessibleName(tr("First value"));
  to_->setAccessibleName(tr("Last value"));
  steps_->setAccessibleName(tr("Number of values"));
  steps_->setRange(2, kMaxSweepSteps);
  form->addRow(tr("From"), from_);
  form->addRow(tr("To"), to_);
  form->addRow(tr("Values"), steps_);
  form->addRow(byFactor_);
  for (QDoubleSpinBox* field : {from_, to_})
    connect(field, &QDoubleSpinBox::valueChanged, this, [this] {
      byFactor_->setEnabled(from_->value() > 0.0 && to_->value() > 0.0);
      remember();
    });
  connect(steps_, &QSpinBox::valueChanged, this, &SweepChoices::remember);
  connect(byFactor_, &QCheckBox::toggled, this, &SweepChoices::remember);
  return page;
}

const Parameter* SweepChoices::row() const {
  const QString path = axis_->currentData().toString();
  return path.isEmpty() ? nullptr : &parameter(path.toStdString());
}

QString SweepChoices::title() const {
  return row() ? qtext(row()->label) : tr("Preset");
}

// Around what is set now.
SweepChoices::Range SweepChoices::firstRange(const Parameter& row) const {
  const double now = row.get(session_.presets().settings());
  if (row.minimum < 0.0 || now <= 0.0) return {row.minimum, row.maximum, kFirstSteps, false};
  return {std::max(row.minimum, now / kFirstReach), std::min(row.maximum, now * kFirstReach), kFirstSteps,
          true};
}

void SweepChoices::showRange(const Parameter& row) {
  const auto typed = ranges_.find(qtext(row.path));
  const Range range = typed != ranges_.end() ? typed->second : firstRange(row);
  const QSignalBlocker quietFrom(from_), quietTo(to_), quietSteps(steps_), quietFactor(byFactor_);
  for (QDoubleSpinBox* field : {from_, to_}) {
    field->setDecimals(row.kind == ParameterKind::Integer ? 0 : kRangeDecimals);
    field->setRange(row.minimum, row.maximum);
    field->setSuffix(row.unit.empty() ? QString() : u' ' + qtext(row.unit));
  }
  from_->setValue(range.from);
  to_->setValue(range.to);
  steps_->setValue(range.steps);
  byFactor_->setEnabled(from_->value() > 0.0 && to_->value() > 0.0);
  byFactor_->setChecked(range.isByFactor);
}

void SweepChoices::remember() {
  if (const Parameter* row = this->row(); row && isSweptNumber(*row))
    ranges_[qtext(row->path)] = {from_->value(), to_->value(), steps_->value(), byFactor_->isChecked()};
  Q_EMIT changed();
}

void SweepChoices::showAxis() {
  const Parameter* row = this->row();
  pages_->setCurrentIndex(!row ? PresetPage : isSweptNumber(*row) ? NumberPage : ValuesPage);
  if (row && isSweptNumber(*row)) {
    showRange(*row);
  } else if (row) {
    QStringList texts;
    for (const double value : allValues(*row)) texts << sweptValueText(*row, value);
    all_->setText(tr("All that it has: %1.").arg(texts.join(QStringLiteral(", "))));
  }
  Q_EMIT changed();
}

std::vector<SweptSettings> SweepChoices::chosen() const {
  return row() ? chosenValues() : chosenPresets();
}

std::vector<SweptSettings> SweepChoices::chosenPresets() const {
  std::vector<SweptSettings> chosen;
  for (int line = 0; line < presets_->count(); ++line) {
    const QListWidgetItem* item = presets_->item(line);
    if (item->checkState() != Qt::Checked) continue;
    const QString idOrPath = item->data(Qt::UserRole).toString();
    try {
      if (idOrPath.isEmpty()) {
        chosen.push_back({item->text(), session_.presets().choice()});
        continue;
      }
      const Preset preset = taa::preset(idOrPath.toStdString());
      chosen.push_back({item->text(), {preset.settings, preset.settings, preset.id}});
    } catch (const std::exception&) {
      continue; // a file of the user's went away meanwhile
    }
  }
  return chosen;
}

std::vector<SweptSettings> SweepChoices::chosenValues() const {
  const Parameter& row = *this->row();
  std::vector<double> values;
  try {
    values = isSweptNumber(row) ? valuesBetween(row, from_->value(), to_->value(), steps_->value(),
                                                byFactor_->isEnabled() && byFactor_->isChecked())
                                : allValues(row);
  } catch (const std::exception&) {
    return {}; // rounded past an end of the range
  }
  std::vector<SweptSettings> chosen;
  for (const double value : values) {
    SweptSettings& made = chosen.emplace_back(sweptValueText(row, value), session_.presets().choice());
    row.set(made.choice.settings, value);
  }
  return chosen;
}

} // namespace taa::app
