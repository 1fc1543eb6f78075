// The points of a sweep: each is work of its own, which anybody can do at any time with the same result.
#pragma once

#include "core/settings/Settings.h"
#include "core/sweep/SweepSpec.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// Indices into what the sweep goes over.
struct SweepPoint {
  std::size_t index = 0; ///< sources slowest, then cameras, settings, ranges; the last range fastest
  std::size_t source = 0, camera = 0, settings = 0;
  std::vector<std::size_t> values; ///< one for each range
};

/// Expects index < spec.pointCount().
SweepPoint sweepPoint(const SweepSpec& spec, std::size_t index);

/// The settings with the point's values.
Settings settingsOfPoint(const SweepSpec& spec, const SweepPoint& point);

/// Part `index`, from 1, of `count`: points that lie beside one another, for those share references.
struct SweepShard {
  std::size_t index = 1, count = 1;
};
/// First point of the shard, and the one behind its last.
struct PointRange {
  std::size_t first = 0, end = 0;
};
PointRange pointsOfShard(const SweepShard& shard, std::size_t pointCount);

/// FNV-1a, 64 bits, as 16 hexadecimal digits: no secret, but the same everywhere.
std::string digestOf(std::string_view bytes);

/// What all points of a sweep depend on besides the sweep: the program and the sources' own files.
class SweepGround {
 public:
  /// Reads each source's file: of a scene itself, of a capture its capture.json, not what they name. Throws
  /// Error.
  explicit SweepGround(const SweepSpec& spec);

  /// All that the point's numbers are a function of. Equal texts: equal numbers, on the same driver.
  nlohmann::ordered_json inputs(const SweepSpec& spec, const SweepPoint& point) const;

 private:
  std::string shaders_;
  std::vector<std::string> sources_; ///< digest of each
};

} // namespace taa
