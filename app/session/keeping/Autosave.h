// What is open, kept on disk while the program runs, for the next start and against crashes.
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace taa::app {

/// A file for each running program, beside a lock that tells whether it still runs. A program that is closed
/// leaves its file for the next one that starts, which takes it: of two that run none ever has the other's.
class Autosave : public QObject {
  Q_OBJECT
 public:
  using Text = std::function<std::string()>; ///< what to save; empty: nothing yet

  Autosave(const QString& folder, Text text, QObject* parent);
  /// The program ends as it should: nothing is left but by leave().
  ~Autosave() override;

  /// Whether a program that was closed has left something that none has taken.
  static bool hasLeft(const QString& folder);
  /// Takes the newest of that: from now on it is this program's own file. Nothing: there is none.
  std::optional<QString> takeLeft();
  /// The program closes: the next one goes on from here. Saves no more.
  void leave();
  /// Saves what is open now, or what was taken and cannot be opened, where no program takes it; its path, or
  /// nothing.
  std::optional<QString> keepForGood();

  /// The newest file of a program that does not run any more, held for this one.
  struct Orphan {
    QString path;
    QDateTime savedAt;
  };
  std::optional<Orphan> orphan();
  /// It was opened, or nobody wants it.
  void removeOrphan();

  void saveSoon(); ///< after a change worth keeping, once it has settled
  void save();     ///< unless nothing has changed
  QString path() const;

 private:
  QString folder_, id_;
  Text text_;
  std::string saved_;
  bool hasLeft_ = false;
  QLockFile lock_;
  std::unique_ptr<QLockFile> orphanLock_;
  QString orphan_;
  QTimer soon_, always_;
};

} // namespace taa::app
