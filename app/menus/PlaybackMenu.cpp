#include "app/menus/PlaybackMenu.h"

#include "app/commands/GoToPrompts.h"
#include "app/panels/TimelinePanel.h"
#include "app/style/Text.h"

#include <QAction>
#include <QActionGroup>

#include <optional>

namespace taa::app {

PlaybackMenu::PlaybackMenu(Commands& commands, TimelinePanel& timeline, QWidget* parent)
    : CommandMenu(tr("Speed and &range"), commands, parent) {
  add(tr("&Slower"), keys({"Ctrl+["}), [&timeline] { timeline.changeSpeed(-1); });
  add(tr("&Faster"), keys({"Ctrl+]"}), [&timeline] { timeline.changeSpeed(1); });
  addSpeeds(timeline);
  addRates(timeline);
  addSeparator();
  add(tr("Repeat from &here"), keys({"["}), [&timeline] { timeline.setRangeEnd(false); });
  add(tr("Repeat &up to here"), keys({"]"}), [&timeline] { timeline.setRangeEnd(true); });
  QAction* clear = add(tr("Repeat the &whole shot"), keys({"\\"}), [&timeline] { timeline.clearRange(); });
  onRefresh([&timeline, clear] { clear->setEnabled(timeline.playback().range.has_value()); });
}

void PlaybackMenu::addSpeeds(TimelinePanel& timeline) {
  QMenu* menu = addMenu(tr("S&peed"));
  auto* group = new QActionGroup(this);
  for (const double speed : TimelinePanel::speeds()) {
    QAction* action =
        commands_.add(menu, tr("%1×").arg(speed), {}, [&timeline, speed] { timeline.setSpeed(speed); });
    action->setCheckable(true);
    group->addAction(action);
    onRefresh([&timeline, action, speed] { action->setChecked(timeline.playback().speed == speed); });
  }
}

void PlaybackMenu::addRates(TimelinePanel& timeline) {
  QMenu* menu = addMenu(tr("F&rames per second"));
  auto* group = new QActionGroup(this);
  for (const double rate : TimelinePanel::rates()) {
    const QString text = rate > 0.0 ? tr("%1 fps").arg(rate) : tr("The shot's own");
    QAction* action = commands_.add(menu, text, {}, [&timeline, rate] { timeline.setFramesPerSecond(rate); });
    action->setCheckable(true);
    group->addAction(action);
    onRefresh([&timeline, action, rate] { action->setChecked(timeline.playback().framesPerSecond == rate); });
  }
}

MarksMenu::MarksMenu(Commands& commands, TimelinePanel& timeline, GoToPrompts& prompts, QWidget* parent)
    : CommandMenu(tr("&Marks"), commands, parent) {
  add(tr("&Mark this frame, or take its mark away"), keys({"K"}), [&timeline] { timeline.toggleMark(); });
  add(tr("&Name the mark…"), keys({"Shift+K"}), [&prompts] { prompts.askForMarkName(); });
  add(tr("&Previous mark, cut or restart"), keys({"PgUp"}), [&timeline] { timeline.goToMark(false); });
  add(tr("Ne&xt mark, cut or restart"), keys({"PgDown"}), [&timeline] { timeline.goToMark(true); });
}

MetricsMenu::MetricsMenu(Commands& commands, TimelinePanel& timeline, QWidget* parent)
    : CommandMenu(tr("Metr&ic under the timeline"), commands, parent) {
  auto* group = new QActionGroup(this);
  const auto offer = [&](const QString& text, std::optional<Metric> metric) {
    QAction* action = add(text, {}, [&timeline, metric] { timeline.setStripMetric(metric); });
    action->setCheckable(true);
    group->addAction(action);
    onRefresh([&timeline, action, metric] { action->setChecked(timeline.stripMetric() == metric); });
    return action;
  };
  offer(tr("None"), {});
  for (const MetricInfo& info : kMetrics)
    offer(qtext(info.label), info.metric)->setToolTip(qtext(info.description));
  setToolTipsVisible(true);
}

} // namespace taa::app
