// What the window asks its user: files, pixels, frames, sizes, intermediates, commands.
#include "app/dialogs/KeysDialog.h"
#include "app/dialogs/PresetsDialog.h"
#include "app/menus/Menus.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/session/UserPresets.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/ConfirmReplace.h"
#include "app/widgets/Prompt.h"
#include "app/window/MainWindow.h"
#include "core/settings/Parameters.h"

#include <QAction>
#include <QFileDialog>
#include <QLineEdit>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

QString withoutMnemonic(QString text) {
  return text.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
}

QString keysOf(const QAction* action) {
  QStringList keys;
  for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
  return keys.join(QStringLiteral(", "));
}

/// A choice or a position of a switch.
struct ParameterValue {
  const Parameter* row;
  int value;
};

std::vector<ParameterValue> parameterValues() {
  std::vector<ParameterValue> values;
  for (const Parameter& row : parameters()) {
    const int count = row.kind == ParameterKind::Toggle ? 2 : static_cast<int>(row.choices.size());
    for (int value = 0; value < count; ++value) values.push_back({&row, value});
  }
  return values;
}

ChooserEntry entryOf(const ParameterValue& of, const Settings& settings) {
  const Parameter& row = *of.row;
  QString name = of.value != 0 ? MainWindow::tr("on") : MainWindow::tr("off");
  if (row.kind == ParameterKind::Choice)
    name = tableText(row.choices[static_cast<std::size_t>(of.value)].label);
  const bool isNow = static_cast<int>(row.get(settings)) == of.value;
  return {MainWindow::tr("%1: %2").arg(tableText(row.label), name), isNow ? MainWindow::tr("now") : QString(),
          tableText(stageInfo(row.stage).label),
          qtext(row.path) + QLatin1Char('=') + QString::fromStdString(valueText(row, of.value)),
          isRelevant(row, settings)};
}

} // namespace

void MainWindow::askForPixel() {
  const auto pick = session_.pick();
  const QString now = pick ? QStringLiteral("%1, %2").arg(pick->x).arg(pick->y) : QString();
  auto* prompt = new Prompt(
      tr("Go to pixel (x, y)"), now,
      [this](const QString& text) {
        int x = 0, y = 0;
        if (!parsePair(text, x, y)) return false;
        session_.setPick(glm::ivec2(x, y));
        if (session_.pick()) views_->active()->viewport()->reveal(*session_.pick());
        return true;
      },
      this);
  prompt->open();
}

void MainWindow::askForFrame() {
  const Status& status = session_.status();
  auto* prompt = new Prompt(
      tr("Go to frame (0 to %1)").arg(status.frameCount - 1), QString::number(status.info.frame),
      [this](const QString& text) {
        bool understood = false;
        const int frame = text.trimmed().toInt(&understood);
        if (understood) session_.seek(frame);
        return understood;
      },
      this);
  prompt->open();
}

void MainWindow::askForSize() {
  const Status& status = session_.status();
  auto* prompt = new Prompt(
      tr("Render size (width × height, px)"), QStringLiteral("%1×%2").arg(status.width).arg(status.height),
      [this](const QString& text) {
        int width = 0, height = 0;
        if (!parsePair(text, width, height)) return false;
        session_.setSize(width, height);
        return true;
      },
      this);
  prompt->setHint([this](const QString& text) {
    int width = 0, height = 0;
    if (!parsePair(text, width, height) || width == 0 || height == 0) return tr("width and height");
    return tr("takes %1 of memory").arg(session_.memoryText({width, height}));
  });
  prompt->open();
}

QString MainWindow::presetFolder() const {
  return userPresetFolder(settings_);
}

void MainWindow::askForPresetName() {
  auto* prompt = new Prompt(
      tr("Save these settings as"), {},
      [this](const QString& text) {
        if (text.trimmed().isEmpty()) return false;
        confirmReplace(this, {userPresetPath(presetFolder(), text).toStdString()}, [this, text] {
          session_.savePreset(presetFolder(), text);
          showUserPresets();
        });
        return true;
      },
      this);
  prompt->open();
}

