// Shaders read anew from their folder.
#pragma once

#include "core/jobs/desk/Desk.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class Shaders {
 public:
  explicit Shaders(Desk& desk) : desk_(desk) {}

  void take(const request::ReloadShaders&);
  /// To be called once the status has said that the picture on show is not theirs yet.
  void deliver();

 private:
  Desk& desk_;
  std::optional<ShadersRead> read_;
};

} // namespace taa
