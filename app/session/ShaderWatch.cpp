#include "app/session/ShaderWatch.h"

#include <QCryptographicHash>
#include <QDirIterator>
#include <QFile>

namespace taa::app {

namespace {

constexpr int kShadersSettleMs = 150;

QHash<QString, QByteArray> digestsIn(const QString& folder) {
  QHash<QString, QByteArray> digests;
  QDirIterator files(
      folder,
      {QStringLiteral("*.glsl"), QStringLiteral("*.frag"), QStringLiteral("*.vert"), QStringLiteral("*.h")},
      QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    QFile file(files.next());
    if (file.open(QIODevice::ReadOnly))
      digests[file.fileName()] = QCryptographicHash::hash(file.readAll(), QCryptographicHash::Sha1);
  }
  return digests;
}

} // namespace

ShaderWatch::ShaderWatch(const QString& folder, QObject* parent)
    : QObject(parent), folder_(folder), digests_(digestsIn(folder)) {
  settles_.setSingleShot(true);
  settles_.setInterval(kShadersSettleMs);
  connect(&settles_, &QTimer::timeout, this, &ShaderWatch::look);
  const auto wait = [this] { settles_.start(); };
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, wait);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, wait);
  watch();
}

QString ShaderWatch::folder() {
  return qEnvironmentVariable("TAA_SHADER_DIR");
}

// Again each time: a file that an editor replaces is no longer watched.
void ShaderWatch::watch() {
  QStringList paths = digests_.keys();
  paths << folder_;
  QDirIterator folders(folder_, QDir::Dirs | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
  while (folders.hasNext()) paths << folders.next();
  watcher_.addPaths(paths);
}

void ShaderWatch::look() {
  const QHash<QString, QByteArray> digests = digestsIn(folder_);
  const bool isNew = digests != digests_;
  digests_ = digests;
  watch();
  if (isNew) Q_EMIT changed();
}

} // namespace taa::app
