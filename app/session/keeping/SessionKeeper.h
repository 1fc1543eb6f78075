// Sessions as files: saved, opened, remembered, and offered again after a crash.
#pragma once

#include "core/io/SessionFile.h"
#include "core/requests/RequestKinds.h"

#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>

class QSettings;
class QWidget;

namespace taa::app {

inline constexpr auto kFirstSource = "builtin:fan"; ///< of a first start

class Autosave;
class OfferBar;
class Session;

class SessionKeeper : public QObject {
  Q_OBJECT
 public:
  /// What the window adds to a session: views, probes, panels and layout.
  struct StateAccess {
    std::function<QJsonObject()> capture;
    std::function<void(const QJsonObject&)> apply;
  };
  /// `settings` remembers what was open, and beside it sessions are kept against crashes; null: neither.
  /// `window` has the place that goes on, and dialogs open over it.
  SessionKeeper(Session& session, StateAccess state, QSettings* settings, QWidget* window);

  /// Opens a session and pauses at its frame, or a file or "builtin:NAME" and plays.
  void openSource(const QString& source);
  void askWhatToOpen();
  /// Reads a session and goes there; failed() when that is not possible, and nothing has changed.
  void open(const QString& path);
  /// As open(), of one that is no file: the next save asks for a name.
  void openFile(SessionFile file);
  /// Keeps what is open as a file among the recent ones, and says so.
  void keepWhatIsOpen();
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
  /// Whether a program that was closed has left something to go on from.
  static bool canReopen(const QSettings& settings);
  /// Goes on from there: also the window's place, and the file that it was saved to. What cannot be opened is
  /// kept, said, and the first scene opened instead.
  void reopen();
  /// The window closes: the next start goes on from here.
  void leave();
  /// As at the first start; what was open is kept, and said where.
  void startAnew();
  /// The window as it is at a first start.
  void setFirstState(const QJsonObject& state) { firstState_ = state; }
  /// Whether what is open, or about to be, came from a session: it says itself what is probed.
  bool isFromSession() const { return isFromSession_; }
  /// Makes a bar, offerMade(), when the program ended without closing before.
  void offerOrphan();
  OfferBar* offer() const { return offer_; } ///< null: there is none
  Autosave* autosave() const { return autosave_; }

 Q_SIGNALS:
  void said(const QString& sentence);
  void failed(const QString& sentence);
  /// Whoever takes it owns it.
  void offerMade(QWidget* bar);

 private:
  bool restore(const QString& path);
  void restoreFile(SessionFile file);
  SessionFile wholeFile() const;
  void placeWindow(const SessionFile& file);
  void noteOldNames(const SessionFile& file);
  void remember(const QString& path);
  void takeFailure();
  void openFirst();
  void sayWhenOpen(const QString& sentence);
  void finishRestoring();

  Session& session_;
  StateAccess state_;
  QSettings* settings_;
  QWidget* window_;
  QString path_;
  RequestId opened_ = 0;                 ///< see Status
  std::optional<SessionFile> restoring_; ///< until the picture has its size
  QJsonObject before_, firstState_;      ///< of the window: before restoring_; at a first start
  QString pathBefore_;
  bool isReopening_ = false, isFromSession_ = false, isOfOrphan_ = false;
  QString lastError_;
  QString toSay_; ///< once the next scene is open, which clears what was said
  Autosave* autosave_ = nullptr;
  OfferBar* offer_ = nullptr;
};

} // namespace taa::app
