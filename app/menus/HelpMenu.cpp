#include "app/menus/HelpMenu.h"

#include "app/dialogs/ReferenceDialog.h"
#include "app/dialogs/VerifyDialog.h"
#include "app/learn/Learning.h"
#include "app/menus/CommandLists.h"
#include "app/session/Session.h"
#include "app/style/Icons.h"

#include <QAction>
#include <QMessageBox>

namespace taa::app {

HelpMenu::HelpMenu(Commands& commands, const Session& session, CommandLists& lists, Learning& learning,
                   QWidget* parent)
    : CommandMenu(tr("&Help"), commands, parent) {
  QWidget* window = parent->window();
  QAction* learn = addCheck(tr("&Learn"), QKeySequence(QStringLiteral("F12")), [&learning](bool shown) {
    if (shown)
      learning.open();
    else
      learning.close();
  });
  onRefresh([learn, &learning] { learn->setChecked(learning.isOpen()); });
  add(tr("&Tour: your first ghost"), {}, [&learning] { learning.openTour(); });
  add(tr("Lessons of a &folder…"), {}, [&learning] { learning.askForFolder(); });
  add(tr("&Keys"), keys({"?"}), [&lists] {
    lists.showKeys();
  })->setIcon(themedIcon(QStringLiteral("keyboard")));
  add(tr("&Manual, settings and intermediates"), keys({"F1"}), [window] {
    auto* dialog = new ReferenceDialog(window);
    dialog->open();
  });
  add(tr("&Check the driver…"), {}, [window] { VerifyDialog::openAt(window); });
  add(tr("&About TAA Inspector"), {}, [&session, window] {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About TAA Inspector"),
        tr("TAA Inspector %1\n\nSteps temporal anti-aliasing frame by frame and shows everything it "
           "computes.\n\nDriver: %2\nQt %3")
            .arg(QStringLiteral(TAA_VERSION), QString::fromStdString(session.status().driver.renderer),
                 QString::fromLatin1(qVersion())),
        QMessageBox::Close, window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
}

} // namespace taa::app
