// What is open, kept on disk while the program runs: still there after it ended without closing.
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

/// A file for each running program, beside a lock that tells whether it still runs.
class Autosave : public QObject {
  Q_OBJECT
 public:
  using Text = std::function<std::string()>; ///< what to save; empty: nothing yet

  Autosave(const QString& folder, Text text, QObject* parent);
  /// The program ends as it should: nothing is left.
  ~Autosave() override;

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
  QLockFile lock_;
  std::unique_ptr<QLockFile> orphanLock_;
  QString orphan_;
  QTimer soon_, always_;
};

} // namespace taa::app
