// Begins and stops work beside the window and says where it is; buttons for what it found stand beside that,
// or above it.
#pragma once

#include <QString>
#include <QWidget>

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace taa::app {

class BackgroundWork;

/// Of its buttons; below on a page that is narrow, where buttons stand below each other if they have to.
enum class NotePlace { Beside, Below };

class BackgroundBar : public QWidget {
  Q_OBJECT
 public:
  /// `startText`: of the button while nothing is under way.
  BackgroundBar(BackgroundWork& work, const QString& startText, NotePlace notePlace = NotePlace::Beside,
                QWidget* parent = nullptr);

  /// To the right of the others.
  QPushButton* addButton(const QString& text, const QString& accessibleName);
  /// Whether it can begin, and what is said while nothing is under way.
  void setReady(bool canStart, const QString& note);
  /// Until setReady() says something else.
  void setNote(const QString& note);
  QString note() const;
  /// Of one button, where they may stand below each other.
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void startRequested();

 protected:
  bool event(QEvent* event) override;

 private:
  void arrange();
  int buttonsWidth() const;

  NotePlace notePlace_;
  BackgroundWork& work_;
  QString startText_;
  QPushButton* start_;
  QProgressBar* progress_;
  QLabel* note_;
  QHBoxLayout* line_;
};

} // namespace taa::app
