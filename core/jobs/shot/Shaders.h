// Shaders read anew from their folder.
#pragma once

#include "core/jobs/context/JobContext.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class Shaders {
 public:
  explicit Shaders(JobContext& jobContext) : jobContext_(jobContext) {}

  void take(const request::ReloadShaders&);
  /// To be called once the status has said that the picture on show is not theirs yet.
  void deliver();

 private:
  JobContext& jobContext_;
  std::optional<ShadersRead> read_;
};

} // namespace taa
