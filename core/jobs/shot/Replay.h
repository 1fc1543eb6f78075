// Goes to the frame that is wanted, and makes the frame on show exact.
#pragma once

#include "core/jobs/desk/Job.h"
#include "core/jobs/desk/Transport.h"
#include "core/jobs/shot/CameraFlight.h"
#include "core/jobs/shot/Goal.h"
#include "core/requests/Requests.h"

#include <string>

namespace taa {

class Replay final : public Job {
 public:
  Replay(Desk& desk, Transport& transport, Goal& goal, CameraFlight& flight)
      : desk_(desk), transport_(transport), goal_(goal), flight_(flight) {}

  void take(const request::Seek& seek);
  void take(const request::Step& step);
  void take(const request::Cancel&);

  bool isDue() override { return desk_.isOpen() && (goal_.frame || needsRefinement()); }
  void step() override;

 private:
  bool needsRefinement() const;
  void setGoal(int frame);
  bool goNear();
  void replay(int frame, const std::string& what);

  Desk& desk_;
  Transport& transport_;
  Goal& goal_;
  CameraFlight& flight_;
};

} // namespace taa
