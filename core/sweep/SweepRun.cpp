#include "core/sweep/SweepRun.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {

namespace {

/// Points that are not known to be done, failed or kept.
class OpenPoints {
 public:
  OpenPoints(const SweepRequest& request, const MeasurePoint& measure, const Progress& progress)
      : request_(request), measure_(measure), progress_(progress), ground_(request.spec) {
    const PointRange range = pointsOfShard(request.shard, request.spec.pointCount());
    for (std::size_t point = range.first; point < range.end; ++point) open_.push_back(point);
    report_.points = open_.size();
  }

  /// Until nothing is left but what others are about.
  SweepReport run() {
    takeKept();
    thereAlready_ = report_.kept;
    // Others give up points, too: by a failure, or by their end.
    for (bool hasChanged = true; hasChanged && !open_.empty();) {
      const std::size_t before = open_.size();
      std::erase_if(open_, [this](std::size_t point) { return isSettled(point); });
      hasChanged = open_.size() < before;
    }
    report_.elsewhere = open_.size();
    tell({}, 0, 0);
    return std::move(report_);
  }

 private:
  PointKey keyOf(std::size_t point) const {
    return PointKey(ground_.inputs(request_.spec, sweepPoint(request_.spec, point)));
  }

  void takeKept() {
    int looked = 0;
    std::erase_if(open_, [&](std::size_t point) {
      report(progress_, say<"Looking for points that are there">(), looked++, allPoints());
      const bool isKept = request_.folder.holds(keyOf(point));
      report_.kept += isKept ? 1 : 0;
      return isKept;
    });
  }

  /// Computes it unless somebody else is about it.
  bool isSettled(std::size_t point) {
    tell({}, 0, 0);
    const PointKey key = keyOf(point);
    std::optional<PointClaim> claim = request_.folder.claim(key, request_.claimTimeout);
    if (!claim) {
      const bool isKept = request_.folder.holds(key);
      report_.kept += isKept ? 1 : 0;
      return isKept;
    }
    const Progress inside = [&](std::string_view what, int done, int total) {
      claim->touch();
      return tellOnce(what, done, total);
    };
    try {
      request_.folder.keep(key, measure_(sweepPoint(request_.spec, point), inside));
      claim->finish();
      ++report_.computed;
    } catch (const Error& error) {
      report_.failures.push_back({point, error.what()});
    }
    return true;
  }

  int allPoints() const { return static_cast<int>(report_.points); }

  /// Of the point that is being computed; empty: of the sweep alone.
  bool tellOnce(std::string_view what, int done, int total) const {
    if (!progress_) return true;
    std::string text = say<"Points, %1 of them were there">(thereAlready_);
    if (!what.empty()) text += say<" (%1: %2 of %3)">(what, done, total);
    return progress_(text, static_cast<int>(report_.kept + report_.computed + report_.failures.size()),
                     allPoints());
  }
  void tell(std::string_view what, int done, int total) const {
    if (!tellOnce(what, done, total)) throw Cancelled();
  }

  const SweepRequest& request_;
  const MeasurePoint& measure_;
  const Progress& progress_;
  SweepGround ground_;
  SweepReport report_;
  std::vector<std::size_t> open_;
  std::size_t thereAlready_ = 0;
};

} // namespace

SweepReport runSweep(const SweepRequest& request, const MeasurePoint& measure, const Progress& progress) {
  return OpenPoints(request, measure, progress).run();
}

} // namespace taa
