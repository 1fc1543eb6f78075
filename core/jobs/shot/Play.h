// Lets time go on: one frame after the other, in its turn.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/Transport.h"
#include "core/jobs/shot/CameraFlight.h"
#include "core/jobs/shot/SeekTarget.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class Play final : public Job {
 public:
  Play(JobContext& jobContext, Transport& transport, SeekTarget& seekTarget, CameraFlight& flight)
      : jobContext_(jobContext), transport_(transport), seekTarget_(seekTarget), flight_(flight) {}

  void take(const request::SetPlaying& subscriptions);
  void take(const request::SetLooping& subscriptions) { transport_.setLooping(subscriptions.looping); }
  void take(const request::SetPlayback& subscriptions) { transport_.setPlayback(subscriptions.playback); }

  bool isDue() override { return isPlaying() && Clock::now() >= transport_.nextFrameAt(); }
  void step() override;
  std::optional<Clock::time_point> wakesAt() override {
    return isPlaying() ? std::optional(transport_.nextFrameAt()) : std::nullopt;
  }
  bool isAwaited() const override { return false; } // it has no end

 private:
  bool isPlaying() const { return jobContext_.isOpen() && transport_.isPlaying(); }
  void startAgain(int first, int last);
  void advance(int from);

  JobContext& jobContext_;
  Transport& transport_;
  SeekTarget& seekTarget_;
  CameraFlight& flight_;
};

} // namespace taa
