// Results of the render thread on their way to the window: the newest of each kind, posted once.
#pragma once

#include "core/requests/Results.h"

#include <array>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace taa::app {

inline constexpr int kViewCount = 4;

/// What arrived since the window last looked.
struct Delivery {
  std::array<std::optional<ViewResult>, kViewCount> pictures;
  std::vector<ProbeResult> probes; ///< the newest of each probe
  std::optional<Status> status;
  std::optional<Work> work;
  std::vector<Failure> errors;        ///< all of them
  std::vector<FrameProfile> profiles; ///< all of them: each is a frame
  std::optional<StageCosts> costs;
  std::vector<Thumbnail> thumbnails; ///< the newest of each row
  std::vector<FrameMetrics> metrics; ///< all of them: each is of a frame
  std::optional<ShadersRead> shaders;
  std::optional<ExportResult> exported;
  std::optional<ObjectArea> area;
  std::optional<WorstDelivery> worst;
  std::optional<LineageDelivery> lineage;
  std::optional<StageShares> shares;
  std::vector<TraceDelivery> traces; ///< all of them: each is a frame
  std::optional<VerdictDelivery> verdict;
};

/// Any number of results between two looks cost one post, so that a busy window is never flooded.
class Mailbox {
 public:
  /// `post` is called from any thread, at most once between two takes.
  explicit Mailbox(std::function<void()> post) : post_(std::move(post)) {}

  /// Called from any thread.
  void put(Answer answer);

  Delivery take() {
    const std::lock_guard lock(mutex_);
    posted_ = false;
    return std::exchange(delivery_, {});
  }

 private:
  std::function<void()> post_;
  std::mutex mutex_;
  Delivery delivery_;
  bool posted_ = false;
};

} // namespace taa::app
