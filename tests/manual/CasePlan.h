// Which cases the doctor is tried on: scenes, cameras and captures with faults, in all combinations.
#pragma once

#include "core/settings/Faults.h"
#include "tests/manual/DoctorCases.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace taa {

struct CasePlan {
  std::vector<std::string> scenes;   ///< "gallery" of builtin:gallery
  std::vector<std::string> cameras;  ///< of scenes
  std::vector<std::string> captures; ///< folders
  std::vector<Fault> faults;
  /// Kinds of cases; presets are healthy frames of all engines.
  bool healthy = true, single = true, half = true, pairs = true, presets = false;
  glm::ivec2 sizePx{240, 136}; ///< of scenes
  int frames = 14;
};

/// A case, and where its frames come from.
struct PlannedCase {
  DoctorCase tried;
  std::string path; ///< as openForDoctor() takes it
};

/// Those of one source and camera follow each other, healthy frames first. Captures get no faults that have
/// to be drawn. A pair is a fault with one of another part of the table: each fault has one pair of its own
/// with each source and camera, another one with each.
std::vector<PlannedCase> plannedCases(const CasePlan& plan);

} // namespace taa
