// Verdicts over the history of a whole picture to hand on, as JSON and as text: how many pixels each category
// has, what the error is made of, and the worst pixels of each; the same figures in both.
#pragma once

#include "core/base/Progress.h"
#include "core/report/ProbeReport.h"
#include "core/taa/Intermediates.h"
#include "core/verdict/parts/WorstPixels.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace taa {

class Inspector;

/// A category of a row of them.
struct CategoryOfMap {
  IntermediateId row;
  int category = 0;
  std::size_t pixels = 0;        ///< that have it
  std::vector<WorstPixel> worst; ///< by their absolute error; none of category 0, in which nothing is wrong
};
/// A row of errors.
struct ErrorOfMap {
  IntermediateId row;
  double mean = 0.0; ///< of its amounts
  std::vector<WorstPixel> worst;
};
struct MapOfLane {
  LaneFacts lane;
  std::size_t pixels = 0; ///< of the picture
  std::vector<CategoryOfMap> categories;
  std::vector<ErrorOfMap> errors;
};
struct MapReport {
  ShotFacts shot;
  int frame = 0, samples = 0; ///< samples: of the references
  std::vector<MapOfLane> lanes;
};

/// Of the frame on show, with so many worst pixels of each; makes the rows that it takes. Throws Error,
/// Cancelled.
MapOfLane mapOfLane(Inspector& inspector, const LaneFacts& lane, int index, int samples, int worst,
                    const Progress& progress);

nlohmann::ordered_json mapJson(const MapReport& report);
std::string mapText(const MapOfLane& lane);

} // namespace taa
