// Lets time go on: one frame after the other, in its turn.
#pragma once

#include "core/jobs/desk/Job.h"
#include "core/jobs/desk/Transport.h"
#include "core/jobs/shot/CameraFlight.h"
#include "core/jobs/shot/Goal.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class Play final : public Job {
 public:
  Play(Desk& desk, Transport& transport, Goal& goal, CameraFlight& flight)
      : desk_(desk), transport_(transport), goal_(goal), flight_(flight) {}

  void take(const request::SetPlaying& wanted);
  void take(const request::SetLooping& wanted) { transport_.setLooping(wanted.looping); }
  void take(const request::SetPlayback& wanted) { transport_.setPlayback(wanted.playback); }

  bool isDue() override { return isPlaying() && Clock::now() >= transport_.nextFrameAt(); }
  void step() override;
  std::optional<Clock::time_point> wakesAt() override {
    return isPlaying() ? std::optional(transport_.nextFrameAt()) : std::nullopt;
  }
  bool isAwaited() const override { return false; } // it has no end

 private:
  bool isPlaying() const { return desk_.isOpen() && transport_.isPlaying(); }
  void startAgain(int first, int last);
  void advance(int from);

  Desk& desk_;
  Transport& transport_;
  Goal& goal_;
  CameraFlight& flight_;
};

} // namespace taa
