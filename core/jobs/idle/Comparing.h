// Draws the frames that views are compared with, beside the one on show.
#pragma once

#include "core/jobs/desk/Job.h"
#include "core/jobs/desk/Transport.h"
#include "core/jobs/desk/Wanted.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <vector>

namespace taa {

class Comparing final : public Job {
 public:
  Comparing(Desk& desk, const Transport& transport, const Wanted& wanted)
      : desk_(desk), transport_(transport), wanted_(wanted) {}

  void take(const request::Cancel&) { stop(); }
  void take(const request::SetViews&);

  bool isDue() override;
  void step() override;

 private:
  std::vector<int> frames() const;
  void stop();

  Desk& desk_;
  const Transport& transport_;
  const Wanted& wanted_;
  std::uint64_t stoppedAt_ = 0; // version for which `stopped_` were cancelled or failed: not again
  std::vector<int> stopped_;    // frames
};

} // namespace taa
