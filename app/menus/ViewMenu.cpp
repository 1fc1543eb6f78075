// Views, panels, how pictures are drawn.
#include "app/menus/Menus.h"

#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/style/Icons.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/window/MainWindow.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

#include <utility>

namespace taa::app {

void Menus::makeView() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&View"));
  ViewArea* views = window_.views();
  add(menu, tr("&Intermediate…"), keys({"I"}),
      [this, views] { window_.chooseIntermediate(views->activeIndex()); });
  add(menu, tr("&Next number of views: one, two, four"), keys({"V"}), [views] { views->showNextCount(); });
  makeViews(menu->addMenu(tr("&Views")));
  makeComparing(menu->addMenu(tr("&Compare")));
  QAction* linked = addCheck(menu, tr("&Look at the same place in all"), QKeySequence(QStringLiteral("L")),
                             [views](bool on) { views->setLinked(on); });
  makeArrangement(menu->addMenu(tr("&Arrangement")));
  menu->addSeparator();
  add(menu, tr("&Fit"), keys({"F"}), [views] {
    views->active()->viewport()->fit();
  })->setIcon(themedIcon(QStringLiteral("fit")));
  add(menu, tr("&One to one"), keys({"1"}), [views] { views->active()->viewport()->oneToOne(); });
  add(menu, tr("Zoom in"), keys({"+", "="}), [views] { views->active()->viewport()->zoomBy(1); });
  add(menu, tr("Zoom out"), keys({"-"}), [views] { views->active()->viewport()->zoomBy(-1); });
  menu->addSeparator();
  QAction* panel = addCheck(menu, tr("Pipeline panel"), QKeySequence(QStringLiteral("F9")),
                            [this](bool on) { window_.setPanelVisible(window_.pipeline(), on); });
  panel->setChecked(true);
  panel = addCheck(menu, tr("Probe panel"), QKeySequence(QStringLiteral("F10")),
                   [this](bool on) { window_.setPanelVisible(window_.probe(), on); });
  panel->setChecked(true);
  makeLowerPages(menu);
  panel = addCheck(menu, tr("Pictures in the headings of stages"), QKeySequence(QStringLiteral("T")),
                   [this](bool on) { window_.pipeline()->setShowsThumbnails(on); });
  panel->setChecked(true);
  menu->addSeparator();
  makePictures(menu->addMenu(tr("&Picture")));
  makeOverlays(menu->addMenu(tr("O&verlays")));
  makeThemes(menu->addMenu(tr("T&heme")));
  onRefresh([views, linked] { linked->setChecked(views->areLinked()); });
}

void Menus::makeArrangement(QMenu* menu) {
  ViewArea* views = window_.views();
  auto* group = new QActionGroup(this);
  const std::pair<Arrangement, QString> choices[] = {{Arrangement::Automatic, tr("Whichever is larger")},
                                                     {Arrangement::Beside, tr("Side by side")},
                                                     {Arrangement::Stacked, tr("One above the other")}};
  for (const auto& [choice, text] : choices) {
    QAction* action = add(menu, text, {}, [views, choice = choice] { views->setArrangement(choice); });
    action->setCheckable(true);
    group->addAction(action);
    onRefresh([views, action, choice = choice] { action->setChecked(views->arrangement() == choice); });
  }
}

void Menus::makePictures(QMenu* menu) {
  ViewArea* views = window_.views();
  add(menu, tr("Brighter by half a stop"), keys({"E"}), [views] { views->active()->changeExposure(0.5f); });
  add(menu, tr("Darker by half a stop"), keys({"Shift+E"}),
      [views] { views->active()->changeExposure(-0.5f); });
  add(menu, tr("&Normalize: fit the range to the visible values"), keys({"N"}), [views] {
    views->active()->normalize();
  })->setIcon(themedIcon(QStringLiteral("auto-range")));
  add(menu, tr("Normalize always"), keys({"Shift+N"}),
      [views] { views->active()->setAlwaysAuto(!views->active()->isAlwaysAuto()); });
  QAction* histogram = addCheck(menu, tr("&Histogram of the visible values"),
                                QKeySequence(QStringLiteral("H")), [views](bool on) {
                                  if (views->active()->showsHistogram() != on)
                                    views->active()->setHistogramShown(on);
                                });
  onRefresh([views, histogram] { histogram->setChecked(views->active()->showsHistogram()); });
  add(menu, tr("&Reset"), keys({"R"}), [views] {
    views->active()->resetStyle();
  })->setIcon(themedIcon(QStringLiteral("reset")));
  add(menu, tr("Next color &map"), keys({"M"}), [views] { views->active()->nextColorMap(); });
  const QString channels[] = {tr("First channel"), tr("Second channel"), tr("Third channel")};
  for (int channel = 0; channel < 3; ++channel)
    add(menu, channels[channel], {QKeySequence(QStringLiteral("Alt+%1").arg(channel + 1))},
        [views, channel] { views->active()->toggleChannel(channel); });
}

void Menus::makeThemes(QMenu* menu) {
  auto* themes = new QActionGroup(this);
  const std::pair<ThemeChoice, QString> looks[] = {{ThemeChoice::System, tr("As the system")},
                                                   {ThemeChoice::Dark, tr("Dark")},
                                                   {ThemeChoice::Light, tr("Light")}};
  for (const auto& [choice, text] : looks) {
    QAction* action = add(menu, text, {}, [this, choice = choice] { window_.setTheme(choice); });
    action->setCheckable(true);
    themes->addAction(action);
    onRefresh([this, action, choice = choice] { action->setChecked(window_.theme() == choice); });
  }
}

} // namespace taa::app
