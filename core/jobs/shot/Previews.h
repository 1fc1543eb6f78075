// Shows what a change of settings does before the whole picture is there, where that takes long.
#pragma once

#include "core/jobs/context/JobContext.h"
#include "core/jobs/context/Subscriptions.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class Previews {
 public:
  Previews(JobContext& jobContext, const Subscriptions& subscriptions)
      : jobContext_(jobContext), subscriptions_(subscriptions) {}

  void take(const request::SetPreviews& subscriptions) { fromMs_ = subscriptions.fromMs; }

  /// Tells pictures of the views by settings of the first lane that come next. Returns whether newer ones
  /// wait by now, so that these need not come.
  bool tell(const Settings& settings);
  /// They have come, and the whole picture with them.
  void cameTrue() { areShown_ = false; }
  /// They do not come: the views are what they were.
  void withdraw();

 private:
  bool isSlow();

  JobContext& jobContext_;
  const Subscriptions& subscriptions_;
  std::optional<double> fromMs_;
  double resolveMs_ = 0.0; ///< of the last frame that was resolved
  bool areShown_ = false;
};

} // namespace taa
