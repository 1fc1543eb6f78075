// The lineage of a pixel to hand on, as JSON and as lines of a table; the same figures in both.
#pragma once

#include "core/report/ProbeReport.h"
#include "core/verdict/lineage/Lineage.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace taa {

struct LineageOfLane {
  LaneFacts lane;
  Lineage lineage;
};
struct LineageReport {
  ShotFacts shot;
  glm::ivec2 pixel{0};
  std::vector<LineageOfLane> lanes;
};

nlohmann::ordered_json lineageJson(const LineageReport& report);

/// A line of headings, then one for each frame, then one for each part that is no frame's.
std::vector<std::vector<std::string>> lineageTable(const Lineage& lineage);

} // namespace taa
