// Delivers where wanted objects are seen on each frame that it rests at.
#pragma once

#include "core/jobs/context/Transport.h"
#include "core/jobs/shot/SeekTarget.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <vector>

namespace taa {

class ShownObjects {
 public:
  ShownObjects(JobContext& jobContext, const Transport& transport, const SeekTarget& seekTarget)
      : jobContext_(jobContext), transport_(transport), seekTarget_(seekTarget) {}

  void take(const request::Locate& subscriptions);
  void deliver();

 private:
  JobContext& jobContext_;
  const Transport& transport_;
  const SeekTarget& seekTarget_;
  std::vector<int> objects_;
  std::uint64_t delivered_ = 0; // version
};

} // namespace taa
