// Compiles what settings need that somebody looks at and may take.
#pragma once

#include "core/jobs/desk/Job.h"
#include "core/jobs/desk/Transport.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class CompilingAhead final : public Job {
 public:
  CompilingAhead(Desk& desk, const Transport& transport) : desk_(desk), transport_(transport) {}

  void take(const request::Prepare& wanted);
  void take(const request::SetSettings&) { prepared_.reset(); } // it came too late

  bool isDue() override { return prepared_ && desk_.isOpen() && !transport_.isPlaying(); }
  void step() override;

 private:
  Desk& desk_;
  const Transport& transport_;
  std::optional<Settings> prepared_;
};

} // namespace taa
