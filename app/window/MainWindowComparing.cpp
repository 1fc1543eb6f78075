// What the window does for views with two sides: lists to choose from, values of both under the mouse.
#include "app/window/MainWindow.h"

#include "app/panels/StatusLine.h"
#include "app/session/UserPresets.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/Prompt.h"
#include "core/settings/Presets.h"
#include "core/taa/twin/Known.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

/// What a chosen line of the list means; nothing: the number of a frame is asked for.
struct Choice {
  ChooserEntry entry;
  std::optional<Comparison> comparison;
};

void addPresets(std::vector<Choice>& choices, const QString& group, const QString& folder) {
  QString heading = group;
  for (const Preset& preset : builtinPresets()) {
    const QString id = QString::fromStdString(preset.id);
    if (const PresetGroup* started = startedGroup(preset))
      heading = QObject::tr("%1: %2").arg(group, tableText(started->label));
    choices.push_back(
        {{tableText(preset.label), {}, heading, id}, Comparison{OtherKind::Preset, {}, preset.id}});
  }
  for (const UserPreset& preset : userPresets(folder))
    choices.push_back(
        {{preset.label, {}, group, {}}, Comparison{OtherKind::Preset, {}, preset.path.toStdString()}});
}

} // namespace

void MainWindow::connectComparing() {
  // Lanes first: what is asked of them waits until they are there.
  connect(views_, &ViewArea::requestsChanged, this, [this] {
    session_.setOtherPresets(views_->comparedPresets());
    views_->setSpaces(session_.settings().space, session_.otherLanes());
    session_.setViews(views_->requests());
  });
  connect(views_, &ViewArea::comparisonRequested, this, &MainWindow::chooseComparison);
}

void MainWindow::chooseComparison(int view) {
  std::vector<Choice> choices;
  choices.push_back({{tr("Nothing"), {}, {}, {}}, Comparison{}});
  addPresets(choices, tr("The same with another preset"), presetFolder());
  const QString frames = tr("The same in another frame");
  choices.push_back(
      {{tr("The frame before"), {}, frames, {}}, Comparison{OtherKind::FramesBefore, {}, {}, 1}});
  choices.push_back({{tr("This frame, kept while others are shown"), {}, frames, {}},
                     Comparison{OtherKind::Frame, {}, {}, session_.status().info.frame}});
  choices.push_back({{tr("Another frame…"), {}, frames, {}}, {}});
  for (const Intermediate& row : kIntermediates)
    choices.push_back(
        {{tableText(row.label), tableText(row.unit), tableText(stageInfo(row.stage).label), qtext(row.name)},
         Comparison{OtherKind::Row, row.id}});
  ViewPanel* panel = views_->view(view);
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

void MainWindow::askForComparedFrame(int view) {
  const Status& status = session_.status();
  ViewPanel* panel = views_->view(view);
  auto* prompt = new Prompt(
      tr("Compare with frame (0 to %1)").arg(status.frameCount - 1), QString::number(status.info.frame),
      [this, panel](const QString& text) {
        bool understood = false;
        const int frame = text.trimmed().toInt(&understood);
        if (!understood || frame < 0 || frame >= session_.status().frameCount) return false;
        panel->setComparison({OtherKind::Frame, {}, {}, frame});
        return true;
      },
      this);
  prompt->open();
}

void MainWindow::showHover(int view) {
  const Viewport* viewport = views_->view(view)->viewport();
  const auto pixel = viewport->hovered();
  if (!pixel) return statusLine_->setHover({});
  QString text =
      QStringLiteral("%1 (%2, %3)").arg(QChar(static_cast<char16_t>('A' + view))).arg(pixel->x).arg(pixel->y);
  const auto add = [&](const std::optional<std::vector<float>>& values, IntermediateId id,
                       const QString& before) {
    if (!values) return;
    const auto count = std::min(values->size(), static_cast<std::size_t>(intermediate(id).channels));
    const bool isNone = isOfHistory(id) && session_.status().info.startsHistory;
    text += before + (isNone ? tr("no history yet") : tupleText(std::span(*values).first(count), 5));
  };
  const ViewPanel* panel = views_->view(view);
  add(viewport->valueAt(*pixel), panel->id(),
      panel->isDifference() ? tr("  difference ") : QStringLiteral("  "));
  const Comparison& comparison = panel->comparison();
  add(viewport->otherValueAt(*pixel), comparison.kind == OtherKind::Row ? comparison.id : panel->id(),
      tr("  other "));
  statusLine_->setHover(text);
}

} // namespace taa::app
