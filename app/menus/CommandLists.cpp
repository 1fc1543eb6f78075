#include "app/menus/CommandLists.h"

#include "app/dialogs/KeysDialog.h"
#include "app/menus/Commands.h"
#include "app/session/PresetChoices.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/Chooser.h"
#include "core/taa/SearchedRows.h"

#include <QAction>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

constexpr int kListWidth = 480; ///< px, of texts of 100 %

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
  const SearchedRow searched = searchedValue(row, of.value);
  const bool isNow = static_cast<int>(row.get(settings)) == of.value;
  return {QString::fromStdString(searched.label), isNow ? CommandLists::tr("now") : QString(),
          QString::fromStdString(searched.group), searched, isRelevant(row, settings)};
}

} // namespace

CommandLists::CommandLists(const Commands& commands, PresetChoices& presets, QWidget* window)
    : QObject(window), commands_(commands), presets_(presets), window_(window) {}

void CommandLists::choose() {
  std::vector<ChooserEntry> entries;
  for (const Commands::Command& command : commands_.all())
    entries.push_back({command.name.isEmpty() ? withoutMnemonic(command.action->text()) : command.name,
                       keysOf(command.action),
                       command.menu,
                       {},
                       command.action->isEnabled()});
  const std::vector<ParameterValue> values = parameterValues(); // behind the commands
  for (const ParameterValue& value : values) entries.push_back(entryOf(value, presets_.settings()));
  auto* chooser = new Chooser(
      tr("Search commands"), std::move(entries),
      [this, values](int index) {
        const auto commands = commands_.all().size(), at = static_cast<std::size_t>(index);
        if (at < commands) return commands_.all()[at].action->trigger();
        const ParameterValue& chosen = values[at - commands];
        presets_.setParameter(qtext(chosen.row->path), chosen.value);
      },
      window_);
  const int left = std::max(0, (window_->width() - scaled(kListWidth)) / 2);
  chooser->open({left, 0, kListWidth, 48});
}

void CommandLists::showKeys() {
  std::vector<KeyLine> lines;
  for (const Commands::Command& command : commands_.all())
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
  auto* dialog = new KeysDialog(lines, window_);
  dialog->open();
}

} // namespace taa::app
