// Keys and manual.
#include "app/menus/Menus.h"

#include "app/dialogs/ReferenceDialog.h"
#include "app/style/Icons.h"
#include "app/window/MainWindow.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

namespace taa::app {

void Menus::makeHelp() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Help"));
  add(menu, tr("&Keys"), keys({"?"}), [this] {
    window_.showKeys();
  })->setIcon(themedIcon(QStringLiteral("keyboard")));
  add(menu, tr("&Manual, settings and intermediates"), keys({"F1"}), [this] {
    auto* dialog = new ReferenceDialog(&window_);
    dialog->open();
  });
  add(menu, tr("&About TAA Inspector"), {}, [this] {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About TAA Inspector"),
        tr("TAA Inspector %1\n\nSteps temporal anti-aliasing frame by frame and shows everything it "
           "computes.\n\nDriver: %2\nQt %3")
            .arg(QStringLiteral(TAA_VERSION),
                 QString::fromStdString(window_.session().status().driver.renderer),
                 QString::fromLatin1(qVersion())),
        QMessageBox::Close, &window_);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
}

} // namespace taa::app
