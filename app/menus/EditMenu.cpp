#include "app/menus/EditMenu.h"

#include "app/commands/EscapeKey.h"
#include "app/commands/Exports.h"
#include "app/commands/ProbeCommands.h"
#include "app/menus/CommandLists.h"
#include "app/panels/LeftArea.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProfilerPanel.h"
#include "app/session/Session.h"
#include "app/style/Icons.h"

#include <QAction>

namespace taa::app {

EditMenu::EditMenu(Commands& commands, const Targets& on, QWidget* parent)
    : CommandMenu(tr("&Edit"), commands, parent) {
  addUndo(on.session);
  add(tr("End what is under wa&y, or remove the probe"), keys({"Esc"}),
      [&escape = on.escape] { escape.press(); });
  addSeparator();
  addCopies(on);
  addSeparator();
  add(tr("&Search settings and intermediates"), keys({"Ctrl+F"}), [&left = on.left, &pipeline = on.pipeline] {
    left.openPage(LeftPage::Pipeline);
    pipeline.focusSearch();
  })->setIcon(themedIcon(QStringLiteral("search")));
  add(tr("&Find a command…"), keys({"Ctrl+Shift+P"}), [&lists = on.lists] { lists.choose(); });
}

void EditMenu::addUndo(Session& session) {
  QAction* undo = add(tr("&Undo"), keys({"Ctrl+Z"}), [&session] { session.undo(); });
  QAction* redo = add(tr("&Redo"), keys({"Ctrl+Shift+Z"}), [&session] { session.redo(); });
  onRefresh([&session, undo, redo] {
    const UndoStack& stack = session.undoStack();
    const auto named = [](const QString& what) { return QString(what).replace(u'&', QStringLiteral("&&")); };
    undo->setEnabled(stack.canUndo());
    undo->setText(stack.canUndo() ? tr("&Undo: %1").arg(named(stack.undoText())) : tr("&Undo"));
    redo->setEnabled(stack.canRedo());
    redo->setText(stack.canRedo() ? tr("&Redo: %1").arg(named(stack.redoText())) : tr("&Redo"));
  });
}

void EditMenu::addCopies(const Targets& on) {
  ProbeCommands& probe = on.probe;
  Exports& exports = on.exports;
  add(tr("&Copy probed value"), keys({"Ctrl+C"}), [&probe] {
    probe.copyValue();
  })->setIcon(themedIcon(QStringLiteral("copy")));
  add(tr("Copy &all probed values"), keys({"Ctrl+Shift+C"}), [&probe] { probe.copy(ProbeFormat::Text); });
  add(tr("Copy the probe as &Markdown"), keys({"Ctrl+Alt+M"}),
      [&probe] { probe.copy(ProbeFormat::Markdown); });
  add(tr("Copy the probe as &JSON"), keys({"Ctrl+Alt+J"}), [&probe] { probe.copy(ProbeFormat::Json); });
  add(tr("Copy the &picture of the view"), keys({"Ctrl+Alt+P"}), [&exports] { exports.copyView(false); });
  add(tr("Copy it with its le&gend"), keys({"Ctrl+Alt+Shift+P"}), [&exports] { exports.copyView(true); });
  add(tr("Copy as &command line"), keys({"Ctrl+Alt+L"}), [&exports] { exports.copyCommandLine(); });
  const auto copyProfile = [&profiler = on.profiler](bool asCsv) {
    if (profiler.isVisible()) profiler.copy(asCsv);
  };
  add(tr("Copy profile as text"), {}, [copyProfile] { copyProfile(false); });
  add(tr("Copy profile as CSV"), {}, [copyProfile] { copyProfile(true); });
}

} // namespace taa::app
