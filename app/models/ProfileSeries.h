// The profiles of the last frames: what each pass took, now and usually.
#pragma once

#include "core/measure/Profiler.h"

#include <deque>
#include <string>
#include <vector>

namespace taa::app {

class ProfileSeries {
 public:
  struct Row {
    std::string name;
    double last = 0.0, median = 0.0; ///< ms
    double share = 0.0;              ///< of the sum of the medians, 0 to 1
  };

  void add(FrameProfile profile);
  void clear();
  bool isEmpty() const { return profiles_.empty(); }
  const FrameProfile& last() const { return profiles_.back(); }
  const std::deque<FrameProfile>& profiles() const { return profiles_; }
  /// Every pass that ran in them, in the order of their first appearance.
  const std::vector<std::string>& names() const { return names_; }
  /// In the order of names(). A frame without a pass counts as 0 ms of it.
  std::vector<Row> rows() const;
  double medianTotal() const;
  static double timeOf(const FrameProfile& profile, const std::string& name);

 private:
  std::deque<FrameProfile> profiles_;
  std::vector<std::string> names_;
};

} // namespace taa::app
