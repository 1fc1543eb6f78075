// The state of a lesson's step as a session: the keys of its window's state are those that app/window and the
// panels read.
#include "core/lessons/LessonState.h"

#include "core/picture/ColorMap.h"
#include "core/picture/StyleText.h"
#include "core/picture/Visualizer.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <string>

namespace taa {

using nlohmann::ordered_json;

namespace {

/// A small picture alone in the window is shown twice as large.
constexpr double kAloneZoom = 2.0;

ordered_json cameraJson(double zoom, const glm::dvec2& center) {
  return {{"fit", false}, {"zoom", zoom}, {"center", {center.x, center.y}}};
}

ordered_json styleJson(const ViewStyle& style) {
  return {{"low", style.low},
          {"high", style.high},
          {"exposure", style.exposure},
          {"channels", {style.red, style.green, style.blue}},
          {"map", colorMapName(style.map)},
          {"marks", style.markInvalid}};
}

ordered_json viewJson(const LessonView& view, const LessonState& state) {
  ViewStyle style = defaultStyle(intermediate(view.id));
  for (const std::string& assignment : view.style) applyStyle(style, assignment);
  ordered_json json{{"intermediate", intermediate(view.id).name},
                    {"styles", {{std::string(intermediate(view.id).name), styleJson(style)}}},
                    {"comparedWith", comparisonText(view.comparison)},
                    {"shows", showingName(view.showing)},
                    {"overlays",
                     {{"clipped", style.markClipped},
                      {"rejected", style.markRejected},
                      {"outlines", style.outlineObjects},
                      {"arrows", style.arrows},
                      {"grid", true}}}};
  if (state.look)
    json["camera"] = cameraJson(state.look->zoom, glm::dvec2(state.look->pixel) + 0.5);
  else if (state.views.size() == 1 && state.shot.size.x <= kLessonSizePx.x)
    json["camera"] = cameraJson(kAloneZoom, 0.5 * glm::dvec2(state.shot.size));
  return json;
}

ordered_json viewsJson(const LessonState& state) {
  ordered_json views = ordered_json::array();
  for (const LessonView& view : state.views) views.push_back(viewJson(view, state));
  const std::size_t count = state.views.size() == 3 ? 4 : state.views.size();
  return {{"count", count}, {"active", 0}, {"linked", true}, {"views", views}};
}

ordered_json plotsJson(const LessonState& state) {
  ordered_json rows = ordered_json::array();
  for (const IntermediateId id : state.plots) {
    ordered_json channels = ordered_json::array();
    for (int channel = 0; channel < intermediate(id).channels; ++channel) channels.push_back(channel);
    rows.push_back({{"row", intermediate(id).name}, {"channels", channels}});
  }
  return {{"rows", rows}};
}

ordered_json pipelineJson(const LessonState& state) {
  ordered_json open = ordered_json::array();
  for (const Stage stage : state.stages) open.push_back(stageInfo(stage).id);
  return {{"open", open}, {"at", stageInfo(state.stages.back()).id}};
}

/// The plot has the axes of the box.
ordered_json probeStateJson(const LessonState& state) {
  ordered_json folded = ordered_json::array();
  for (const StageInfo& info : kStages) {
    const auto isOfStage = [&](IntermediateId id) { return intermediate(id).stage == info.stage; };
    if (!state.values.empty() && std::ranges::none_of(state.values, isOfStage)) folded.push_back(info.id);
  }
  const bool isRgb = state.shot.settings.settings.space.color == ColorSpace::Rgb;
  ordered_json probe{{"tab", state.tab}, {"space", isRgb ? "rgb" : "ycocg"}, {"folded", folded}};
  if (!state.values.empty()) probe["at"] = intermediate(state.values.front()).name;
  return probe;
}

} // namespace

SessionFile lessonSession(const LessonState& state) {
  ordered_json window;
  window["views"] = viewsJson(state);
  if (!state.plots.empty()) window["plots"] = plotsJson(state);
  if (!state.stages.empty()) window["pipeline"] = pipelineJson(state);
  window["probe"] = probeStateJson(state);
  ordered_json probes = ordered_json::array();
  for (const glm::ivec2& pixel : state.probes)
    probes.push_back(
        {{"x", pixel.x}, {"y", pixel.y}, {"frame", state.shot.frame}, {"followsSurface", false}});
  window["probes"] = probes;
  window["activeProbe"] = state.probes.empty() ? -1 : 0;
  window["referenceSamples"] = state.samples;
  window["panels"] = {{"pipeline", true}, {"scene", false}, {"probe", true}, {"lower", state.page}};
  SessionFile session = state.shot;
  session.window = window.dump();
  return session;
}

} // namespace taa
