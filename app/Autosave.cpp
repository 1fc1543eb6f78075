#include "app/Autosave.h"

#include "core/base/Files.h"
#include "core/io/SessionFile.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <exception>
#include <utility>

namespace taa::app {

namespace {

constexpr int kSettleMs = 2000, kAlwaysMs = 10000;

QString ending() {
  return QString::fromUtf8(kSessionEnding.data(), static_cast<qsizetype>(kSessionEnding.size()));
}

QString lockPath(const QString& folder, const QString& id) {
  return QDir(folder).filePath(id + QStringLiteral(".lock"));
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
  soon_.setInterval(kSettleMs);
  connect(&soon_, &QTimer::timeout, this, &Autosave::save);
  connect(&always_, &QTimer::timeout, this, &Autosave::save);
  always_.start(kAlwaysMs);
}

Autosave::~Autosave() {
  if (!saved_.empty()) QFile::remove(path());
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
