// Examines frames beside the window.
#pragma once

#include "app/background/BackgroundWork.h"
#include "core/inspect/doctor/ExaminedShot.h"

#include <functional>

namespace taa::app {

class DoctorWork : public BackgroundWork {
  Q_OBJECT
 public:
  /// As examineShot(); tests put another one in its place.
  using Examine = std::function<doctor::Diagnosis(const ExaminationRequest&, const doctor::DiagnosisTold&,
                                                  const Progress&)>;
  explicit DoctorWork(Examine examine = examineShot, QObject* parent = nullptr);
  void setExamine(Examine examine);

  void begin(const ExaminationRequest& request);

 Q_SIGNALS:
  /// First what the first frames show, then all of it.
  void told(const doctor::Diagnosis& diagnosis, bool isComplete);

 private:
  Examine examine_;
};

} // namespace taa::app