void MainWindow::askForPresetFile() {
  auto* dialog = new QFileDialog(this, tr("Open a preset"), presetFolder(), tr("Presets (*.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, &session_, &Session::setPreset);
  dialog->open();
}

void MainWindow::comparePresets() {
  auto* dialog = new PresetsDialog(session_, presetFolder(), this);
  connect(dialog, &PresetsDialog::userPresetsChanged, this, &MainWindow::showUserPresets);
  dialog->open();
}

void MainWindow::showUserPresets() {
  pipeline_->setUserPresets(userPresets(presetFolder()));
}

void MainWindow::chooseIntermediate(int view) {
  std::vector<ChooserEntry> entries;
  for (const Intermediate& row : kIntermediates)
    entries.push_back(
        {tableText(row.label), tableText(row.unit), tableText(stageInfo(row.stage).label), qtext(row.name)});
  ViewPanel* panel = views_->view(view);
  auto* chooser = new Chooser(
      tr("Search intermediates"), std::move(entries),
      [panel](int index) { panel->setIntermediate(kIntermediates[static_cast<std::size_t>(index)].id); },
      panel);
  const QRect header = panel->header()->geometry();
  chooser->open({header.left() + 2 * kUnit, header.top(), 280, header.height() - 2},
                static_cast<int>(panel->id()));
}

void MainWindow::showCommands() {
  std::vector<ChooserEntry> entries;
  for (const Menus::Command& command : menus_->commands())
    entries.push_back({withoutMnemonic(command.action->text()),
                       keysOf(command.action),
                       command.menu,
                       {},
                       command.action->isEnabled()});
  const std::vector<ParameterValue> values = parameterValues(); // behind the commands
  for (const ParameterValue& value : values) entries.push_back(entryOf(value, session_.settings()));
  auto* chooser = new Chooser(
      tr("Search commands"), std::move(entries),
      [this, values](int index) {
        const auto commands = menus_->commands().size(), at = static_cast<std::size_t>(index);
        if (at < commands) return menus_->commands()[at].action->trigger();
        const ParameterValue& chosen = values[at - commands];
        session_.setParameter(qtext(chosen.row->path), chosen.value);
      },
      this);
  const int left = std::max(0, (width() - 480) / 2);
  chooser->open({left, 0, 480, 48});
}

void MainWindow::showKeys() {
  std::vector<KeyLine> lines;
  for (const Menus::Command& command : menus_->commands())
    if (const QString keys = keysOf(command.action); !keys.isEmpty())
      lines.push_back({command.menu, keys, withoutMnemonic(command.action->text())});
  const auto mouse = [&](const QString& keys, const QString& text) {
    lines.push_back({tr("In a view"), keys, text});
  };
  mouse(tr("Wheel"), tr("Zoom at the cursor"));
  mouse(tr("Left drag"), tr("Pan"));
  mouse(tr("Drag the divider"), tr("Show more of one side; a double click puts it in the middle"));
  mouse(tr("Hold Shift"), tr("Show the other side"));
  mouse(tr("Right click, drag"), tr("Probe a pixel; it stays"));
  mouse(tr("Arrows"), tr("Move the probe by 1 px"));
  mouse(tr("Shift+arrows"), tr("Move the probe by 10 px"));
  lines.push_back({tr("In a number"), tr("Drag, Up, Down, wheel"), tr("Change it (Shift: finer)")});
  lines.push_back({tr("In a number"), tr("Double-click its label"), tr("Back to the preset's value")});
  lines.push_back({tr("In the pipeline"), tr("Ctrl+click"), tr("Show an intermediate in the other view")});
  auto* dialog = new KeysDialog(lines, this);
  dialog->open();
}

} // namespace taa::app
