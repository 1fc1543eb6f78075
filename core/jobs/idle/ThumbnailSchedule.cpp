// The order and the pace of thumbnails.
#include "core/jobs/idle/ThumbnailSchedule.h"

#include <algorithm>

namespace taa {

namespace {
constexpr std::chrono::milliseconds kPeriod{250}, kSettled{150};
// Before the first one is drawn its cost is not known, and the spread of costs is large.
constexpr std::chrono::milliseconds kMinRoom{2};
// What takes longer has compiled a program, which the next one need not.
constexpr std::chrono::milliseconds kMaxCost{4};
} // namespace

void ThumbnailSchedule::want(const glm::ivec2& texels) {
  if (texels == texels_) return;
  texels_ = texels;
  latest_ = drawnOf_ = 0; // all anew
  place_ = 0;
}

std::optional<ThumbnailSchedule::Clock::time_point>
ThumbnailSchedule::dueAt(std::uint64_t version, Clock::time_point now,
                         std::optional<Clock::time_point> busyAt) {
  if (texels_.x <= 0 || texels_.y <= 0) return {};
  if (version != latest_) {
    latest_ = version;
    latestSince_ = now;
    left_ = rows_.size();
  }
  if (left_ == 0) return {};
  Clock::time_point due = now;
  if (busyAt)
    due = std::max(now, lastBegan_ + kPeriod / static_cast<int>(rows_.size()));
  else if (drawnOf_ != latest_) // else its values are cached
    due = std::max(now, latestSince_ + kSettled);
  if (busyAt && due + std::max<Clock::duration>(2 * cost_, kMinRoom) > *busyAt) return {};
  return due;
}

void ThumbnailSchedule::drawn(Clock::time_point began, Clock::time_point ended) {
  if (drawnOf_ != latest_) cost_ = std::min<Clock::duration>(ended - began, kMaxCost);
  drawnOf_ = latest_;
  lastBegan_ = began;
  place_ = (place_ + 1) % rows_.size();
  --left_;
}

} // namespace taa
