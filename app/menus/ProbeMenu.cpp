// The probes: where they are pinned, which is active, what it follows.
#include "app/menus/Menus.h"

#include "app/panels/ProbePanel.h"
#include "app/style/Icons.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/plots/ColorSpaceView.h"
#include "app/views/plots/ProbePages.h"
#include "app/window/MainWindow.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include <cstddef>

namespace taa::app {

void Menus::makeProbe() {
  QMenu* menu = window_.menuBar()->addMenu(tr("Pr&obe"));
  add(menu, tr("&Go to pixel…"), keys({"Ctrl+G"}), [this] {
    window_.askForPixel();
  })->setIcon(themedIcon(QStringLiteral("probe")));
  add(menu, tr("Go to the probe"), keys({"P"}), [this] {
    if (const auto pick = window_.session().pick()) window_.views()->active()->viewport()->reveal(*pick);
  });
  Session& session = window_.session();
  add(menu, tr("&Remove the probe"), keys({"Del"}), [&session] { session.setPick({}); });
  add(menu, tr("Remove &all probes"), keys({"Shift+Esc"}), [&session] { session.removeAllPins(); });
  menu->addSeparator();
  add(menu, tr("&Pin another under the mouse or beside"), keys({"Shift+P"}),
      [this] { window_.pinAnother(); });
  const auto choose = [&session](int step) {
    const int count = static_cast<int>(session.pins().size());
    if (count > 0) session.setActivePin((session.activePin() + step + count) % count);
  };
  add(menu, tr("Ne&xt probe"), keys({"Ctrl+N"}), [choose] { choose(1); });
  add(menu, tr("Previo&us probe"), keys({"Ctrl+Shift+N"}), [choose] { choose(-1); });
  QAction* follows = addCheck(
      menu, tr("Follow the &surface"), QKeySequence(QStringLiteral("Ctrl+Alt+F")),
      [&session](bool on) { session.setFollow(session.activePin(), on ? Follow::Surface : Follow::Screen); });
  menu->addSeparator();
  makeProbePages(menu);
  onRefresh([&session, follows] {
    const int pin = session.activePin();
    follows->setEnabled(pin >= 0);
    follows->setChecked(pin >= 0 && session.pins()[static_cast<std::size_t>(pin)].follow == Follow::Surface);
  });
}

void Menus::makeProbePages(QMenu* menu) {
  add(menu, tr("&Values"), keys({"F2"}), [this] { window_.setProbeTab(ProbeTab::Values); });
  add(menu, tr("&Color space"), keys({"F3"}), [this] { window_.setProbeTab(ProbeTab::ColorSpace); });
  add(menu, tr("&What if"), keys({"F4"}), [this] { window_.setProbeTab(ProbeTab::WhatIf); });
  QMenu* plot = menu->addMenu(tr("Color space p&lot"));
  const auto page = [this] { return window_.probe()->colorSpace(); };
  add(plot, tr("&RGB or YCoCg"), keys({"Ctrl+Alt+C"}),
      [page] { page()->setSpace(page()->space() == PlotSpace::Rgb ? PlotSpace::YCoCg : PlotSpace::Rgb); });
  add(plot, tr("Turn &left"), keys({"Ctrl+Alt+Left"}), [page] { page()->view()->turnBy(-1, 0); });
  add(plot, tr("Turn &right"), keys({"Ctrl+Alt+Right"}), [page] { page()->view()->turnBy(1, 0); });
  add(plot, tr("Turn &up"), keys({"Ctrl+Alt+Up"}), [page] { page()->view()->turnBy(0, -1); });
  add(plot, tr("Turn &down"), keys({"Ctrl+Alt+Down"}), [page] { page()->view()->turnBy(0, 1); });
  add(plot, tr("Turn &back"), keys({"Ctrl+Alt+Home"}), [page] { page()->view()->resetTurn(); });
}

} // namespace taa::app
