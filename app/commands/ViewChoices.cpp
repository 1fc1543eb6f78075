#include "app/commands/ViewChoices.h"

#include "app/session/Session.h"
#include "app/session/UserPresets.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/Prompt.h"
#include "core/settings/Presets.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

/// What a chosen line of the list means; nothing: the number of a frame is asked for.
struct ComparisonChoice {
  ChooserEntry entry;
  std::optional<Comparison> comparison;
};

void addPresets(std::vector<ComparisonChoice>& choices, const QString& group, const QString& folder) {
  QString heading = group;
  for (const Preset& preset : builtinPresets()) {
    if (const PresetGroup* started = startedGroup(preset))
      heading = QObject::tr("%1: %2").arg(group, qtext(started->label));
    choices.push_back({{qtext(preset.label), {}, heading, {.id = preset.id}},
                       Comparison{OtherKind::Preset, {}, preset.id}});
  }
  for (const UserPreset& preset : userPresets(folder))
    choices.push_back(
        {{preset.label, {}, group, {}}, Comparison{OtherKind::Preset, {}, preset.path.toStdString()}});
}

} // namespace

ViewChoices::ViewChoices(Session& session, ViewArea& views, const QString& presetFolder, QWidget* window)
    : QObject(window), session_(session), views_(views), presetFolder_(presetFolder), window_(window) {
  connect(&views_, &ViewArea::intermediateRequested, this, &ViewChoices::chooseIntermediate);
  connect(&views_, &ViewArea::comparisonRequested, this, &ViewChoices::chooseComparison);
}

void ViewChoices::chooseIntermediate(int view) {
  std::vector<ChooserEntry> entries;
  for (const Intermediate& row : kIntermediates) entries.push_back(intermediateEntry(row));
  ViewPanel* panel = views_.view(view);
  auto* chooser = new Chooser(
      tr("Search intermediates"), std::move(entries),
      [panel](int index) { panel->setIntermediate(kIntermediates[static_cast<std::size_t>(index)].id); },
      panel);
  const QRect header = panel->header()->geometry();
  chooser->open({header.left() + 2 * kUnit, header.top(), 280, header.height() - 2},
                static_cast<int>(panel->id()));
}

void ViewChoices::chooseComparison(int view) {
  std::vector<ComparisonChoice> choices;
  choices.push_back({{tr("Nothing"), {}, {}, {}}, Comparison{}});
  addPresets(choices, tr("The same with another preset"), presetFolder_);
  const QString frames = tr("The same in another frame");
  choices.push_back(
      {{tr("The frame before"), {}, frames, {}}, Comparison{OtherKind::FramesBefore, {}, {}, 1}});
  choices.push_back(
      {{tr("The frame before, along the motion"), {}, frames, {}}, Comparison{OtherKind::AlongMotion}});
  choices.push_back({{tr("This frame, kept while others are shown"), {}, frames, {}},
                     Comparison{OtherKind::Frame, {}, {}, session_.status().info.frame}});
  choices.push_back({{tr("Another frame…"), {}, frames, {}}, {}});
  for (const Intermediate& row : kIntermediates)
    choices.push_back({intermediateEntry(row), Comparison{OtherKind::Row, row.id}});
  ViewPanel* panel = views_.view(view);
  std::vector<ChooserEntry> entries;
  int current = -1;
  for (std::size_t index = 0; index < choices.size(); ++index) {
    entries.push_back(choices[index].entry);
    if (choices[index].comparison == panel->comparison()) current = static_cast<int>(index);
  }
  auto* chooser = new Chooser(
      tr("Compare with"), std::move(entries),
      [this, panel, view, choices](int index) {
        const auto& comparison = choices[static_cast<std::size_t>(index)].comparison;
        if (comparison)
          panel->setComparison(*comparison);
        else
          askForComparedFrame(view);
      },
      panel);
  const QRect header = panel->header()->geometry();
  chooser->open({header.left() + 2 * kUnit, header.top(), 320, header.height() - 2}, current);
}

void ViewChoices::askForComparedFrame(int view) {
  const Status& status = session_.status();
  ViewPanel* panel = views_.view(view);
  auto* prompt = new Prompt(
      tr("Compare with frame (0 to %1)").arg(status.frameCount - 1), QString::number(status.info.frame),
      [this, panel](const QString& text) {
        bool understood = false;
        const int frame = text.trimmed().toInt(&understood);
        if (!understood || frame < 0 || frame >= session_.status().frameCount) return false;
        panel->setComparison({OtherKind::Frame, {}, {}, frame});
        return true;
      },
      window_);
  prompt->open();
}

} // namespace taa::app
