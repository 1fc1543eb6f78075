// Checks the driver in the background.
#pragma once

#include "app/background/BackgroundWork.h"
#include "core/inspect/DriverCheck.h"

#include <functional>

namespace taa::app {

class VerifyWork : public BackgroundWork {
  Q_OBJECT
 public:
  /// As checkDriver(); tests put another one in its place.
  using Check = std::function<DriverCheck(const Progress&)>;
  explicit VerifyWork(Check check = checkDriver, QObject* parent = nullptr);

  void begin();

 Q_SIGNALS:
  void checked(const DriverCheck& check);

 private:
  Check check_;
};

} // namespace taa::app
