#include "app/background/DoctorWork.h"

#include <utility>

namespace taa::app {

DoctorWork::DoctorWork(Examine examine, QObject* parent)
    : BackgroundWork(parent), examine_(std::move(examine)) {}

void DoctorWork::setExamine(Examine examine) {
  examine_ = std::move(examine);
}

void DoctorWork::setMend(Mend mend) {
  mend_ = std::move(mend);
}

void DoctorWork::mend(const ExaminationRequest& request, const doctor::Diagnosis& diagnosis,
                      const Settings& healthy) {
  start([this, request, diagnosis, healthy, mend = mend_](const Deliver& deliver, const Progress& progress) {
    const doctor::MendedLook look = mend(request, diagnosis, healthy, progress);
    deliver([this, look] { Q_EMIT mended(look); });
  });
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
