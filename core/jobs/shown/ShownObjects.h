// Delivers where wanted objects are seen on each frame that it rests at.
#pragma once

#include "core/jobs/desk/Transport.h"
#include "core/jobs/shot/Goal.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <vector>

namespace taa {

class ShownObjects {
 public:
  ShownObjects(Desk& desk, const Transport& transport, const Goal& goal)
      : desk_(desk), transport_(transport), goal_(goal) {}

  void take(const request::Locate& wanted);
  void deliver();

 private:
  Desk& desk_;
  const Transport& transport_;
  const Goal& goal_;
  std::vector<int> objects_;
  std::uint64_t delivered_ = 0; // version
};

} // namespace taa
