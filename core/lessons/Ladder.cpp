#include "core/lessons/Ladder.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/inspect/Inspector.h"
#include "core/lessons/LessonCheck.h"
#include "core/settings/Lanes.h"
#include "core/settings/Presets.h"
#include "core/taa/TextureFetches.h"

#include <algorithm>
#include <cstddef>

namespace taa {

namespace {

constexpr int kTimedFrame = 2; ///< it has a history, and one that has a history

/// What a step of a ladder adds, "4. object motion"; of a whole pipeline its label.
std::string rungLabel(const Preset& rung) {
  const std::string& label = rung.label;
  const std::size_t colon = label.find(": ");
  if (rung.step == 0 || colon == std::string::npos) return label;
  return std::to_string(rung.step) + ". " + label.substr(colon + 2);
}

} // namespace

std::string ladderMarkdown(const std::vector<Rung>& ladder, const LadderColumns& columns) {
  if (ladder.empty()) return {};
  const bool isTimed = !columns.times.empty();
  std::string text = "| " + say<"Preset">() + " | " + say<"PSNR">() + " | " + say<"Flicker">() + " | " +
                     say<"Fetches">() + (isTimed ? " | " + say<"Time">() : std::string()) +
                     " |\n|---|---|---|---|";
  text += isTimed ? "---|\n" : "\n";
  for (std::size_t index = 0; index < ladder.size(); ++index) {
    const Rung& rung = ladder[index];
    const Preset& shown = preset(rung.preset);
    const std::string label = rungLabel(shown);
    text +=
        "| " +
        (columns.isLinked ? "[" + label + "](" + std::string(kRungScheme) + ":" + rung.preset + ")" : label) +
        " | " + fixedText(rung.psnr, 1) + " | " + fixedText(rung.flicker, 4) + " | " +
        std::to_string(textureFetches(shown.settings).sum()) + " |";
    if (isTimed) text += " " + fixedText(columns.times.at(index), 2) + " | ";
    text += "\n";
  }
  text += "\n" + say<"*Fetches*: texture reads of the resolve for a pixel, a tap of a filter as one.">();
  if (isTimed) text += " " + say<"*Time*: of the resolve, as many times that of the first row.">();
  return text + "\n";
}

std::vector<double> measureTimes(Inspector& inspector, const LessonState& step,
                                 const std::vector<Rung>& ladder, const Progress& progress) {
  std::vector<double> times;
  if (ladder.empty()) return times;
  LessonState state = step;
  state.shot.settings.settings = preset(ladder.front().preset).settings;
  state.shot.frame = std::min(state.shot.frame, kTimedFrame);
  times.push_back(1.0);
  while (times.size() < ladder.size()) {
    state.lanes.clear();
    for (std::size_t rung = times.size();
         rung < ladder.size() && state.lanes.size() + 1 < std::size_t{kMaxLanes}; ++rung)
      state.lanes.push_back({"", preset(ladder[rung].preset).settings});
    openState(inspector, state, progress);
    for (std::size_t lane = 1; lane <= state.lanes.size(); ++lane)
      times.push_back(inspector.profiler().measureRatio(static_cast<int>(lane), 0, progress).median);
  }
  return times;
}

} // namespace taa
