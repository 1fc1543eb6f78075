// What a request of the render thread is about, so that its answers can say what they answer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace taa {

enum class RequestKind {
  None, ///< nobody asked: the program itself
  Source,
  Size,
  Camera,
  MotionModes,
  Settings,
  Lanes,
  Time,
  Views,
  Probes,
  Traces,
  Thumbnails,
  Objects,
  Classes,
  Restarts,
  Flight,
  Recording,
  FlownCameras,
  Shaders,
  Export,
  Profile,
  Reference,
  Worst,
  Lineage,
  Metrics,
  Verdicts
};
inline constexpr std::size_t kRequestKinds = static_cast<std::size_t>(RequestKind::Verdicts) + 1;

/// Rises with each request; 0: none.
using RequestId = std::uint64_t;

/// The latest request of each kind.
class LatestRequests {
 public:
  void note(RequestKind kind, RequestId id) {
    ids_[static_cast<std::size_t>(kind)] = id;
    last_ = id;
  }
  RequestId of(RequestKind kind) const { return ids_[static_cast<std::size_t>(kind)]; }
  RequestId last() const { return last_; } ///< of any kind

 private:
  std::array<RequestId, kRequestKinds> ids_{};
  RequestId last_ = 0;
};

/// The one kind that they all are, where a flown camera counts as a camera; nothing: there are none, or
/// several.
std::optional<RequestKind> onlyCause(const std::vector<RequestKind>& causes);

/// What is being done while a frame is made anew because of requests of these kinds.
std::string replayText(const std::vector<RequestKind>& causes);

} // namespace taa
