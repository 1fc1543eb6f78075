#include "app/background/DoctorWork.h"

#include <utility>

namespace taa::app {

DoctorWork::DoctorWork(Examine examine, QObject* parent)
    : BackgroundWork(parent), examine_(std::move(examine)) {}

void DoctorWork::setExamine(Examine examine) {
  examine_ = std::move(examine);
}

void DoctorWork::begin(const ExaminationRequest& request) {
  start([this, request, examine = examine_](const Deliver& deliver, const Progress& progress) {
    const auto tell = [&](const doctor::Diagnosis& diagnosis, bool isComplete) {
      deliver([this, diagnosis, isComplete] { Q_EMIT told(diagnosis, isComplete); });
    };
    tell(examine(
             request, [&](const doctor::Diagnosis& early) { tell(early, false); }, progress),
         true);
  });
}

} // namespace taa::app
