// Undo, copies, search.
#include "app/menus/Menus.h"

#include "app/panels/PipelinePanel.h"
#include "app/style/Icons.h"
#include "app/window/Exports.h"
#include "app/window/MainWindow.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

namespace taa::app {

void Menus::makeEdit() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Edit"));
  Session& session = window_.session();
  QAction* undo = add(menu, tr("&Undo"), keys({"Ctrl+Z"}), [&session] { session.undo(); });
  QAction* redo = add(menu, tr("&Redo"), keys({"Ctrl+Shift+Z"}), [&session] { session.redo(); });
  add(menu, tr("End what is under wa&y, or remove the probe"), keys({"Esc"}), [this] { window_.escape(); });
  menu->addSeparator();
  add(menu, tr("&Copy probed value"), keys({"Ctrl+C"}), [this] {
    window_.copyValue();
  })->setIcon(themedIcon(QStringLiteral("copy")));
  add(menu, tr("Copy &all probed values"), keys({"Ctrl+Shift+C"}),
      [this] { window_.copyProbe(ProbeFormat::Text); });
  add(menu, tr("Copy the probe as &Markdown"), keys({"Ctrl+Alt+M"}),
      [this] { window_.copyProbe(ProbeFormat::Markdown); });
  add(menu, tr("Copy the probe as &JSON"), keys({"Ctrl+Alt+J"}),
      [this] { window_.copyProbe(ProbeFormat::Json); });
  add(menu, tr("Copy the &picture of the view"), keys({"Ctrl+Alt+P"}),
      [this] { window_.exports()->copyView(false); });
  add(menu, tr("Copy it with its le&gend"), keys({"Ctrl+Alt+Shift+P"}),
      [this] { window_.exports()->copyView(true); });
  add(menu, tr("Copy as &command line"), keys({"Ctrl+Alt+L"}),
      [this] { window_.exports()->copyCommandLine(); });
  add(menu, tr("Copy profile as text"), {}, [this] { window_.copyProfile(false); });
  add(menu, tr("Copy profile as CSV"), {}, [this] { window_.copyProfile(true); });
  menu->addSeparator();
  add(menu, tr("&Search settings and intermediates"), keys({"Ctrl+F"}), [this] {
    window_.searchPipeline();
  })->setIcon(themedIcon(QStringLiteral("search")));
  add(menu, tr("&Find a command…"), keys({"Ctrl+Shift+P"}), [this] { window_.showCommands(); });
  onRefresh([&session, undo, redo] {
    const UndoStack& stack = session.undoStack();
    const auto named = [](const QString& what) { return QString(what).replace(u'&', QStringLiteral("&&")); };
    undo->setEnabled(stack.canUndo());
    undo->setText(stack.canUndo() ? tr("&Undo: %1").arg(named(stack.undoText())) : tr("&Undo"));
    redo->setEnabled(stack.canRedo());
    redo->setText(stack.canRedo() ? tr("&Redo: %1").arg(named(stack.redoText())) : tr("&Redo"));
  });
}

} // namespace taa::app
