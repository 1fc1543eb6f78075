// Examines frames beside the window, and draws them as they would be if what was found were right.
#pragma once

#include "app/background/BackgroundWork.h"
#include "core/inspect/ExaminedShot.h"

#include <functional>

namespace taa::app {

class DoctorWork : public BackgroundWork {
  Q_OBJECT
 public:
  /// As examineShot(); tests put another one in its place.
  using Examine = std::function<doctor::Diagnosis(const ExaminationRequest&, const doctor::DiagnosisTold&,
                                                  const Progress&)>;
  /// As lookAtCorrectedShot(), likewise.
  using Correct = std::function<doctor::CorrectedLook(const ExaminationRequest&, const doctor::Diagnosis&,
                                                      const Settings& healthy, const Progress&)>;
  explicit DoctorWork(Examine examine = examineShot, QObject* parent = nullptr);
  void setExamine(Examine examine);
  void setCorrect(Correct correct);

  void begin(const ExaminationRequest& request);
  void correct(const ExaminationRequest& request, const doctor::Diagnosis& diagnosis,
               const Settings& healthy);

 Q_SIGNALS:
  /// First what the first frames show, then all of it.
  void told(const doctor::Diagnosis& diagnosis, bool isComplete);
  void corrected(const doctor::CorrectedLook& look);

 private:
  Examine examine_;
  Correct correct_ = lookAtCorrectedShot;
};

} // namespace taa::app
