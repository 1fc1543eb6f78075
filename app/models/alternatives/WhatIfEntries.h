// The pixel under other choices, nearest to the reference first or what changes it most, and what they make
// of whole pictures.
#pragma once

#include "core/requests/Results.h"
#include "core/sweep/MetricsOfFrames.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace taa::app {

/// What is measured of whole pictures: how much they ghost, flicker, and how sharp they are.
inline constexpr std::array<Metric, 3> kPictureMetrics{Metric::GhostEnergy, Metric::Flicker,
                                                       Metric::Sharpness};

struct WhatIfEntry {
  std::size_t row = 0; ///< of ProbeResult::whatIf
  /// From the reference: root of the mean squared difference of red, green and blue as they are shown;
  /// nothing: there is no reference.
  std::optional<double> error;
  double change = 0.0; ///< the same from what is resolved by the settings in force
  bool operator==(const WhatIfEntry&) const = default;
};

/// By error where there is a reference, the nearest first; else by change, the largest first, unless they are
/// to stay in their own order, in which equal ones always are.
std::vector<WhatIfEntry> whatIfEntries(const ProbeResult& result, bool sortsByChange = true);

/// Means of the picture metrics by the settings they were measured of.
class PictureNumbers {
 public:
  using Means = std::array<std::optional<double>, kPictureMetrics.size()>;
  void clear() { known_.clear(); }
  void add(const Settings& settings, const LaneMetrics& frames);
  /// Null: not measured.
  const Means* find(const Settings& settings) const;
  bool isEmpty() const { return known_.empty(); }

 private:
  std::vector<std::pair<Settings, Means>> known_;
};

/// What a row of it is made of; expects that `settings` had it. Nothing: they have no such row any more.
std::optional<Variant> variantOf(const Settings& settings, const WhatIfRow& row);

} // namespace taa::app
