#include "app/commands/ImportFrames.h"

#include "app/importing/ImportPage.h"
#include "app/session/keeping/SessionKeeper.h"
#include "core/capture/format/Manifest.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace taa::app {

ImportFrames::ImportFrames(SessionKeeper& keeper, QWidget* window)
    : QObject(window), keeper_(keeper), window_(window) {}

bool ImportFrames::isWanted(const QString& path) {
  return QFileInfo(path).isDir() && !QDir(path).exists(QLatin1String(capture::kManifestName));
}

void ImportFrames::askForFolder() {
  auto* dialog = new QFileDialog(window_, tr("Folder of frames to import"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, &ImportFrames::open);
  dialog->open();
}

void ImportFrames::open(const QString& folder) {
  auto* page = new ImportPage(window_);
  connect(page, &ImportPage::openRequested, &keeper_, &SessionKeeper::openSource);
  if (!folder.isEmpty()) page->openFolder(folder);
  // Qt would take two thirds of the screen, in which hypotheses have no room.
  page->resize(page->sizeHint().boundedTo(window_->size()));
  page->show();
}

} // namespace taa::app
