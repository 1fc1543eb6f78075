// Results of the render thread on their way to the window: what is kept of each type, posted once.
#pragma once

#include "core/base/ListsOf.h"
#include "core/requests/Results.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <mutex>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace taa::app {

/// Profiles of so many frames are shown.
inline constexpr std::size_t kProfiledFrames = 120;

/// Of the results of a type that nobody has looked at yet, the first `max` are kept.
struct KeepFirst {
  std::size_t max = std::numeric_limits<std::size_t>::max();
};
/// Only the newest one is kept.
struct KeepNewest {
  bool operator()(const auto&) const { return true; }
};
/// What is kept of results of type T; where it is a member: the newest one of each value of that member.
template <class T>
inline constexpr auto kKept = KeepNewest{};
template <>
inline constexpr auto kKept<ViewResult> = &ViewResult::view;
template <>
inline constexpr auto kKept<ProbeResult> = &ProbeResult::probe;
template <>
inline constexpr auto kKept<Thumbnail> = &Thumbnail::id;
template <>
inline constexpr auto kKept<Failure> = KeepFirst{};
template <>
inline constexpr auto kKept<TraceDelivery> = KeepFirst{}; // each is of a frame
template <>
inline constexpr auto kKept<FrameProfile> = KeepFirst{.max = kProfiledFrames};
template <>
inline constexpr auto kKept<FrameMetrics> = KeepFirst{.max = 4096}; // some seconds while the window is busy

/// Any number of results between two looks cost one post, so that a busy window is never flooded.
class Mailbox {
 public:
  /// `post` is called from any thread, at most once between two takes.
  explicit Mailbox(std::function<void()> post) : post_(std::move(post)) {}

  /// Called from any thread.
  void put(Answer answer) {
    {
      const std::lock_guard lock(mutex_);
      std::visit([this](auto& result) { keep(std::move(result)); }, answer.result);
      if (std::exchange(posted_, true)) return;
    }
    post_();
  }

  /// What arrived since the last look, as kKept says.
  ListsOf<Result> take() {
    const std::lock_guard lock(mutex_);
    posted_ = false;
    return std::exchange(kept_, {});
  }

 private:
  template <class T>
  void keep(T newest) {
    std::vector<T>& kept = kept_.all<T>();
    if constexpr (std::is_same_v<decltype(kKept<T>), const KeepFirst>) {
      if (kept.size() < kKept<T>.max) kept.push_back(std::move(newest));
    } else {
      const auto old = std::ranges::find(kept, std::invoke(kKept<T>, newest), kKept<T>);
      if (old == kept.end())
        kept.push_back(std::move(newest));
      else
        *old = std::move(newest);
    }
  }

  std::function<void()> post_;
  std::mutex mutex_;
  ListsOf<Result> kept_;
  bool posted_ = false;
};

} // namespace taa::app
