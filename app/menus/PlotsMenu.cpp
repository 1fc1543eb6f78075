#include "app/menus/PlotsMenu.h"

#include "app/panels/LowerArea.h"
#include "app/panels/PlotsPanel.h"

namespace taa::app {

PlotsMenu::PlotsMenu(Commands& commands, LowerArea& lower, PlotsPanel& plots, QWidget* parent)
    : CommandMenu(tr("P&lots"), commands, parent) {
  const auto addPlot = [&](const QString& text, const QList<QKeySequence>& shortcuts,
                           void (PlotsPanel::*act)()) {
    add(text, shortcuts, [&lower, &plots, act] {
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

} // namespace taa::app
