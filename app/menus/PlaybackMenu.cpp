// Frame menu: speed, the part that is repeated, and the marks.
#include "app/menus/Menus.h"
#include "app/panels/TimelinePanel.h"
#include "app/style/Text.h"
#include "app/window/MainWindow.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include <optional>

namespace taa::app {

void Menus::makePlayback(QMenu* menu) {
  TimelinePanel* timeline = window_.timeline();
  add(menu, tr("&Slower"), keys({"Ctrl+["}), [timeline] { timeline->changeSpeed(-1); });
  add(menu, tr("&Faster"), keys({"Ctrl+]"}), [timeline] { timeline->changeSpeed(1); });
  QMenu* speeds = menu->addMenu(tr("S&peed"));
  auto* speedGroup = new QActionGroup(this);
  for (const double speed : TimelinePanel::speeds()) {
    QAction* action = add(speeds, tr("%1×").arg(speed), {}, [timeline, speed] { timeline->setSpeed(speed); });
    action->setCheckable(true);
    speedGroup->addAction(action);
    onRefresh([timeline, action, speed] { action->setChecked(timeline->playback().speed == speed); });
  }
  QMenu* rates = menu->addMenu(tr("F&rames per second"));
  auto* rateGroup = new QActionGroup(this);
  for (const double rate : TimelinePanel::rates()) {
    const QString text = rate > 0.0 ? tr("%1 fps").arg(rate) : tr("The shot's own");
    QAction* action = add(rates, text, {}, [timeline, rate] { timeline->setFramesPerSecond(rate); });
    action->setCheckable(true);
    rateGroup->addAction(action);
    onRefresh([timeline, action, rate] { action->setChecked(timeline->playback().framesPerSecond == rate); });
  }
  menu->addSeparator();
  add(menu, tr("Repeat from &here"), keys({"["}), [timeline] { timeline->setRangeEnd(false); });
  add(menu, tr("Repeat &up to here"), keys({"]"}), [timeline] { timeline->setRangeEnd(true); });
  QAction* clear =
      add(menu, tr("Repeat the &whole shot"), keys({"\\"}), [timeline] { timeline->clearRange(); });
  onRefresh([timeline, clear] { clear->setEnabled(timeline->playback().range.has_value()); });
}

void Menus::makeFigures(QMenu* menu) {
  TimelinePanel* timeline = window_.timeline();
  auto* group = new QActionGroup(this);
  const auto offer = [&](const QString& text, std::optional<Figure> figure) {
    QAction* action = add(menu, text, {}, [timeline, figure] { timeline->setFigure(figure); });
    action->setCheckable(true);
    group->addAction(action);
    onRefresh([timeline, action, figure] { action->setChecked(timeline->figure() == figure); });
    return action;
  };
  offer(tr("None"), {});
  for (const FigureInfo& info : kFigures)
    offer(tableText(info.label), info.figure)->setToolTip(tableText(info.description));
  menu->setToolTipsVisible(true);
}

void Menus::makeFrameMarks(QMenu* menu) {
  TimelinePanel* timeline = window_.timeline();
  add(menu, tr("&Mark this frame, or take its mark away"), keys({"K"}),
      [timeline] { timeline->toggleMark(); });
  add(menu, tr("&Name the mark…"), keys({"Shift+K"}), [this] { window_.askForMarkName(); });
  add(menu, tr("&Previous mark, cut or restart"), keys({"PgUp"}), [timeline] { timeline->goToMark(false); });
  add(menu, tr("Ne&xt mark, cut or restart"), keys({"PgDown"}), [timeline] { timeline->goToMark(true); });
}

} // namespace taa::app
