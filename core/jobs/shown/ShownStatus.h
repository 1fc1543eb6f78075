// Delivers the status whenever any of it has changed.
#pragma once

#include "core/jobs/context/Subscriptions.h"
#include "core/jobs/context/Transport.h"
#include "core/jobs/shot/CameraFlight.h"
#include "core/jobs/shot/SeekTarget.h"
#include "core/jobs/shot/ShotChanges.h"

namespace taa {

class ShownStatus {
 public:
  ShownStatus(JobContext& jobContext, const Transport& transport, const SeekTarget& seekTarget,
              const CameraFlight& flight, const ShotChanges& changes, const Subscriptions& subscriptions)
      : jobContext_(jobContext), transport_(transport), seekTarget_(seekTarget), flight_(flight),
        changes_(changes), subscriptions_(subscriptions) {}

  /// Before the pictures of a frame that is not exact or not the wished one.
  void deliverBefore();
  /// After those of one that is.
  void deliver();

 private:
  void addShot(Status& status) const;

  JobContext& jobContext_;
  const Transport& transport_;
  const SeekTarget& seekTarget_;
  const CameraFlight& flight_;
  const ShotChanges& changes_;
  const Subscriptions& subscriptions_;
};

} // namespace taa
