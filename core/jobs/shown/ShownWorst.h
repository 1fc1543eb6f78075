// Delivers the next one of the worst pixels of the frame on show when it is asked for, once what it is found
// by is made.
#pragma once

#include "core/jobs/context/JobContext.h"
#include "core/jobs/context/Subscriptions.h"
#include "core/requests/Requests.h"

namespace taa {

class ShownWorst {
 public:
  ShownWorst(JobContext& jobContext, Subscriptions& subscriptions)
      : jobContext_(jobContext), subscriptions_(subscriptions) {}

  void take(const request::FindWorst& asked) { subscriptions_.worst = asked; }
  void take(const request::Cancel&) { subscriptions_.worst.reset(); }
  void deliver();

 private:
  bool isUnderWay() const;

  JobContext& jobContext_;
  Subscriptions& subscriptions_;
};

} // namespace taa
