#include "app/menus/Commands.h"

#include <QAction>
#include <QVariant>

#include <algorithm>
#include <utility>

namespace taa::app {

QList<QKeySequence> keys(std::initializer_list<const char*> names) {
  QList<QKeySequence> list;
  for (const char* name : names) list << QKeySequence(QLatin1String(name));
  return list;
}

void allow(QAction* action, const QString& whyNot) {
  constexpr const char* kOwn = "ownToolTip";
  if (!action->property(kOwn).isValid()) action->setProperty(kOwn, action->toolTip());
  action->setEnabled(whyNot.isEmpty());
  action->setToolTip(whyNot.isEmpty() ? action->property(kOwn).toString() : whyNot);
}

QAction* Commands::add(QMenu* menu, const QString& text, const QList<QKeySequence>& shortcuts,
                       std::function<void()> act) {
  auto* action = new QAction(text, menu);
  action->setShortcuts(shortcuts);
  connect(action, &QAction::triggered, this, [act = std::move(act)] { act(); });
  menu->addAction(action);
  all_.push_back({menu->title().remove(QLatin1Char('&')), action});
  return action;
}

QAction* Commands::addCheck(QMenu* menu, const QString& text, const QKeySequence& key,
                            std::function<void(bool)> act) {
  QAction* action = add(menu, text, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key}, [] {});
  action->setCheckable(true);
  // Not toggled: that also tells of marks that only follow what is on show.
  connect(action, &QAction::triggered, this, [act = std::move(act)](bool on) { act(on); });
  return action;
}

void Commands::setName(const QAction* action, const QString& name) {
  std::ranges::find(all_, action, &Command::action)->name = name;
}

void Commands::onRefresh(std::function<void()> bringUpToDate) {
  refreshers_.push_back(std::move(bringUpToDate));
}

void Commands::refresh() {
  for (const auto& bringUpToDate : refreshers_) bringUpToDate();
}

CommandMenu::CommandMenu(const QString& title, Commands& commands, QWidget* parent)
    : QMenu(title, parent), commands_(commands) {}

QAction* CommandMenu::add(const QString& text, const QList<QKeySequence>& shortcuts,
                          std::function<void()> act) {
  return commands_.add(this, text, shortcuts, std::move(act));
}

QAction* CommandMenu::addCheck(const QString& text, const QKeySequence& key, std::function<void(bool)> act) {
  return commands_.addCheck(this, text, key, std::move(act));
}

void CommandMenu::onRefresh(std::function<void()> bringUpToDate) {
  commands_.onRefresh(std::move(bringUpToDate));
}

} // namespace taa::app
