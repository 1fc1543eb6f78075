#include "app/commands/ImportFrames.h"

#include "app/importing/ImportPage.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/style/DialogSize.h"
#include "core/capture/format/Manifest.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace taa::app {

ImportFrames::ImportFrames(SessionKeeper& keeper, QWidget* window)
    : QObject(window), keeper_(keeper), window_(window) {}

QFileDialog* ImportFrames::ask(const QString& title) {
  auto* dialog = new QFileDialog(window_, title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly, false); // its files are what one knows a folder by
  dialog->open();
  return dialog;
}

void ImportFrames::askForFolder() {
  connect(ask(tr("Folder of frames to import")), &QFileDialog::fileSelected, this, &ImportFrames::open);
}

void ImportFrames::askForCapture() {
  connect(ask(tr("Open the folder of a capture")), &QFileDialog::fileSelected, this,
          &ImportFrames::openSource);
}

void ImportFrames::openSource(const QString& path) {
  const bool isDescribed = QDir(path).exists(QLatin1String(capture::kManifestName));
  if (QFileInfo(path).isDir() && !isDescribed)
    open(path);
  else
    keeper_.openSource(path);
}

void ImportFrames::open(const QString& folder) {
  auto* page = new ImportPage(window_);
  connect(page, &ImportPage::openRequested, &keeper_, &SessionKeeper::openSource);
  if (!folder.isEmpty()) page->openFolder(folder);
  // Qt would take two thirds of the screen, in which hypotheses have no room.
  page->resize(largeOver(window_, page->sizeHint()));
  page->show();
}

} // namespace taa::app
