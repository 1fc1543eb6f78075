// What went wrong, and what to know about the source; the newest first, each closed by itself.
#pragma once

#include <QStringList>
#include <QTimer>
#include <QWidget>

#include <chrono>

namespace taa::app {

class Strip;

class MessagesBar : public QWidget {
  Q_OBJECT
 public:
  explicit MessagesBar(QWidget* parent = nullptr);

  void showError(const QString& sentence);
  /// Whether errors come with a button that opens anyway what was refused; opensAnyway() follows its press.
  void offerOpening(bool offers);
  /// What became of the shaders that were read anew: what does not compile stays until it does.
  void showShaders(const QString& error);
  /// Something that was done; goes by itself.
  void showNote(const QString& sentence);
  /// How long a note stays, of those shown from now on.
  void setNoteTime(std::chrono::milliseconds time) { noteEnds_.setInterval(time); }
  /// Warnings of the source that is open; replaces those of the one before.
  void setWarnings(const QStringList& warnings);
  /// The hint of the first start; hintClosed() follows when it is closed.
  void showHint(const QString& text);
  /// Until it is shown again.
  void hideHint();
  /// All errors and warnings in sight.
  QString text() const;
  /// All that was said so far, the latest first: "14:03:21 cannot write …".
  const QStringList& history() const { return history_; }
  /// Opens a dialog with it.
  void showHistory();
  void clear();

 Q_SIGNALS:
  void hintClosed();
  void opensAnyway();

 private:
  void refresh();
  void remember(const QString& sentence);
  static QString joined(const QStringList& sentences);

  QStringList errors_, warnings_, history_;
  QString shaderError_;
  Strip *error_, *shader_, *warning_, *note_, *hint_;
  QTimer noteEnds_;
};

} // namespace taa::app
