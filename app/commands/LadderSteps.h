// From rung to rung of a source's ladder: what changed, and what it gained as measured on what is open.
#pragma once

#include "core/lessons/LessonNumbers.h"
#include "core/settings/Settings.h"

#include <QObject>
#include <QString>

#include <vector>

namespace taa::app {

class LessonWork;
class Session;

class LadderSteps : public QObject {
  Q_OBJECT
 public:
  explicit LadderSteps(Session& session, QObject* parent = nullptr);

  /// Why there is no rung so many steps on; empty: there is one.
  QString whyNot(int steps) const;
  /// Chooses the rung so many steps on, as goTo(). Expects that there is one.
  void stepBy(int steps);
  /// Chooses a preset and says what it changes in the settings in force, then what that gains.
  void goTo(const QString& preset);
  LessonWork* work() const { return work_; }

 Q_SIGNALS:
  void said(const QString& sentence);

 private:
  void measure(const Settings& before, const Settings& now);
  void tellGain(const std::vector<LessonNumber>& numbers);

  Session& session_;
  LessonWork* work_;
  QString changed_; ///< what was said of the rung that is measured
};

} // namespace taa::app
