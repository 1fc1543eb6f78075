// Says when a shader file was saved, while shaders are read from a folder.
#pragma once

#include <QFileSystemWatcher>
#include <QHash>
#include <QObject>
#include <QTimer>

namespace taa::app {

class ShaderWatch : public QObject {
  Q_OBJECT
 public:
  ShaderWatch(const QString& folder, QObject* parent);

  /// Where shaders are read from (TAA_SHADER_DIR); empty: from the program itself.
  static QString folder();

 Q_SIGNALS:
  void changed(); ///< what a file holds; once for all that are saved together

 private:
  void look();
  void watch();

  QString folder_;
  QFileSystemWatcher watcher_;
  QTimer settles_; ///< editors write in several steps
  QHash<QString, QByteArray> digests_;
};

} // namespace taa::app
