// View menu: the pages above the timeline.
#include "app/menus/Menus.h"
#include "app/panels/LowerArea.h"
#include "app/panels/PlotsPanel.h"
#include "app/window/MainWindow.h"

#include <QAction>
#include <QMenu>

namespace taa::app {

void Menus::makeLowerPages(QMenu* menu) {
  struct Entry {
    LowerPage page;
    QString text;
    const char* key;
  };
  const Entry entries[] = {{LowerPage::Profiler, tr("Profiler"), "F11"},
                           {LowerPage::Plots, tr("Plots of the probes over frames"), "F6"},
                           {LowerPage::Jitter, tr("Jitter pattern"), "F7"},
                           {LowerPage::Weights, tr("Weights and effective samples"), "Shift+F7"}};
  for (const Entry& entry : entries) {
    QAction* action = addCheck(menu, entry.text, QKeySequence(QLatin1String(entry.key)),
                               [this, page = entry.page](bool on) {
                                 if (window_.lower()->shows(page) != on) window_.setLowerPage(page, on);
                               });
    onRefresh([this, action, page = entry.page] { action->setChecked(window_.lower()->shows(page)); });
  }
  makePlots(menu->addMenu(tr("P&lots")));
}

// They open the page if need be.
void Menus::makePlots(QMenu* menu) {
  const auto addPlot = [this, menu](const QString& text, const QList<QKeySequence>& shortcuts,
                                    void (PlotsPanel::*act)()) {
    return add(menu, text, shortcuts, [this, act] {
      window_.setLowerPage(LowerPage::Plots, true);
      (window_.plots()->*act)();
    });
  };
  addPlot(tr("&Add a plot…"), keys({"Shift+F6"}), &PlotsPanel::chooseRow);
  addPlot(tr("&Fill in the frames that were not shown"), keys({"Ctrl+F6"}), &PlotsPanel::requestFill);
  addPlot(tr("&Show all frames"), keys({"Ctrl+0"}), &PlotsPanel::resetZoom);
  addPlot(tr("&Copy values as CSV"), {}, &PlotsPanel::copyCsv);
  addPlot(tr("Sa&ve values as CSV…"), {}, &PlotsPanel::saveCsv);
}

} // namespace taa::app
