// The profiles of the last frames.
#include "app/models/ProfileSeries.h"

#include "app/session/Mailbox.h"

#include "core/base/Median.h"

#include <algorithm>
#include <utility>

namespace taa::app {

void ProfileSeries::add(FrameProfile profile) {
  for (const PassCost& cost : profile.passes) {
    if (std::ranges::find(names_, cost.name) != names_.end()) continue;
    const bool hasBetween = !names_.empty() && names_.back() == kBetweenPasses;
    names_.insert(hasBetween ? names_.end() - 1 : names_.end(), cost.name);
  }
  profiles_.push_back(std::move(profile));
  if (profiles_.size() > kProfiledFrames) profiles_.pop_front();
}

void ProfileSeries::clear() {
  profiles_.clear();
  names_.clear();
}

double ProfileSeries::timeOf(const FrameProfile& profile, const std::string& name) {
  const auto found = std::ranges::find(profile.passes, name, &PassCost::name);
  return found == profile.passes.end() ? 0.0 : found->milliseconds;
}

std::vector<ProfileSeries::Row> ProfileSeries::rows() const {
  std::vector<Row> rows;
  double sum = 0.0;
  for (const std::string& name : names_) {
    std::vector<double> times;
    for (const FrameProfile& profile : profiles_) times.push_back(timeOf(profile, name));
    rows.push_back({name, times.back(), median(times), 0.0});
    sum += rows.back().median;
  }
  for (Row& row : rows) row.share = sum > 0.0 ? row.median / sum : 0.0;
  return rows;
}

double ProfileSeries::medianTotal() const {
  std::vector<double> totals;
  for (const FrameProfile& profile : profiles_) totals.push_back(profile.totalMs);
  return median(std::move(totals));
}

} // namespace taa::app
