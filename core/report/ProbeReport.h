// A probed pixel to hand on, with what the window tells of it: as JSON, plain text or Markdown; the same from
// taa-batch and from the window.
#pragma once

#include "core/explanation/RowExplanation.h"
#include "core/inspect/Comparison.h"
#include "core/measure/compare/ComparedPixel.h"
#include "core/probe/Sensitivity.h"
#include "core/probe/WhatIf.h"
#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"
#include "core/taa/twin/Details.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa {

/// What was looked at.
struct ShotFacts {
  std::string source, camera;
  std::string driver; ///< renderer and version
  int width = 0, height = 0;
};
nlohmann::ordered_json shotJson(const ShotFacts& shot);

struct LaneFacts {
  std::string name, preset;
  Settings settings;
  FrameInfo info;
};
nlohmann::ordered_json laneJson(const LaneFacts& lane);

/// What a lane has at the pixel.
struct ProbedLane {
  LaneFacts lane;
  twin::PixelRecord record{};
  std::vector<WhatIfRow> whatIf{};                ///< empty: not asked for
  std::vector<Sensitivity> sensitivities{};       ///< likewise
  std::shared_ptr<const twin::Details> details{}; ///< what explanations are made from; null: none are told
  std::optional<ComparedPixel> compared{};        ///< the other side; nothing: there is none
  FormulaDepth depth = FormulaDepth::Rows;        ///< of explanations
};
struct ProbeReport {
  ShotFacts shot;
  glm::ivec2 pixel{0};
  std::vector<ProbedLane> lanes;
  Comparison comparison{}; ///< that `compared` of all lanes is of
};

/// "pixel 3 4 frame 7 of builtin:fan, camera still, 960x540, preset balanced"
std::string placeText(const ShotFacts& shot, const glm::ivec2& pixel, const LaneFacts& lane);

/// "compared with motion:-1: frame 6 at 12.5 3.5", or why there is nothing.
std::string comparedText(const Comparison& comparison, const ComparedPixel& compared);
/// A row of both sides: "other 0.5, difference -0.25", or why there is no difference.
std::string comparedText(const twin::PixelRecord& now, const ComparedPixel& compared, IntermediateId id);

nlohmann::ordered_json probeJson(const ProbeReport& report);
/// The headline, then every row by stages, exact: "alpha 0.125", below it what happened there, its
/// formula and what decided it.
std::string probeText(const ProbeReport& report);
/// The same for people, rows by their labels and only those with a value; of one lane.
std::string probeTable(const ProbedLane& lane, const glm::ivec2& pixel);
/// A table for an issue or a page, each row with its unit.
std::string probeMarkdown(const ProbeReport& report);

} // namespace taa
