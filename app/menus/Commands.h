// Everything that can be asked for by menu or key: everything the mouse does has a key, and every key stands
// in a menu.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QMenu>
#include <QObject>
#include <QString>

#include <functional>
#include <initializer_list>
#include <vector>

class QAction;

namespace taa::app {

/// Keys by their names, "Ctrl+O".
QList<QKeySequence> keys(std::initializer_list<const char*> names);

/// Enables an action, or disables it and says in its tooltip why; empty: there is nothing against it.
void allow(QAction* action, const QString& whyNot);

class Commands : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  struct Command {
    QString menu;
    QAction* action;
    QString name{}; ///< in lists of all commands; empty: the action's text
  };
  /// In the order of the menus.
  const std::vector<Command>& all() const { return all_; }

  QAction* add(QMenu* menu, const QString& text, const QList<QKeySequence>& keys, std::function<void()> act);
  QAction* addCheck(QMenu* menu, const QString& text, const QKeySequence& key, std::function<void(bool)> act);
  /// What a list of all commands calls one whose text says too little outside of its menu.
  void setName(const QAction* action, const QString& name);
  /// What refresh() does for a part of a menu.
  void onRefresh(std::function<void()> bringUpToDate);
  /// Brings checks, texts and lists up to date with what the commands work on.
  void refresh();

 private:
  std::vector<Command> all_;
  std::vector<std::function<void()>> refreshers_;
};

/// A menu that adds its commands to all of them.
class CommandMenu : public QMenu {
  Q_OBJECT
 protected:
  CommandMenu(const QString& title, Commands& commands, QWidget* parent);

  QAction* add(const QString& text, const QList<QKeySequence>& keys, std::function<void()> act);
  QAction* addCheck(const QString& text, const QKeySequence& key, std::function<void(bool)> act);
  void onRefresh(std::function<void()> bringUpToDate);

  Commands& commands_;
};

} // namespace taa::app
