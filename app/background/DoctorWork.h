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
  /// As lookAtMendedShot(), likewise.
  using Mend = std::function<doctor::MendedLook(const ExaminationRequest&, const doctor::Diagnosis&,
                                                const Settings& healthy, const Progress&)>;
  explicit DoctorWork(Examine examine = examineShot, QObject* parent = nullptr);
  void setExamine(Examine examine);
  void setMend(Mend mend);

  void begin(const ExaminationRequest& request);
  void mend(const ExaminationRequest& request, const doctor::Diagnosis& diagnosis, const Settings& healthy);

 Q_SIGNALS:
  /// First what the first frames show, then all of it.
  void told(const doctor::Diagnosis& diagnosis, bool isComplete);
  void mended(const doctor::MendedLook& look);

 private:
  Examine examine_;
  Mend mend_ = lookAtMendedShot;
};

} // namespace taa::app
