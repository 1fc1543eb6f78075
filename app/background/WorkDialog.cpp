#include "app/background/WorkDialog.h"

#include "app/background/BackgroundWork.h"

namespace taa::app {

WorkDialog::WorkDialog(BackgroundWork& work, QWidget* parent) : QDialog(parent), work_(work) {}

void WorkDialog::reject() {
  if (work_.isRunning())
    work_.cancel();
  else
    QDialog::reject();
}

void WorkDialog::present() {
  setVisible(true);
  raise();
  activateWindow();
}

// What is known stays.
void WorkDialog::closeEvent(QCloseEvent* event) {
  work_.cancel();
  QDialog::closeEvent(event);
}

} // namespace taa::app
