#include "app/dialogs/PresetsDialog.h"

#include "app/session/Session.h"
#include "app/session/UserPresets.h"
#include "app/style/DialogSize.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/ConfirmReplace.h"
#include "app/widgets/Prompt.h"
#include "app/widgets/areas/FittingArea.h"
#include "app/widgets/parameters/ChoiceWords.h"
#include "core/base/ShownText.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <utility>

namespace taa::app {

namespace {

constexpr int kDescriptionLines = 4; ///< in a low window

enum Column { StageName, Setting, Present, InPreset };

/// As the window shows it: the label of a choice, a number with its unit.
QString shownValue(const Parameter& row, double value) {
  if (row.kind == ParameterKind::Choice) {
    const auto index = static_cast<std::size_t>(value);
    if (index < row.choices.size()) return qtext(row.choices[index].label);
  }
  const QString text = QString::fromStdString(valueText(row, value));
  return row.unit.empty() ? text : text + u' ' + qtext(row.unit);
}

} // namespace

PresetsDialog::PresetsDialog(Session& session, QString folder, QWidget* parent)
    : QDialog(parent), session_(session), folder_(std::move(folder)), list_(new QListWidget),
      table_(new QTreeWidget), description_(new QLabel), heading_(new QLabel), error_(new QLabel) {
  setWindowTitle(tr("Presets"));
  setAttribute(Qt::WA_DeleteOnClose);
  list_->setAccessibleName(tr("Presets"));
  list_->setFixedWidth(scaled(50 * kUnit));
  list_->setWordWrap(true); // long names take two lines
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setAccessibleName(tr("Settings that differ"));
  table_->setRootIsDecorated(false);
  table_->setHeaderLabels({tr("Stage"), tr("Setting"), tr("Now"), tr("Preset")});
  table_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  for (QLabel* text : {description_, heading_}) {
    text->setWordWrap(true);
    text->setTextFormat(Qt::PlainText); // a preset of a file says what its writer liked
  }
  description_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* description = new FittingArea(kDescriptionLines * fontMetrics().lineSpacing());
  description->setAccessibleName(tr("What the preset is"));
  description->setFocusPolicy(Qt::StrongFocus); // keys scroll a long one
  description->setWidget(description_);
  error_->setWordWrap(true);
  error_->setVisible(false);
  auto* sides = new QHBoxLayout;
  sides->setSpacing(3 * kUnit);
  sides->addWidget(list_);
  auto* right = new QVBoxLayout;
  right->setSpacing(2 * kUnit);
  right->addWidget(description);
  right->addWidget(heading_);
  right->addWidget(table_, 1);
  right->addStretch(); // where nothing differs
  sides->addLayout(right, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kUnit, 3 * kUnit, 3 * kUnit, 3 * kUnit);
  layout->setSpacing(2 * kUnit);
  layout->addLayout(sides, 1);
  layout->addWidget(error_);
  layout->addWidget(makeButtons());
  connect(list_, &QListWidget::currentRowChanged, this, &PresetsDialog::compare);
  connect(list_, &QListWidget::itemActivated, this, &PresetsDialog::apply);
  connect(table_, &QTreeWidget::itemActivated, this, &PresetsDialog::applyValue);
  connect(&session_.presets(), &PresetChoices::settingsChanged, this, &PresetsDialog::compare);
  connect(&session_, &Session::errorOccurred, this, [this](const QString& sentence) {
    error_->setText(sentence);
    error_->setVisible(true);
  });
  readPresets();
  resize(sizeOver(parent, {scaled(190 * kUnit), largeOver(parent, {0, scaled(170 * kUnit)}).height()}));
}

QWidget* PresetsDialog::makeButtons() {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(kUnit);
  const auto add = [&](const QString& text, const QString& toolTip, void (PresetsDialog::*act)()) {
    auto* button = new QPushButton(text);
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, act);
    line->addWidget(button);
    return button;
  };
  add(tr("Save as…"), tr("Save the present settings as a preset"), &PresetsDialog::save);
  rename_ = add(tr("Rename…"), tr("Rename this preset of yours"), &PresetsDialog::rename);
  delete_ = add(tr("Delete…"), tr("Delete this preset of yours"), &PresetsDialog::askToDelete);
  line->addStretch(1);
  value_ = add(tr("Apply this value"), tr("Change only the selected setting to the preset's value"),
               &PresetsDialog::applyValue);
  apply_ = add(tr("Apply preset"), tr("Change all settings to the preset's"), &PresetsDialog::apply);
  auto* close = new QPushButton(tr("Close"));
  close->setAccessibleName(tr("Close"));
  close->setAutoDefault(false);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  line->addWidget(close);
  return row;
}

