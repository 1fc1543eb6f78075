// All points of a sweep with what is known of them, as tables: what its results are merged into.
#pragma once

#include "core/sweep/SweepFolder.h"
#include "core/sweep/SweepPoints.h"
#include "core/sweep/SweepSpec.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace taa {

/// A point, and its metrics where it was measured.
struct SweepRow {
  SweepPoint point;
  std::string file; ///< name of its file
  bool isMeasured = false;
  std::vector<std::optional<double>> means; ///< over the frames, one for each metric of the sweep
  bool isOnFront = false;                   ///< see markFronts()
};

/// Rows of all points as they are in the folder, fronts marked. Throws Error.
std::vector<SweepRow> sweepRows(const SweepSpec& spec, const SweepFolder& folder);

/// The Pareto front of the sweep's trade-off, for each source and camera by itself: numbers of different
/// shots compare no settings.
void markFronts(const SweepSpec& spec, std::vector<SweepRow>& rows);

/// "point,source,camera,settings", a column for each parameter and each metric, and "pareto"; fields as RFC
/// 4180 has them. What is not known is empty.
std::string sweepCsv(const SweepSpec& spec, const std::vector<SweepRow>& rows);
nlohmann::ordered_json sweepJson(const SweepSpec& spec, const std::vector<SweepRow>& rows);

/// Writes sweep.csv and sweep.json into the folder, over those that are there, and again while points come to
/// it meanwhile: whoever is last sees all. Returns the files. Throws Error.
std::vector<std::filesystem::path> writeSweepTables(const SweepSpec& spec, const SweepFolder& folder);

} // namespace taa
