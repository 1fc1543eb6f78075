// Shows what a change of settings does before the whole picture is there, where that takes long.
#pragma once

#include "core/jobs/desk/Desk.h"
#include "core/jobs/desk/Wanted.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class Previews {
 public:
  Previews(Desk& desk, const Wanted& wanted) : desk_(desk), wanted_(wanted) {}

  void take(const request::SetPreviews& wanted) { fromMs_ = wanted.fromMs; }

  /// Tells pictures of the views by settings of the first lane that come next. Returns whether newer ones
  /// wait by now, so that these need not come.
  bool tell(const Settings& settings);
  /// They have come, and the whole picture with them.
  void cameTrue() { areShown_ = false; }
  /// They do not come: the views are what they were.
  void withdraw();

 private:
  bool isSlow();

  Desk& desk_;
  const Wanted& wanted_;
  std::optional<double> fromMs_;
  double resolveMs_ = 0.0; ///< of the last frame that was resolved
  bool areShown_ = false;
};

} // namespace taa
