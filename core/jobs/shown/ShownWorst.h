// Delivers the next one of the worst pixels of the frame on show when it is asked for, once what it is found
// by is made.
#pragma once

#include "core/jobs/desk/Desk.h"
#include "core/jobs/desk/Wanted.h"
#include "core/requests/Requests.h"

namespace taa {

class ShownWorst {
 public:
  ShownWorst(Desk& desk, Wanted& wanted) : desk_(desk), wanted_(wanted) {}

  void take(const request::FindWorst& asked) { wanted_.worst = asked; }
  void take(const request::Cancel&) { wanted_.worst.reset(); }
  void deliver();

 private:
  bool isUnderWay() const;

  Desk& desk_;
  Wanted& wanted_;
};

} // namespace taa
