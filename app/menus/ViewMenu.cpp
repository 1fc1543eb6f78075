#include "app/menus/ViewMenu.h"

#include "app/commands/ThemeSetting.h"
#include "app/commands/ViewChoices.h"
#include "app/menus/CompareMenu.h"
#include "app/panels/LeftArea.h"
#include "app/panels/LowerArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/room/Presenter.h"
#include "app/session/SceneChoices.h"
#include "app/style/Icons.h"
#include "app/style/TextSize.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"

#include <QAction>
#include <QActionGroup>

#include <utility>

namespace taa::app {

ViewMenu::ViewMenu(Commands& commands, const Targets& on, QWidget* parent)
    : CommandMenu(tr("&View"), commands, parent) {
  setToolTipsVisible(true);
  addViews(on);
  addSeparator();
  addZoom(on.views);
  addSeparator();
  addPanels(on);
  addSeparator();
  addPictures(on.views);
  addMenu(new OverlayMenu(commands_, on.views, this));
  addThemes(on.theme);
  addTextSizes(on.theme);
  addRoom(on.presenter);
  addMessages(on.messages);
}

void ViewMenu::addViews(const Targets& on) {
  ViewArea& views = on.views;
  add(tr("&Intermediate…"), keys({"I"}),
      [&views, &choices = on.choices] { choices.chooseIntermediate(views.activeIndex()); });
  add(tr("&Next number of views: one, two, four"), keys({"V"}), [&views] { views.showNextCount(); });
  addMenu(new ViewCountMenu(commands_, views, this));
  QAction* maximized = addCheck(tr("The active view a&lone"), QKeySequence(QStringLiteral("Ctrl+M")),
                                [&views](bool isAlone) { views.setMaximized(isAlone); });
  onRefresh([&views, maximized] { maximized->setChecked(views.isMaximized()); });
  addMenu(new CompareMenu(commands_, on.presets, views, on.choices, this));
  QAction* linked = addCheck(tr("&Look at the same place in all"), QKeySequence(QStringLiteral("L")),
                             [&views](bool isLinked) { views.setLinked(isLinked); });
  onRefresh([&views, linked] { linked->setChecked(views.areLinked()); });
  addEngine(on);
  addArrangement(views);
}

void ViewMenu::addEngine(const Targets& on) {
  ViewArea& views = on.views;
  QAction* beside = add(tr("&Ours beside the engine's"), keys({"Ctrl+Shift+U"}), [&views] {
    if (views.viewCount() < 2) views.setViewCount(2);
    views.view(0)->setIntermediate(IntermediateId::resolved);
    views.view(1)->setIntermediate(IntermediateId::engineOutput);
    views.setLinked(true);
  });
  onRefresh([&scene = on.scene, beside] { allow(beside, scene.whyNoEngineOutput()); });
}

void ViewMenu::addZoom(ViewArea& views) {
  add(tr("&Fit"), keys({"F"}), [&views] {
    views.active()->viewport()->fit();
  })->setIcon(themedIcon(QStringLiteral("fit")));
  add(tr("&One to one"), keys({"1"}), [&views] { views.active()->viewport()->oneToOne(); });
  add(tr("Zoom in"), keys({"+", "="}), [&views] { views.active()->viewport()->zoomBy(1); });
  add(tr("Zoom out"), keys({"-"}), [&views] { views.active()->viewport()->zoomBy(-1); });
}

void ViewMenu::addPanels(const Targets& on) {
  QAction* panel = addCheck(tr("Pipeline panel"), QKeySequence(QStringLiteral("F9")),
                            [&left = on.left](bool shown) { left.setShown(shown); });
  onRefresh([&left = on.left, panel] { panel->setChecked(!left.isHidden()); });
  panel = addCheck(tr("Probe panel"), QKeySequence(QStringLiteral("F10")),
                   [&probe = on.probe](bool shown) { probe.setVisible(shown); });
  onRefresh([&probe = on.probe, panel] { panel->setChecked(!probe.isHidden()); });
  addLowerPages(on.lower);
  addPlots(on.lower, on.plots);
  panel = addCheck(tr("Pictures in the headings of stages"), QKeySequence(QStringLiteral("T")),
                   [&pipeline = on.pipeline](bool shown) { pipeline.setShowsThumbnails(shown); });
  panel->setChecked(true);
}

void ViewMenu::addLowerPages(LowerArea& lower) {
  struct Entry {
    LowerPage page;
    QString text;
    const char* key;
  };
  const Entry entries[] = {{LowerPage::Profiler, tr("Profiler"), "Ctrl+Shift+F11"},
                           {LowerPage::Plots, tr("Plots of the probes over frames"), "F6"},
                           {LowerPage::Jitter, tr("Jitter pattern"), "F7"},
                           {LowerPage::Weights, tr("Weights and effective samples"), "Shift+F7"},
                           {LowerPage::Lineage, tr("Samples that the probed pixel is made of"), "Ctrl+F7"},
                           {LowerPage::Doctor, tr("Doctor: what is wrong with the frames"), "Ctrl+F12"}};
  for (const Entry& entry : entries) {
    QAction* action =
        addCheck(entry.text, QKeySequence(QLatin1String(entry.key)), [&lower, page = entry.page](bool on) {
          if (lower.shows(page) != on) lower.setShown(page, on);
        });
    onRefresh([&lower, action, page = entry.page] { action->setChecked(lower.shows(page)); });
  }
}

// Of the probes over frames; their page is opened if need be.
void ViewMenu::addPlots(LowerArea& lower, PlotsPanel& plots) {
  QMenu* menu = addMenu(tr("P&lots"));
  const auto addPlot = [&](const QString& text, const QList<QKeySequence>& shortcuts,
                           void (PlotsPanel::*act)()) {
    commands_.add(menu, text, shortcuts, [&lower, &plots, act] {
      lower.setShown(LowerPage::Plots, true);
      (plots.*act)();
    });
  };
  addPlot(tr("&Add a plot…"), keys({"Shift+F6"}), &PlotsPanel::chooseRow);
  addPlot(tr("&Fill in the frames that were not shown"), keys({"Ctrl+F6"}), &PlotsPanel::requestFill);
  addPlot(tr("&Show all frames"), keys({"Ctrl+0"}), &PlotsPanel::resetZoom);
  addPlot(tr("&Copy values as CSV"), {}, &PlotsPanel::copyCsv);
  addPlot(tr("Sa&ve values as CSV…"), {}, &PlotsPanel::saveCsv);
}

void ViewMenu::addArrangement(ViewArea& views) {
  QMenu* menu = addMenu(tr("&Arrangement"));
  auto* group = new QActionGroup(this);
  const std::pair<Arrangement, QString> choices[] = {{Arrangement::Automatic, tr("Whichever is larger")},
                                                     {Arrangement::Beside, tr("Side by side")},
                                                     {Arrangement::Stacked, tr("One above the other")}};
  for (const auto& [choice, text] : choices) {
    QAction* action =
        commands_.add(menu, text, {}, [&views, choice = choice] { views.setArrangement(choice); });
    action->setCheckable(true);
    group->addAction(action);
    onRefresh([&views, action, choice = choice] { action->setChecked(views.arrangement() == choice); });
  }
}

void ViewMenu::addPictures(ViewArea& views) {
  QMenu* menu = addMenu(tr("&Picture"));
  commands_.add(menu, tr("Brighter by half a stop"), keys({"E"}),
                [&views] { views.active()->changeExposure(0.5f); });
  commands_.add(menu, tr("Darker by half a stop"), keys({"Shift+E"}),
                [&views] { views.active()->changeExposure(-0.5f); });
  commands_
      .add(menu, tr("&Normalize: fit the range to the visible values"), keys({"N"}),
           [&views] { views.active()->normalize(); })
      ->setIcon(themedIcon(QStringLiteral("auto-range")));
  commands_.add(menu, tr("Normalize always"), keys({"Shift+N"}),
                [&views] { views.active()->setAlwaysAuto(!views.active()->isAlwaysAuto()); });
  QAction* histogram = commands_.addCheck(menu, tr("&Histogram of the visible values"),
                                          QKeySequence(QStringLiteral("H")), [&views](bool on) {
                                            if (views.active()->showsHistogram() != on)
                                              views.active()->setHistogramShown(on);
                                          });
  onRefresh([&views, histogram] { histogram->setChecked(views.active()->showsHistogram()); });
  commands_.add(menu, tr("&Reset"), keys({"R"}), [&views] { views.active()->resetStyle(); })
      ->setIcon(themedIcon(QStringLiteral("reset")));
  commands_.add(menu, tr("Next color &map"), keys({"M"}), [&views] { views.active()->nextColorMap(); });
  const QString channels[] = {tr("First channel"), tr("Second channel"), tr("Third channel")};
  for (int channel = 0; channel < 3; ++channel)
    commands_.add(menu, channels[channel], {QKeySequence(QStringLiteral("Alt+%1").arg(channel + 1))},
                  [&views, channel] { views.active()->toggleChannel(channel); });
}

void ViewMenu::addMessages(MessagesBar& messages) {
  add(tr("Messa&ges so far"), keys({"Ctrl+Alt+H"}), [&messages] { messages.showHistory(); });
}

void ViewMenu::addThemes(ThemeSetting& theme) {
  QMenu* menu = addMenu(tr("T&heme"));
  auto* themes = new QActionGroup(this);
  const std::pair<ThemeChoice, QString> looks[] = {{ThemeChoice::System, tr("As the system")},
                                                   {ThemeChoice::Dark, tr("Dark")},
                                                   {ThemeChoice::Light, tr("Light")}};
  for (const auto& [choice, text] : looks) {
    QAction* action = commands_.add(menu, text, {}, [&theme, choice = choice] { theme.choose(choice); });
    action->setCheckable(true);
    themes->addAction(action);
    onRefresh([&theme, action, choice = choice] { action->setChecked(theme.choice() == choice); });
  }
}

void ViewMenu::addTextSizes(ThemeSetting& theme) {
  QMenu* menu = addMenu(tr("Te&xt size"));
  commands_.add(menu, tr("&Larger text"), keys({"Ctrl++", "Ctrl+="}),
                [&theme] { theme.setTextPercent(textPercent() + kTextStep); });
  commands_.add(menu, tr("&Smaller text"), keys({"Ctrl+-"}),
                [&theme] { theme.setTextPercent(textPercent() - kTextStep); });
  menu->addSeparator();
  for (int percent = kMinTextPercent; percent <= kMaxTextPercent; percent += kTextStep) {
    QAction* action = commands_.add(menu, tr("Text at %1 %").arg(percent), {},
                                    [&theme, percent] { theme.setTextPercent(percent); });
    action->setCheckable(true);
    onRefresh([action, percent] { action->setChecked(textPercent() == percent); });
  }
}

void ViewMenu::addRoom(Presenter& presenter) {
  QAction* full = addCheck(tr("F&ull screen"), QKeySequence(QStringLiteral("F11")),
                           [&presenter](bool on) { presenter.setFullScreen(on); });
  QAction* presents =
      addCheck(tr("Present to a &room: pictures and the lesson alone, large text"),
               QKeySequence(QStringLiteral("Ctrl+F11")), [&presenter](bool on) { presenter.setOn(on); });
  onRefresh([&presenter, full, presents] {
    full->setChecked(presenter.isFullScreen());
    presents->setChecked(presenter.isOn());
  });
}

} // namespace taa::app
