#include "app/commands/CameraFiles.h"

#include "app/session/Session.h"
#include "app/widgets/Prompt.h"
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/io/CameraTrackJson.h"

#include <QFileDialog>

namespace taa::app {

CameraFiles::CameraFiles(Session& session, QWidget* window)
    : QObject(window), session_(session), window_(window) {}

CameraTrackHandle CameraFiles::flown() const {
  const Status& status = session_.status();
  for (const CameraTrackHandle& track : status.tracks)
    if (track->name == status.camera) return track;
  return nullptr;
}

void CameraFiles::askWhereToSave() {
  const CameraTrackHandle track = flown();
  if (!track) return;
  auto* dialog = new QFileDialog(window_, tr("Save the flown camera"), QString::fromStdString(track->name),
                                 tr("Camera paths (*.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("json"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, track](const QString& file) {
    try {
      writeFile(file.toStdString(), cameraTrackJson(*track).dump(1) + '\n');
    } catch (const Error& error) {
      Q_EMIT failed(QString::fromUtf8(error.what()));
    }
  });
  dialog->open();
}

void CameraFiles::askForFile() {
  auto* dialog = new QFileDialog(window_, tr("Open a recorded camera"), {}, tr("Camera paths (*.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    try {
      session_.scene().addCameraTrack(readCameraTrack(file.toStdString()));
    } catch (const Error& error) {
      Q_EMIT failed(QString::fromUtf8(error.what()));
    }
  });
  dialog->open();
}

void CameraFiles::askForName() {
  const CameraTrackHandle track = flown();
  if (!track) return;
  auto* prompt = new Prompt(
      tr("Name of the flown camera"), QString::fromStdString(track->name),
      [this, name = track->name](const QString& text) {
        return session_.scene().renameCamera(name, text.trimmed().toStdString());
      },
      window_);
  prompt->open();
}

void CameraFiles::remove() {
  if (const CameraTrackHandle track = flown()) session_.scene().removeCamera(track->name);
}

} // namespace taa::app
