// What all menus have in common.
#include "app/menus/Menus.h"

#include "app/window/MainWindow.h"

#include <QAction>
#include <QMenu>

#include <utility>

namespace taa::app {

QList<QKeySequence> keys(std::initializer_list<const char*> names) {
  QList<QKeySequence> list;
  for (const char* name : names) list << QKeySequence(QLatin1String(name));
  return list;
}

Menus::Menus(MainWindow& window) : QObject(&window), window_(window) {
  makeFile();
  makeEdit();
  makeView();
  makeFrame();
  makeScene();
  makePipeline();
  makeProbe();
  makeHelp();
  refresh();
}

QAction* Menus::add(QMenu* menu, const QString& text, const QList<QKeySequence>& shortcuts,
                    std::function<void()> act) {
  auto* action = new QAction(text, menu);
  action->setShortcuts(shortcuts);
  connect(action, &QAction::triggered, this, [act = std::move(act)] { act(); });
  menu->addAction(action);
  commands_.push_back({menu->title().remove(QLatin1Char('&')), action});
  return action;
}

QAction* Menus::addCheck(QMenu* menu, const QString& text, const QKeySequence& key,
                         std::function<void(bool)> act) {
  QAction* action = add(menu, text, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key}, [] {});
  action->setCheckable(true);
  // Not toggled: that also tells of marks that only follow what is on show.
  connect(action, &QAction::triggered, this, [act = std::move(act)](bool on) { act(on); });
  return action;
}

void Menus::onRefresh(std::function<void()> bringUpToDate) {
  refreshers_.push_back(std::move(bringUpToDate));
}

void Menus::refresh() {
  for (const auto& bringUpToDate : refreshers_) bringUpToDate();
}

} // namespace taa::app
