// Sessions as files: saved, opened, remembered, and offered again after a crash.
#pragma once

#include "core/io/SessionFile.h"

#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QStringList>

#include <optional>

class QSettings;

namespace taa::app {

class Autosave;
class MainWindow;
class OfferBar;

class SessionKeeper : public QObject {
  Q_OBJECT
 public:
  /// `settings` remembers what was open, and beside it sessions are kept against crashes; null: neither.
  SessionKeeper(MainWindow& window, QSettings* settings);

  /// Reads a session and goes there; failed() when that is not possible, and nothing has changed.
  void open(const QString& path);
  void save(); ///< where it came from, or asks
  void askWhereToSave();
  void saveTo(const QString& path);
  /// Everything, as it is now.
  SessionFile file() const;
  QString path() const { return path_; } ///< empty: not saved yet
  /// Scenes and sessions, the latest first.
  QStringList recent() const;
  void clearRecent();
  /// Where cameras lie that copied command lines name: beside what is remembered.
  QString cameraFolder() const;
  /// Shows a bar when the program ended without closing before.
  void offerOrphan();
  OfferBar* offer() const { return offer_; } ///< null: there is none
  Autosave* autosave() const { return autosave_; }

 Q_SIGNALS:
  void said(const QString& sentence);
  void failed(const QString& sentence);

 private:
  bool restore(const QString& path);
  void remember(const QString& path);
  void finishRestoring();

  MainWindow& window_;
  QSettings* settings_;
  QString path_, openSource_;
  std::optional<SessionFile> restoring_; ///< until the picture has its size
  Autosave* autosave_ = nullptr;
  OfferBar* offer_ = nullptr;
};

} // namespace taa::app
