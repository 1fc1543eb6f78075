#include "app/background/VerifyWork.h"

#include <utility>

namespace taa::app {

VerifyWork::VerifyWork(Check check, QObject* parent) : BackgroundWork(parent), check_(std::move(check)) {}

void VerifyWork::begin() {
  start([this, check = check_](const Deliver& deliver, const Progress& progress) {
    const DriverCheck result = check(progress);
    deliver([this, result] { Q_EMIT checked(result); });
  });
}

} // namespace taa::app
