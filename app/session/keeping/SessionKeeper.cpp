#include "app/session/keeping/SessionKeeper.h"

#include "app/session/Session.h"
#include "app/session/keeping/Autosave.h"
#include "app/style/Text.h"
#include "app/widgets/ConfirmReplace.h"
#include "app/widgets/bars/OfferBar.h"
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/inspect/FirstSize.h"
#include "core/replay/Checkpoints.h"
#include "core/settings/Presets.h"

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

constexpr int kMaxRecent = 10;

QString recentKey() {
  return QStringLiteral("recent");
}

bool isFile(const QString& source) {
  return !source.isEmpty() && !source.startsWith(QStringLiteral("builtin:"));
}

QString withEnding(const QString& path) {
  return isSessionName(path.toStdString()) ? path : path + QString::fromUtf8(kSessionEnding.data());
}

QString autosaveFolder(const QSettings& settings) {
  return QFileInfo(settings.fileName()).dir().filePath(QStringLiteral("autosave"));
}

// What only a program's own files say, not those that a person saves.
QString geometryKey() {
  return QStringLiteral("geometry");
}
QString pathKey() {
  return QStringLiteral("path");
}

std::string windowText(const QJsonObject& window) {
  return QJsonDocument(window).toJson(QJsonDocument::Compact).toStdString();
}

QJsonObject windowState(const SessionFile& file) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(file.window)).object();
}

} // namespace

SessionKeeper::SessionKeeper(Session& session, StateAccess state, QSettings* settings, QWidget* window)
    : QObject(window), session_(session), state_(std::move(state)), settings_(settings), window_(window) {
  connect(&session_, &Session::statusChanged, this, &SessionKeeper::finishRestoring);
  connect(&session_, &Session::openingFailed, this, &SessionKeeper::takeFailure);
  connect(&session_, &Session::errorOccurred, this, [this](const QString& error) { lastError_ = error; });
  if (!settings_) return;
  const auto text = [this] { return session_.isOpen() ? sessionToText(wholeFile()) : std::string(); };
  autosave_ = new Autosave(autosaveFolder(*settings_), text, this);
  connect(&session_.presets(), &PresetChoices::settingsChanged, autosave_, &Autosave::saveSoon);
}

SessionFile SessionKeeper::file() const {
  SessionFile file = session_.file();
  file.window = windowText(state_.capture());
  return file;
}

// As it lies in a folder of the program: paths are whole.
SessionFile SessionKeeper::wholeFile() const {
  SessionFile file = session_.file();
  if (const QString source = QString::fromStdString(file.source); isFile(source))
    file.source = QFileInfo(source).absoluteFilePath().toStdString();
  QJsonObject window = state_.capture();
  window[geometryKey()] = QString::fromLatin1(window_->saveGeometry().toBase64());
  if (!path_.isEmpty()) window[pathKey()] = QFileInfo(path_).absoluteFilePath();
  file.window = windowText(window);
  return file;
}

void SessionKeeper::placeWindow(const SessionFile& file) {
  const QJsonObject state = windowState(file);
  window_->restoreGeometry(QByteArray::fromBase64(state[geometryKey()].toString().toLatin1()));
  path_ = state[pathKey()].toString();
}

bool SessionKeeper::restore(const QString& path) {
  try {
    SessionFile file = readSession(path.toStdString());
    const QString source = QString::fromStdString(file.source);
    if (isFile(source) && !QFileInfo::exists(source))
      throw Error(say<"cannot open the session %1: its scene %2 is not there any more">(path.toStdString(),
                                                                                        file.source));
    restoreFile(std::move(file));
    return true;
  } catch (const std::exception& error) {
    lastError_ = QString::fromStdString(shownReason(error));
    Q_EMIT failed(lastError_);
    return false;
  }
}

void SessionKeeper::restoreFile(SessionFile file) {
  before_ = state_.capture();
  pathBefore_ = path_;
  session_.restore(file);
  state_.apply(windowState(file));
  restoring_ = std::move(file);
  isFromSession_ = true;
}

void SessionKeeper::openFile(SessionFile file) {
  restoreFile(std::move(file));
  path_.clear();
}

void SessionKeeper::openSource(const QString& source) {
  if (isSessionName(source.toStdString()))
    open(source);
  else
    session_.open(source);
}

