#include "app/SessionKeeper.h"

#include "app/Autosave.h"
#include "app/MainWindow.h"
#include "app/widgets/ConfirmReplace.h"
#include "app/widgets/OfferBar.h"
#include "core/base/Error.h"
#include "core/base/Say.h"

#include <QBoxLayout>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonDocument>
#include <QLocale>
#include <QSettings>

#include <exception>
#include <string>
#include <utility>

namespace taa::app {

namespace {

constexpr int kMostRecent = 10;

QString recentKey() {
  return QStringLiteral("recent");
}

bool isFile(const QString& source) {
  return !source.isEmpty() && !source.startsWith(QStringLiteral("builtin:"));
}

QString withEnding(const QString& path) {
  return isSessionName(path.toStdString()) ? path : path + QString::fromUtf8(kSessionEnding.data());
}

QJsonObject windowState(const SessionFile& file) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(file.window)).object();
}

} // namespace

SessionKeeper::SessionKeeper(MainWindow& window, QSettings* settings)
    : QObject(&window), window_(window), settings_(settings) {
  Session& session = window_.session();
  connect(&session, &Session::statusChanged, this, &SessionKeeper::finishRestoring);
  if (!settings_) return;
  const QString folder = QFileInfo(settings_->fileName()).dir().filePath(QStringLiteral("autosave"));
  const auto text = [this] { return window_.session().isOpen() ? sessionToText(file()) : std::string(); };
  autosave_ = new Autosave(folder, text, this);
  connect(&session, &Session::settingsChanged, autosave_, &Autosave::saveSoon);
}

SessionFile SessionKeeper::file() const {
  SessionFile file = window_.session().file();
  file.window = QJsonDocument(window_.state()).toJson(QJsonDocument::Compact).toStdString();
  return file;
}

bool SessionKeeper::restore(const QString& path) {
  try {
    SessionFile file = readSession(path.toStdString());
    const QString source = QString::fromStdString(file.source);
    if (isFile(source) && !QFileInfo::exists(source))
      throw Error(say<"cannot open the session %1: its scene %2 is not there any more">(path.toStdString(),
                                                                                        file.source));
    window_.session().restore(file);
    window_.setState(windowState(file));
    restoring_ = std::move(file);
    return true;
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
    return false;
  }
}

void SessionKeeper::open(const QString& path) {
  if (!restore(path)) return;
  path_ = path;
  remember(path);
}

// Where a picture of another size was on show, places in it were kept inside that.
void SessionKeeper::finishRestoring() {
  const Status& status = window_.session().status();
  const QString source = QString::fromStdString(status.source);
  if (source != openSource_ && status.frameCount > 0) {
    openSource_ = source;
    if (isFile(source)) remember(source);
    if (restoring_ && restoring_->source != status.source) restoring_.reset(); // something else was opened
    if (!restoring_) path_.clear();
  }
  if (!restoring_ || status.source != restoring_->source ||
      glm::ivec2(status.width, status.height) != restoring_->size)
    return;
  const SessionFile file = *std::exchange(restoring_, {});
  window_.setState(windowState(file));
}

void SessionKeeper::save() {
  if (path_.isEmpty())
    askWhereToSave();
  else
    saveTo(path_);
}

void SessionKeeper::askWhereToSave() {
  auto* dialog = new QFileDialog(&window_, tr("Save the session"),
                                 path_.isEmpty() ? QStringLiteral("session.taa.json") : path_,
                                 tr("Sessions (*.taa.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("taa.json"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    const QString whole = withEnding(path);
    if (whole == path) return saveTo(path);
    confirmReplace(&window_, {whole.toStdString()},
                   [this, whole] { saveTo(whole); }); // of a name never shown
  });
  dialog->open();
}

void SessionKeeper::saveTo(const QString& path) {
  if (!window_.session().isOpen()) return;
  const QString named = withEnding(path);
  try {
    writeSession(named.toStdString(), file());
    path_ = named;
    remember(named);
    Q_EMIT said(tr("Saved %1.").arg(QFileInfo(named).fileName()));
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

QStringList SessionKeeper::recent() const {
  return settings_ ? settings_->value(recentKey()).toStringList() : QStringList();
}

QString SessionKeeper::cameraFolder() const {
  return settings_ ? QFileInfo(settings_->fileName()).dir().filePath(QStringLiteral("cameras"))
                   : QDir::temp().filePath(QStringLiteral("taa-inspector-cameras"));
}

void SessionKeeper::clearRecent() {
  if (settings_) settings_->remove(recentKey());
}

void SessionKeeper::remember(const QString& path) {
  if (!settings_) return;
  const QString whole = QFileInfo(path).absoluteFilePath();
  QStringList paths = recent();
  paths.removeAll(whole);
  paths.prepend(whole);
  settings_->setValue(recentKey(), QStringList(paths.mid(0, kMostRecent)));
}

void SessionKeeper::offerOrphan() {
  const auto orphan = autosave_ ? autosave_->orphan() : std::nullopt;
  if (!orphan) return;
  offer_ = new OfferBar(tr("TAA Inspector ended without being closed. What was open on %1 has been kept.")
                            .arg(QLocale().toString(orphan->savedAt, QLocale::ShortFormat)),
                        tr("Open it again"), tr("Throw it away"));
  qobject_cast<QBoxLayout*>(window_.centralWidget()->layout())->insertWidget(0, offer_);
  connect(offer_, &OfferBar::accepted, this, [this, path = orphan->path] {
    if (!restore(path)) return;
    path_.clear(); // it is nobody's file
    autosave_->removeOrphan();
  });
  connect(offer_, &OfferBar::refused, this, [this] { autosave_->removeOrphan(); });
  connect(offer_, &QObject::destroyed, this, [this] { offer_ = nullptr; });
}

} // namespace taa::app
