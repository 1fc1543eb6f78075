// Delivers the next one of the worst pixels of the frame on show when it is asked for.
#pragma once

#include "core/jobs/Desk.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class ShownWorst {
 public:
  explicit ShownWorst(Desk& desk) : desk_(desk) {}

  void take(const request::FindWorst& wanted) { wanted_ = wanted; }
  void deliver();

 private:
  Desk& desk_;
  std::optional<request::FindWorst> wanted_; // not answered yet
};

} // namespace taa
