// What is wrong with the active probe's pixel, and then what corrects it, while nothing else is to be done.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/Transport.h"
#include "core/requests/Requests.h"
#include "core/requests/Results.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace taa {

class PixelJudging final : public Job {
 public:
  PixelJudging(JobContext& jobContext, const Transport& transport)
      : jobContext_(jobContext), transport_(transport) {}

  void take(const request::SetVerdicts& subscriptions);
  void take(const request::SetProbes&) { shown_.reset(); } // noted again when they are delivered
  void take(const request::Cancel&);
  void settle() override { endIfDone(); }

  bool isDue() override;
  /// The verdict, or what corrects it, or what that costs. Any request interrupts it: a verdict begins anew
  /// then, with the references that are there, and remedies go on with the next one.
  void step() override;

  /// The active probe of the frame on show.
  void noteShown(const ProbeResult& result);

 private:
  struct Place {
    int frame = 0;
    glm::ivec2 pixel{0};
    std::uint64_t version = 0, shotVersion = 0; ///< of the frame on show, and of all
  };
  /// What is known of a place.
  struct Known {
    VerdictDelivery delivery;
    RemedySearch search;
    bool isWhole = false; ///< nothing more is to come: all is told, it failed, or it was cancelled
  };

  bool isKnown() const;
  void beginAnew();
  void tryOn();
  void giveUp(const std::string& whyNot);
  void endIfDone();

  JobContext& jobContext_;
  const Transport& transport_;
  bool isWanted_ = false;
  std::optional<Place> shown_; // nothing: there is no probe, or nothing to see of it
  Known known_;
  bool isTold_ = false; // somebody was told that it is under way
};

} // namespace taa
