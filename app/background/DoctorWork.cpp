#include "app/background/DoctorWork.h"

#include <utility>

namespace taa::app {

DoctorWork::DoctorWork(Examine examine, QObject* parent)
    : BackgroundWork(parent), examine_(std::move(examine)) {}

void DoctorWork::setExamine(Examine examine) {
  examine_ = std::move(examine);
}

void DoctorWork::setCorrect(Correct correct) {
  correct_ = std::move(correct);
}

void DoctorWork::correct(const ExaminationRequest& request, const doctor::Diagnosis& diagnosis,
                         const Settings& healthy) {
  start([this, request, diagnosis, healthy, correct = correct_](const Deliver& deliver,
                                                                const Progress& progress) {
    const doctor::CorrectedLook look = correct(request, diagnosis, healthy, progress);
    deliver([this, look] { Q_EMIT corrected(look); });
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
