// View menu: the pages above the timeline.
#include "app/MainWindow.h"
#include "app/menus/Menus.h"
#include "app/panels/LowerArea.h"

#include <QAction>

namespace taa::app {

void Menus::makeLowerPages(QMenu* menu) {
  struct Entry {
    LowerPage page;
    QString text;
    const char* key;
  };
  const Entry entries[] = {{LowerPage::Profiler, tr("Profiler"), "F11"},
                           {LowerPage::Jitter, tr("Jitter pattern"), "F7"},
                           {LowerPage::Weights, tr("Weights and effective samples"), "F8"}};
  for (const Entry& entry : entries) {
    QAction* action = addCheck(menu, entry.text, QKeySequence(QLatin1String(entry.key)),
                               [this, page = entry.page](bool on) {
                                 if (window_.lower()->shows(page) != on) window_.setLowerPage(page, on);
                               });
    onRefresh([this, action, page = entry.page] { action->setChecked(window_.lower()->shows(page)); });
  }
}

} // namespace taa::app
