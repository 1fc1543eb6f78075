// Goes through lessons: sets the state of a step, has its task checked, and remembers how far the reader got.
#pragma once

#include "app/learn/LearnPanel.h"
#include "core/lessons/LessonCheck.h"
#include "core/lessons/LessonNumbers.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

class QSettings;

namespace taa::app {

class LessonWork;
class PartFrame;
class Session;
class SessionKeeper;

class Learning : public QObject {
  Q_OBJECT
 public:
  /// The part of the window that a step calls so (kLessonParts); null: none.
  using FindPart = std::function<QWidget*(const QString& name)>;
  struct Holders {
    Session& session;
    SessionKeeper& keeper;
    LearnPanel& panel;
    QSettings* settings; ///< remembers progress and the teacher's folder; null: nothing is remembered
    FindPart part;
  };
  Learning(const Holders& of, QWidget* window);

  /// Opens the page where it was left, at the first lesson at first.
  void open();
  void openTour();
  /// A step of the lesson with this id, counted from 1; what there is not: an error is told.
  void openStep(const QString& lesson, int step);
  void close();
  bool isOpen() const;
  /// Lessons of somebody's own, which appear behind the built-in ones.
  void setFolder(const QString& folder);
  QString folder() const;
  void askForFolder();
  /// The tour, offered once: true where it has not been offered before.
  bool shouldOfferTour() const;
  void rememberOffer();

  /// So many steps on, or back; beyond a lesson's end the next one begins. Expects an open page.
  void stepBy(int steps);
  /// The task on show is to find a fault of the settings, and has not been solved.
  bool hidesFault() const;
  /// "Your first ghost, step 2 of 5"; expects an open page.
  QString place() const;
  int lesson() const { return lesson_; }
  int step() const { return step_; }
  LessonWork* work() const { return work_; }

 Q_SIGNALS:
  void changed();   ///< opened or closed
  void stepBegun(); ///< another one
  void stepShown(); ///< another one, or what became of its task
  void answered();  ///< a hint, a check or numbers, which need room
  void said(const QString& sentence);
  void rungChosen(const QString& preset); ///< of the ladder on show
  void failed(const QString& sentence);

 private:
  void readLessons();
  void chooseLesson(int lesson, int step);
  void chooseStep(int step);
  void beginStep();
  void setState();
  void show();
  void tellAnswer();
  void showLessons();
  void check();
  void takeChecked(const std::vector<CheckedCondition>& conditions);
  void measure();
  void takeNumbers(const std::vector<LessonNumber>& numbers);
  std::optional<LessonState> stateNow();
  void giveHint();
  void openState(const LessonState& state);
  void openOnItsFrames(const LessonState& state);
  bool isDone(const Lesson& lesson, int step) const;
  const Lesson& shown() const { return lessons_[static_cast<std::size_t>(lesson_)]; }
  const LessonStep& shownStep() const { return shown().steps[static_cast<std::size_t>(step_)]; }

  Holders of_;
  QWidget* window_;
  std::vector<Lesson> lessons_;
  int lesson_ = 0, step_ = 0;
  bool isBegun_ = false; ///< what was open before has been kept
  SessionFile opened_;   ///< what was opened last, on the frames that it records
  LearnPanel::StepNotes notes_;
  LessonWork* work_;
  PartFrame* frame_;
};

} // namespace taa::app
