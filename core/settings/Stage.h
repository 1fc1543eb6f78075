// The stages in the order in which resolve.frag runs them; output, reference and faults behind them: the one
// list that tables, panels, files and the profiler take their order from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace taa {

enum class Stage : std::uint8_t {
  Jitter,
  Inputs,
  DilateMotion,
  Reproject,
  SampleHistory,
  FilterCurrent,
  Neighborhood,
  ValidateHistory,
  RectifyHistory,
  BlendWeight,
  Blend,
  Output,
  Reference, ///< what the resolve should have given; no part of it
  Faults,    ///< mistakes of an integration, injected into inputs and resolve; no part of it either
};

struct StageInfo {
  Stage stage;
  std::string_view id;    ///< name of its GLSL file where it has one
  std::string_view label; ///< as a heading
  std::string_view description;
  std::string_view main; ///< the intermediate that says most about it (core/taa/Intermediates.h); empty: none
};

inline constexpr std::array<StageInfo, 14> kStages{{
    {Stage::Jitter, "jitter", "Jitter", "Moves the picture by a part of a pixel, a different one each frame.",
     ""},
    {Stage::Inputs, "inputs", "Inputs",
     "What the renderer draws for this frame: color, depth, motion, normal, object id.", "color"},
    {Stage::DilateMotion, "dilate_motion", "Dilate motion",
     "Chooses the neighbor whose motion this pixel follows, so that silhouettes move with what is in front.",
     "dilatedMotion"},
    {Stage::Reproject, "reproject", "Reproject",
     "Finds where this pixel's surface was in the previous frame.", "speed"},
    {Stage::SampleHistory, "sample_history", "Sample history", "Reads the accumulated picture at that place.",
     "historyRaw"},
    {Stage::FilterCurrent, "filter_current", "Filter current",
     "Rebuilds the color at the pixel's center from the jittered samples around it.", "currentFiltered"},
    {Stage::Neighborhood, "neighborhood", "Neighborhood",
     "Measures the colors around the pixel and bounds them by a box.", "boxMax"},
    {Stage::ValidateHistory, "validate_history", "Validate history",
     "Rejects history that belongs to something else: off the screen, or behind what is now in front.",
     "rejectReason"},
    {Stage::RectifyHistory, "rectify_history", "Rectify history",
     "Pulls history that lies outside the box back to it.", "historyRectified"},
    {Stage::BlendWeight, "blend_weight", "Blend weight", "Decides α, how much the current frame counts.",
     "alpha"},
    {Stage::Blend, "blend", "Blend", "Mixes current and history into the resolved picture.", "resolved"},
    {Stage::Output, "output", "Output",
     "What is shown of the resolved picture: sharpened, or blurred where it moves fast. Never goes into "
     "history.",
     "output"},
    {Stage::Reference, "reference", "Reference",
     "The same instant, supersampled: what the output should be, how far it is from it, and how much more "
     "it flickers. Drawn while somebody looks at it.",
     ""},
    {Stage::Faults, "faults", "Faults",
     "Mistakes of an integration, injected on purpose. All are off unless somebody sets them.", ""},
}};

/// Those of the resolve's own shader.
inline constexpr std::span<const StageInfo> kResolveStages =
    std::span(kStages).first(static_cast<std::size_t>(Stage::Blend) + 1);

constexpr const StageInfo& stageInfo(Stage stage) {
  return kStages[static_cast<std::size_t>(stage)];
}

} // namespace taa
