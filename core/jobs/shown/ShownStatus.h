// Delivers the status whenever any of it has changed.
#pragma once

#include "core/jobs/desk/Transport.h"
#include "core/jobs/desk/Wanted.h"
#include "core/jobs/shot/CameraFlight.h"
#include "core/jobs/shot/Goal.h"
#include "core/jobs/shot/ShotChanges.h"

namespace taa {

class ShownStatus {
 public:
  ShownStatus(Desk& desk, const Transport& transport, const Goal& goal, const CameraFlight& flight,
              const ShotChanges& changes, const Wanted& wanted)
      : desk_(desk), transport_(transport), goal_(goal), flight_(flight), changes_(changes), wanted_(wanted) {
  }

  /// Before the pictures of a frame that is not exact or not the wished one.
  void deliverBefore();
  /// After those of one that is.
  void deliver();

 private:
  void addShot(Status& status) const;

  Desk& desk_;
  const Transport& transport_;
  const Goal& goal_;
  const CameraFlight& flight_;
  const ShotChanges& changes_;
  const Wanted& wanted_;
};

} // namespace taa