void SessionKeeper::askWhatToOpen() {
  auto* dialog =
      new QFileDialog(window_, tr("Open a scene or a session"), {},
                      tr("Scenes, captures and sessions (*.gltf *.glb *.json);;glTF 2.0 scenes (*.gltf "
                         "*.glb);;Captures (*.json);;Sessions (*.taa.json);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &SessionKeeper::openSource);
  dialog->open();
}

void SessionKeeper::open(const QString& path) {
  if (!restore(path)) return;
  path_ = path;
  remember(path);
}

// Where a picture of another size was on show, places in it were kept inside that.
void SessionKeeper::finishRestoring() {
  const Status& status = session_.status();
  const QString source = QString::fromStdString(status.source);
  if (status.opened != opened_ && status.frameCount > 0) {
    opened_ = status.opened;
    if (isFile(source)) remember(source);
    const bool isOther = restoring_ && restoring_->source != status.source;
    if (isOther && !session_.isOpening()) restoring_.reset(); // something else was opened
    if (!restoring_) path_.clear();
    isFromSession_ = restoring_.has_value();
    isReopening_ = false;
    if (std::exchange(isOfOrphan_, false) && restoring_) autosave_->removeOrphan();
    if (!toSay_.isEmpty()) sayWhenOpen(std::exchange(toSay_, {}));
  }
  // A scene that was still being opened comes first, and is none of the file's business.
  if (!restoring_ || session_.isOpening() || status.source != restoring_->source ||
      glm::ivec2(status.width, status.height) != restoring_->size)
    return;
  const SessionFile file = *std::exchange(restoring_, {});
  state_.apply(windowState(file));
  noteOldNames(file);
}

// After the window has cleared what was said of the scene before.
void SessionKeeper::noteOldNames(const SessionFile& file) {
  if (file.notes.empty()) return;
  const QString sentence = tr("The session is of an earlier version: %1.").arg(clauses(file.notes));
  QMetaObject::invokeMethod(
      this, [this, sentence] { Q_EMIT said(sentence); }, Qt::QueuedConnection);
}

// A scene that is there and cannot be read, or a program that was stopped while it read it.
void SessionKeeper::takeFailure() {
  if (!std::exchange(restoring_, {})) return;
  isFromSession_ = isOfOrphan_ = false; // what was left is offered again at the next start
  if (std::exchange(isReopening_, false)) {
    openFirst();
    return;
  }
  state_.apply(before_);
  path_ = pathBefore_;
}

bool SessionKeeper::canReopen(const QSettings& settings) {
  return Autosave::hasLeft(autosaveFolder(settings));
}

void SessionKeeper::reopen() {
  const auto path = autosave_ ? autosave_->takeLeft() : std::nullopt;
  if (!path) {
    session_.open(QString::fromLatin1(kFirstSource));
    return;
  }
  isReopening_ = true;
  if (!restore(*path)) {
    openFirst();
    return;
  }
  placeWindow(*restoring_);
}

// In place of what was left and cannot be opened.
void SessionKeeper::openFirst() {
  isReopening_ = false;
  path_.clear();
  const auto kept = autosave_->keepForGood();
  toSay_ = tr("What was open last is not open again: %1.").arg(lastError_);
  if (kept) toSay_ += QLatin1Char(' ') + tr("It has been kept as %1.").arg(*kept);
  state_.apply(firstState_);
  session_.presets().setPreset(QString::fromStdString(builtinPresets().front().id));
  session_.open(QString::fromLatin1(kFirstSource));
}

// After the window has cleared what was said of the scene before.
void SessionKeeper::sayWhenOpen(const QString& sentence) {
  QMetaObject::invokeMethod(
      this, [this, sentence] { Q_EMIT failed(sentence); }, Qt::QueuedConnection);
}

void SessionKeeper::leave() {
  if (autosave_) autosave_->leave();
}

void SessionKeeper::keepWhatIsOpen() {
  if (const auto kept = autosave_ && session_.isOpen() ? autosave_->keepForGood() : std::nullopt) {
    remember(*kept);
    Q_EMIT said(tr("What was open has been kept: File, Open recent, %1.").arg(QFileInfo(*kept).fileName()));
  }
}

void SessionKeeper::startAnew() {
  keepWhatIsOpen();
  path_.clear();
  const glm::ivec2 size = firstSize(session_.status().driver);
  session_.open(QString::fromLatin1(kFirstSource));
  session_.post(request::SetSize{size.x, size.y});
  session_.presets().setPreset(QString::fromStdString(builtinPresets().front().id));
  session_.post(request::SetCheckpointBudget{kDefaultCheckpointBudget});
  state_.apply(firstState_);
}

void SessionKeeper::save() {
  if (path_.isEmpty())
    askWhereToSave();
  else
    saveTo(path_);
}

void SessionKeeper::askWhereToSave() {
  auto* dialog = new QFileDialog(window_, tr("Save the session"),
                                 path_.isEmpty() ? QStringLiteral("session.taa.json") : path_,
                                 tr("Sessions (*.taa.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("taa.json"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    const QString whole = withEnding(path);
    if (whole == path) return saveTo(path);
    confirmReplace(window_, {whole.toStdString()}, [this, whole] { saveTo(whole); }); // of a name never shown
  });
  dialog->open();
}

void SessionKeeper::saveTo(const QString& path) {
  if (!session_.isOpen()) return;
  const QString named = withEnding(path);
  try {
    writeSession(named.toStdString(), file());
    path_ = named;
    remember(named);
    Q_EMIT said(tr("Saved %1.").arg(QFileInfo(named).fileName()));
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromStdString(shownReason(error)));
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
  settings_->setValue(recentKey(), QStringList(paths.mid(0, kMaxRecent)));
}

void SessionKeeper::offerOrphan() {
  const auto orphan = autosave_ ? autosave_->orphan() : std::nullopt;
  if (!orphan) return;
  offer_ = new OfferBar(tr("TAA Inspector ended without being closed. What was open on %1 has been kept.")
                            .arg(QLocale().toString(orphan->savedAt, QLocale::ShortFormat)),
                        tr("Open it again"), tr("Throw it away"));
  connect(offer_, &OfferBar::accepted, this, [this, path = orphan->path] {
    if (!restore(path)) return;
    placeWindow(*restoring_);
    isOfOrphan_ = true;
  });
  connect(offer_, &OfferBar::refused, this, [this] { autosave_->removeOrphan(); });
  connect(offer_, &QObject::destroyed, this, [this] { offer_ = nullptr; });
  Q_EMIT offerMade(offer_);
}

} // namespace taa::app
