// Goes to the frame that is wanted, and makes the frame on show exact.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/Transport.h"
#include "core/jobs/shot/CameraFlight.h"
#include "core/jobs/shot/SeekTarget.h"
#include "core/requests/Requests.h"

#include <string>

namespace taa {

class Replay final : public Job {
 public:
  Replay(JobContext& jobContext, Transport& transport, SeekTarget& seekTarget, CameraFlight& flight)
      : jobContext_(jobContext), transport_(transport), seekTarget_(seekTarget), flight_(flight) {}

  void take(const request::Seek& seek);
  void take(const request::Step& step);
  void take(const request::Cancel&);

  bool isDue() override { return jobContext_.isOpen() && (seekTarget_.frame || needsRefinement()); }
  void step() override;

 private:
  bool needsRefinement() const;
  void setGoal(int frame);
  bool goNear();
  void replay(int frame, const std::string& what);

  JobContext& jobContext_;
  Transport& transport_;
  SeekTarget& seekTarget_;
  CameraFlight& flight_;
};

} // namespace taa