// Keeps the choice where it can and nothing else is wanted.
void PresetsDialog::readPresets(const QString& wanted) {
  const QString before = !wanted.isEmpty() ? wanted
                         : chosen()        ? chosen()->idOrPath
                                           : QString::fromStdString(session_.presets().presetId());
  entries_.clear();
  for (const Preset& preset : builtinPresets())
    entries_.push_back({qtext(preset.label), QString::fromStdString(preset.id), qtext(preset.description),
                        preset.settings, false});
  for (const UserPreset& own : userPresets(folder_)) try {
      const Preset read = preset(own.path.toStdString());
      entries_.push_back({own.label, own.path, qtext(read.description), read.settings, true});
    } catch (const std::exception&) {
      continue; // it went away meanwhile
    }
  const QSignalBlocker quiet(list_);
  list_->clear();
  int current = 0;
  for (const Entry& entry : entries_) {
    // The session knows a preset of the user's by the name of its file.
    if (before == entry.idOrPath || (entry.isOwn && before == QFileInfo(entry.idOrPath).completeBaseName()))
      current = list_->count();
    list_->addItem(entry.isOwn ? tr("%1 (mine)").arg(entry.label) : entry.label);
  }
  list_->setCurrentRow(current);
  compare();
}

const PresetsDialog::Entry* PresetsDialog::chosen() const {
  const int row = list_->currentRow();
  return row >= 0 && row < static_cast<int>(entries_.size()) ? &entries_[static_cast<std::size_t>(row)]
                                                             : nullptr;
}

void PresetsDialog::compare() {
  const Entry* entry = chosen();
  table_->clear();
  const Settings& now = session_.presets().settings();
  if (entry)
    for (const Parameter& row : parameters()) {
      const double present = row.get(now), there = row.get(entry->settings);
      if (valueText(row, present) == valueText(row, there)) continue;
      auto* item = new QTreeWidgetItem({qtext(stageInfo(row.stage).label), qtext(row.label),
                                        shownValue(row, present), shownValue(row, there)});
      item->setData(Setting, Qt::UserRole, qtext(row.path));
      item->setToolTip(Setting, qtext(row.tooltip));
      item->setData(InPreset, Qt::UserRole, there);
      table_->addTopLevelItem(item);
    }
  if (table_->topLevelItemCount() > 0) table_->setCurrentItem(table_->topLevelItem(0));
  const int count = table_->topLevelItemCount();
  table_->setVisible(count > 0);
  description_->setText(entry ? withoutManual(entry->description) : QString());
  heading_->setText(!entry ? QString()
                    : count > 0
                        ? tr("%1 differs from the present settings. Values: %2.").arg(entry->label).arg(count)
                        : tr("%1 is what is set now.").arg(entry->label));
  value_->setEnabled(count > 0);
  apply_->setEnabled(entry != nullptr);
  rename_->setEnabled(entry && entry->isOwn);
  delete_->setEnabled(entry && entry->isOwn);
}

void PresetsDialog::apply() {
  if (const Entry* entry = chosen()) session_.presets().setPreset(entry->idOrPath);
}

void PresetsDialog::applyValue() {
  if (const QTreeWidgetItem* item = table_->currentItem())
    session_.presets().setParameter(item->data(Setting, Qt::UserRole).toString(),
                                    item->data(InPreset, Qt::UserRole).toDouble());
}

// `act` says which preset is chosen then. What fails is said below, and everything stays as it was.
void PresetsDialog::change(const std::function<QString()>& act) {
  QString next;
  error_->setVisible(false);
  try {
    next = act();
  } catch (const std::exception& error) {
    error_->setText(QString::fromStdString(shownReason(error)));
    error_->setVisible(true);
  }
  readPresets(next);
  Q_EMIT userPresetsChanged();
}

void PresetsDialog::save() {
  auto* prompt = new Prompt(
      tr("Save the present settings as"), {},
      [this](const QString& text) {
        if (text.trimmed().isEmpty()) return false;
        confirmReplace(this, {userPresetPath(folder_, text).toStdString()}, [this, text] {
          change([&] {
            QString path = saveUserPreset(folder_, text, session_.presets().settings());
            session_.presets().setPreset(path);
            return path;
          });
        });
        return true;
      },
      this);
  prompt->open();
}

void PresetsDialog::rename() {
  const Entry* entry = chosen();
  if (!entry) return;
  auto* prompt = new Prompt(
      tr("New name of %1").arg(entry->label), entry->label,
      [this, path = entry->idOrPath](const QString& text) {
        if (text.trimmed().isEmpty()) return false;
        change([&] { return renameUserPreset(path, text); });
        return true;
      },
      this);
  prompt->open();
}

void PresetsDialog::askToDelete() {
  const Entry* entry = chosen();
  if (!entry) return;
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, tr("Delete a preset"),
                      tr("Delete the preset %1? Its file goes, too: %2").arg(entry->label, entry->idOrPath),
                      QMessageBox::Cancel, this);
  QPushButton* yes = box->addButton(tr("Delete"), QMessageBox::DestructiveRole);
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(yes, &QPushButton::clicked, this, [this, path = entry->idOrPath] {
    change([&] {
      deleteUserPreset(path);
      return QString();
    });
  });
  box->open();
}

} // namespace taa::app
