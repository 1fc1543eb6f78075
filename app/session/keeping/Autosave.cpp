#include "app/session/keeping/Autosave.h"

#include "core/base/Files.h"
#include "core/io/SessionFile.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <exception>
#include <utility>

namespace taa::app {

namespace {

constexpr int kAutosaveSettleMs = 2000, kAlwaysMs = 10000;
constexpr int kMaxLeft = 8, kMaxKept = 20; ///< files; the oldest go

QString ending() {
  return QString::fromUtf8(kSessionEnding.data(), static_cast<qsizetype>(kSessionEnding.size()));
}

QString lockPath(const QString& folder, const QString& id) {
  return QDir(folder).filePath(id + QStringLiteral(".lock"));
}

QString leftFolder(const QString& folder) {
  return QDir(folder).filePath(QStringLiteral("closed"));
}

/// Sessions in a folder of those that are named by their time, the newest first.
QFileInfoList namedByTime(const QString& folder) {
  return QDir(folder).entryInfoList({QLatin1Char('*') + ending()}, QDir::Files, QDir::Name | QDir::Reversed);
}

/// A path in `folder` for what comes there now; the oldest files that are too many go.
QString placeIn(const QString& folder, const QString& id, int most) {
  QDir().mkpath(folder);
  const QFileInfoList files = namedByTime(folder);
  for (qsizetype file = most - 1; file < files.size(); ++file) QFile::remove(files[file].filePath());
  const QString time =
      QStringLiteral("%1").arg(QDateTime::currentMSecsSinceEpoch(), 14, 10, QLatin1Char('0'));
  return QDir(folder).filePath(time + QLatin1Char('-') + id + ending());
}

} // namespace

Autosave::Autosave(const QString& folder, Text text, QObject* parent)
    : QObject(parent), folder_(folder),
      // Numbers of programs come again, soon in a container.
      id_(QStringLiteral("%1-%2")
              .arg(QCoreApplication::applicationPid())
              .arg(QDateTime::currentMSecsSinceEpoch())),
      text_(std::move(text)), lock_(lockPath(folder, id_)) {
  QDir().mkpath(folder_);
  lock_.setStaleLockTime(0); // only the end of its program frees a lock, however old it is
  lock_.tryLock(0);
  soon_.setSingleShot(true);
  soon_.setInterval(kAutosaveSettleMs);
  connect(&soon_, &QTimer::timeout, this, &Autosave::save);
  connect(&always_, &QTimer::timeout, this, &Autosave::save);
  always_.start(kAlwaysMs);
}

Autosave::~Autosave() {
  if (!saved_.empty()) QFile::remove(path());
}

bool Autosave::hasLeft(const QString& folder) {
  return !namedByTime(leftFolder(folder)).isEmpty();
}

// Whoever renames it first has it.
std::optional<QString> Autosave::takeLeft() {
  for (const QFileInfo& file : namedByTime(leftFolder(folder_))) {
    if (!QFile::rename(file.filePath(), path())) continue;
    saved_ = "taken"; // what it holds is not known, but it is there
    return path();
  }
  return {};
}

void Autosave::leave() {
  save();
  if (!saved_.empty()) QFile::rename(path(), placeIn(leftFolder(folder_), id_, kMaxLeft));
  saved_.clear();
  hasLeft_ = true;
}

std::optional<QString> Autosave::keepForGood() {
  save();
  if (saved_.empty()) return {};
  const QString kept = placeIn(QDir(folder_).filePath(QStringLiteral("../kept")), id_, kMaxKept);
  if (!QFile::rename(path(), kept)) return {};
  saved_.clear();
  return QFileInfo(kept).canonicalFilePath();
}

QString Autosave::path() const {
  return QDir(folder_).filePath(id_ + ending());
}

std::optional<Autosave::Orphan> Autosave::orphan() {
  for (const QFileInfo& file :
       QDir(folder_).entryInfoList({QLatin1Char('*') + ending()}, QDir::Files, QDir::Time)) {
    const QString id = file.fileName().chopped(ending().size());
    auto lock = std::make_unique<QLockFile>(lockPath(folder_, id));
    lock->setStaleLockTime(0);
    if (!lock->tryLock(0)) continue; // it runs
    orphanLock_ = std::move(lock);
    orphan_ = file.filePath();
    return Orphan{orphan_, file.lastModified()};
  }
  return {};
}

void Autosave::removeOrphan() {
  QFile::remove(orphan_);
  orphan_.clear();
  orphanLock_.reset();
}

void Autosave::saveSoon() {
  soon_.start();
}

// Not worth a word when it fails: nothing that the user asked for is lost.
void Autosave::save() {
  if (hasLeft_) return;
  try {
    std::string text = text_();
    if (text.empty() || text == saved_) return;
    writeFile(path().toStdString(), text);
    saved_ = std::move(text);
  } catch (const std::exception&) {
    return;
  }
}

} // namespace taa::app
