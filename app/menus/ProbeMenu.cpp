#include "app/menus/ProbeMenu.h"

#include "app/commands/GoToPrompts.h"
#include "app/commands/ProbeCommands.h"
#include "app/dialogs/MapDialog.h"
#include "app/panels/ProbePanel.h"
#include "app/session/ProbeChoices.h"
#include "app/session/SceneChoices.h"
#include "app/session/Session.h"
#include "app/session/VerdictChoices.h"
#include "app/style/Icons.h"
#include "app/views/MeasuredRegion.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/plots/ColorSpacePage.h"
#include "app/views/plots/ColorSpaceView.h"
#include "app/views/plots/SensitivityPage.h"
#include "app/views/plots/WhatIfPage.h"
#include "app/widgets/ValueTable.h"
#include "app/widgets/probe/VerdictDetails.h"

#include <QAction>

#include <array>
#include <cstddef>
#include <utility>

namespace taa::app {

ProbeMenu::ProbeMenu(Commands& commands, const Targets& on, QWidget* parent)
    : CommandMenu(tr("Pr&obe"), commands, parent) {
  setToolTipsVisible(true);
  addPlaces(on);
  addSeparator();
  addProbes(on);
  addSeparator();
  addWorst(on.probe);
  addSeparator();
  addRegion(on);
  addSeparator();
  addVerdicts(on);
  addRemedies(on.verdicts);
  addSeparator();
  addPages(on.panel, on.session);
  addPlot(on.panel);
}

void ProbeMenu::addPlaces(const Targets& on) {
  ProbeChoices& probes = on.probes;
  add(tr("&Go to pixel…"), keys({"Ctrl+G"}), [&prompts = on.prompts] {
    prompts.askForPixel();
  })->setIcon(themedIcon(QStringLiteral("probe")));
  add(tr("Go to the probe"), keys({"P"}), [&probes, &views = on.views] {
    if (const auto probed = probes.pixel()) views.active()->viewport()->reveal(*probed);
  });
  add(tr("&Remove the probe"), keys({"Del"}), [&probes] { probes.setPixel({}); });
  add(tr("Remove &all probes"), keys({"Shift+Esc"}), [&probes] { probes.removeAll(); });
}

void ProbeMenu::addProbes(const Targets& on) {
  ProbeChoices& probes = on.probes;
  add(tr("Add ano&ther under the mouse or beside"), keys({"Shift+P"}),
      [&probe = on.probe, &prompts = on.prompts] {
        if (!probe.addAnother()) prompts.askForPixel();
      });
  const auto choose = [&probes](int step) {
    const int count = static_cast<int>(probes.all().size());
    if (count > 0) probes.setActive((probes.active() + step + count) % count);
  };
  add(tr("Ne&xt probe"), keys({"Ctrl+N"}), [choose] { choose(1); });
  add(tr("Previo&us probe"), keys({"Ctrl+Shift+N"}), [choose] { choose(-1); });
  QAction* follows = addCheck(
      tr("Follow the &surface"), QKeySequence(QStringLiteral("Ctrl+Alt+F")), [&probes](bool isOnSurface) {
        probes.setFollow(probes.active(), isOnSurface ? Follow::Surface : Follow::Screen);
      });
  onRefresh([&probes, &scene = on.scene, follows] {
    const int probe = probes.active();
    allow(follows, scene.whyNoSurfaces());
    if (probe < 0) follows->setEnabled(false);
    follows->setChecked(probe >= 0 &&
                        probes.all()[static_cast<std::size_t>(probe)].follow == Follow::Surface);
  });
}

void ProbeMenu::addWorst(ProbeCommands& probe) {
  add(tr("Go to the next &worst pixel"), keys({"Shift+W"}), [&probe] { probe.goToNextWorst(); })
      ->setToolTip(tr("By the error, the class of a verdict or the reject reason that the active view shows, "
                      "else by the absolute error"));
  add(tr("Go to the worst pixel of the &next class"), keys({"Alt+W"}),
      [&probe] { probe.goToNextWorst(WorstStep::Category); })
      ->setToolTip(tr("Of the classes of the verdict or the reject reasons that the active view shows, those "
                      "that are in it"));
  add(tr("Go to the next re&jected pixel"), keys({"Alt+J"}),
      [&probe] { probe.goToNextWorst(WorstStep::Rejected); })
      ->setToolTip(tr("Where validation rejected history: the largest error first where the reference is "
                      "drawn, else from above"));
  add(tr("Go to the next clipped pixel"), keys({"Alt+Shift+J"}), [&probe] {
    probe.goToNextWorst(WorstStep::Clipped);
  })->setToolTip(tr("Where rectification moved history, the farthest first"));
  add(tr("Go to the next NaN or infinite pixel"), keys({"Alt+X"}), [&probe] {
    probe.goToNextWorst(WorstStep::NoNumber);
  })->setToolTip(tr("Of what the active view shows"));
}

void ProbeMenu::addRegion(const Targets& on) {
  ViewArea& views = on.views;
  add(tr("Statistics of a re&gion…"), keys({"Ctrl+Shift+G"}), [&prompts = on.prompts] {
    prompts.askForRegion();
  })->setToolTip(tr("Or drag with Ctrl held over a picture; a click with Ctrl held removes it"));
  add(tr("Statistics of what is visi&ble, or none"), keys({"Shift+H"}), [&views] {
    MeasuredRegion* measured = views.active()->measured();
    if (measured->region())
      measured->set({});
    else
      measured->setToVisible();
  });
  QAction* copies =
      add(tr("Copy the stat&istics"), keys({"Ctrl+Alt+I"}), [&views] { views.active()->measured()->copy(); });
  onRefresh([&views, copies] {
    allow(copies, views.active()->measured()->region() ? QString() : tr("No region is measured"));
  });
}

void ProbeMenu::addVerdicts(const Targets& on) {
  VerdictChoices& verdicts = on.verdicts;
  QAction* shows = addCheck(tr("Ver&dict on the pixel"), QKeySequence(QStringLiteral("Ctrl+Shift+V")),
                            [&verdicts](bool isOn) { verdicts.setOn(isOn); });
  shows->setToolTip(
      tr("Says what is wrong with the probed pixel of each frame that playing stops at, and why"));
  QAction* unfolds = add(tr("Unfold or fold its &evidence"), keys({"Shift+F2"}), [&panel = on.panel] {
    panel.openTab(ProbeTab::Values);
    panel.verdictDetails()->setUnfolded(!panel.verdictDetails()->isUnfolded());
  });
  QAction* copies =
      add(tr("Cop&y the verdict"), keys({"Ctrl+Alt+V"}), [&probe = on.probe] { probe.copyVerdict(); });
  onRefresh([&verdicts, shows, unfolds, copies] {
    shows->setChecked(verdicts.areOn());
    const VerdictDelivery* verdict = verdicts.verdict();
    const QString whyNot =
        verdict && verdict->answer ? QString() : tr("There is no verdict on the probed pixel, or not yet");
    allow(unfolds, whyNot);
    allow(copies, whyNot);
  });
}

void ProbeMenu::addRemedies(VerdictChoices& verdicts) {
  const std::array<std::pair<QString, const char*>, kMaxRemedies> kRemedies{
      {{tr("Try the &first remedy"), "Ctrl+T"},
       {tr("Try the second re&medy"), "Ctrl+Shift+T"},
       {tr("Try t&he third remedy"), "Ctrl+Alt+T"}}};
  for (std::size_t remedy = 0; remedy < kMaxRemedies; ++remedy) {
    const auto isThere = [&verdicts, remedy] { return remedy < verdicts.remedies().size(); };
    QAction* tries =
        add(kRemedies[remedy].first, keys({kRemedies[remedy].second}), [&verdicts, remedy, isThere] {
          if (isThere()) verdicts.apply(remedy);
        });
    onRefresh([tries, isThere] {
      allow(tries, isThere() ? QString() : tr("No such remedy is known for the probed pixel, or not yet"));
    });
  }
}

void ProbeMenu::addPages(ProbePanel& panel, Session& session) {
  add(tr("&Values"), keys({"F2"}), [&panel] { panel.openTab(ProbeTab::Values); });
  add(tr("&Color space"), keys({"F3"}), [&panel] { panel.openTab(ProbeTab::ColorSpace); });
  const auto openWhatIf = [&panel] {
    panel.openTab(ProbeTab::WhatIf);
    panel.whatIf()->table()->setFocus();
  };
  add(tr("&What if"), keys({"F4"}), openWhatIf)
      ->setToolTip(tr("Arrows choose one of the other choices, Enter tries it"));
  add(tr("&Sensitivity"), keys({"Shift+F3"}), [&panel] {
    panel.openTab(ProbeTab::Sensitivity);
    panel.sensitivity()->table()->setFocus();
  })->setToolTip(tr("How much the pixel moves with each sample, each texel of history and each number"));
  const auto openMap = [&session, window = parentWidget()->window()](const QString& path) {
    if (session.isOpen()) MapDialog::openAt(session, path, window);
  };
  connect(panel.sensitivity(), &SensitivityPage::mapRequested, this, openMap);
  add(tr("Where a &number matters…"), {}, [openMap] {
    openMap({});
  })->setToolTip(tr("How much each pixel of the frame moves with a number of the settings"));
  add(tr("Measure the pictures of w&hat if"), keys({"Ctrl+F4"}), [&panel, openWhatIf] {
    openWhatIf();
    Q_EMIT panel.whatIf()->measuringRequested();
  });
  add(tr("Draw the re&ference that what if is sorted by"), keys({"Shift+F4"}), [&panel, openWhatIf] {
    openWhatIf();
    Q_EMIT panel.whatIf()->referenceRequested();
  });
}

void ProbeMenu::addPlot(ProbePanel& panel) {
  QMenu* menu = addMenu(tr("Color space p&lot"));
  ColorSpacePage* page = panel.colorSpace();
  commands_.add(menu, tr("&RGB or YCoCg"), keys({"Ctrl+Alt+C"}), [page] {
    page->setSpace(page->space() == PlotSpace::Rgb ? PlotSpace::YCoCg : PlotSpace::Rgb);
  });
  commands_.add(menu, tr("In a &window of its own"), keys({"Ctrl+F3"}), [page] { page->openWindow(); });
  const auto addTurn = [&](const QString& text, const char* key, int right, int down) {
    commands_.add(menu, text, keys({key}), [page, right, down] { page->view()->turnBy(right, down); });
  };
  addTurn(tr("Turn &left"), "Ctrl+Alt+Left", -1, 0);
  addTurn(tr("Turn &right"), "Ctrl+Alt+Right", 1, 0);
  addTurn(tr("Turn &up"), "Ctrl+Alt+Up", 0, -1);
  addTurn(tr("Turn &down"), "Ctrl+Alt+Down", 0, 1);
  commands_.add(menu, tr("Turn &back"), keys({"Ctrl+Alt+Home"}), [page] { page->view()->resetTurn(); });
}

} // namespace taa::app
