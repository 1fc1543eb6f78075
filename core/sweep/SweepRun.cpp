#include "core/sweep/SweepRun.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {

namespace {

/// Points that are not known to be done, failed or kept.
class OpenPoints {
 public:
  OpenPoints(const SweepRequest& request, const MeasurePoint& measure, const Progress& progress)
      : request_(request), measure_(measure), progress_(progress), ground_(request.spec) {}

  SweepReport run() {
    for (const std::size_t point : takeOpen()) compute(point);
    tell();
    return std::move(report_);
  }

 private:
  PointKey keyOf(std::size_t point) const {
    return PointKey(ground_.inputs(request_.spec, sweepPoint(request_.spec, point)));
  }

  /// Those that are not there.
  std::vector<std::size_t> takeOpen() {
    const PointRange range = pointsOfShard(request_.shard, request_.spec.pointCount());
    report_.points = range.end - range.first;
    std::vector<std::size_t> open;
    for (std::size_t point = range.first; point < range.end; ++point) {
      report(progress_, say<"Looking for points that are there">(), static_cast<int>(point - range.first),
             allPoints());
      if (!request_.folder.holds(keyOf(point))) open.push_back(point);
    }
    report_.kept = report_.points - open.size();
    return open;
  }

  void compute(std::size_t point) {
    tell();
    const Progress inside = [&](std::string_view what, int done, int total) {
      return tellOnce(say<" (%1: %2 of %3)">(what, done, total));
    };
    try {
      request_.folder.keep(keyOf(point), measure_(sweepPoint(request_.spec, point), inside));
      ++report_.computed;
    } catch (const Error& error) {
      report_.failures.push_back({point, error.what()});
    }
  }

  int allPoints() const { return static_cast<int>(report_.points); }

  /// `inside`: how far the point is that is being computed.
  bool tellOnce(const std::string& inside) const {
    if (!progress_) return true;
    return progress_(say<"Points, %1 of them were there">(report_.kept) + inside,
                     static_cast<int>(report_.kept + report_.computed + report_.failures.size()),
                     allPoints());
  }
  void tell() const {
    if (!tellOnce({})) throw Cancelled();
  }

  const SweepRequest& request_;
  const MeasurePoint& measure_;
  const Progress& progress_;
  SweepGround ground_;
  SweepReport report_;
};

} // namespace

SweepReport runSweep(const SweepRequest& request, const MeasurePoint& measure, const Progress& progress) {
  return OpenPoints(request, measure, progress).run();
}

} // namespace taa
