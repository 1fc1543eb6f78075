// The verdict on a pixel to hand on, as JSON and as text; the same figures in both.
#pragma once

#include "core/inspect/VerdictOfShot.h"
#include "core/report/ProbeReport.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace taa {

struct VerdictOfLane {
  LaneFacts lane;
  VerdictAnswer answer;
  std::optional<RemedyAnswer> remedies; ///< nothing: they were not tried
};
struct VerdictReport {
  ShotFacts shot;
  glm::ivec2 pixel{0};
  int frame = 0, samples = 0; ///< samples: of the references
  std::vector<VerdictOfLane> lanes;
};

nlohmann::ordered_json verdictJson(const VerdictReport& report);
/// The sentence, what was measured, the rows that decided it, the parts of the error and the remedies.
std::string verdictText(const VerdictOfLane& lane);

} // namespace taa
