// The page "Learn": a lesson's step, the way through it, and what became of its task.
#pragma once

#include "core/lessons/Lesson.h"

#include <QString>
#include <QStringList>
#include <QWidget>

class QLabel;
class QPushButton;

namespace taa::app {

class ChoiceButton;
class IconButton;
class LessonText;

/// Shows and asks; Learning acts.
class LearnPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LearnPanel(QWidget* parent = nullptr);

  /// Above the page, where the room is given to it: which lesson it is, and a way to close it.
  QWidget* head() const { return head_; }

  /// What may be said of a step besides its text.
  struct StepNotes {
    bool isDone = false;     ///< its task was solved
    bool isAsked = false;    ///< for a check, a hint or numbers: the end of the text has to be seen
    bool isChecking = false; ///< its task, or what it speaks of
    QString answer{};        ///< of the last check
    QString numbers{};       ///< that it speaks of, as measured last: Markdown
    int hints = 0;           ///< so many of them are shown
    bool isSolutionShown = false;
  };
  /// In the order of the course; those that are done have a mark.
  void setLessons(const QStringList& titles, int current);
  void setStep(const Lesson& lesson, int step, const StepNotes& notes);

 Q_SIGNALS:
  void lessonChosen(int lesson);
  void stepChosen(int step);
  void returnRequested();
  void checkRequested();
  void hintRequested(); ///< after the last hint: the solution
  void numbersRequested();
  void closeRequested();
  void rungChosen(const QString& preset); ///< a row of the ladder's table

 private:
  void makeHead();
  void makeWay();
  void makeTask();
  void showTask(const LessonStep& step, const StepNotes& notes);

  int step_ = 0, lessonCount_ = 0;
  QWidget* head_ = nullptr;
  ChoiceButton* lessons_ = nullptr;
  IconButton* close_ = nullptr;
  QLabel *place_ = nullptr, *answer_ = nullptr;
  LessonText* text_ = nullptr;
  QPushButton *back_ = nullptr, *next_ = nullptr, *return_ = nullptr, *check_ = nullptr, *hint_ = nullptr,
              *measure_ = nullptr;
};

} // namespace taa::app
