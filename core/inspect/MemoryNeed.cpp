#include "core/inspect/MemoryNeed.h"

#include "core/render/SceneRenderer.h"
#include "core/settings/Parameters.h"
#include "core/taa/TaaPass.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace taa {

namespace {

constexpr std::size_t kFrames = 2;          // on show, and being made
constexpr std::size_t kHistoriesOfLane = 3; // resolved from, shown, resolved into
constexpr std::size_t kFreeHistories = 4;   // at most, that the pool holds for later

} // namespace

MemoryNeed memoryNeed(const std::vector<Settings>& lanes, const glm::ivec2& picturePx,
                      const std::vector<IntermediateId>& watched) {
  MemoryNeed need;
  std::size_t largestHistory = 0, scratch = 0;
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    const Settings& settings = lanes[lane];
    const auto before = lanes.begin() + static_cast<std::ptrdiff_t>(lane);
    if (std::none_of(lanes.begin(), before,
                     [&](const Settings& other) { return sameInputs(other, settings); }))
      need.inputs += kFrames * inputBytes(settings.inputs, picturePx);
    scratch = std::max(scratch, scratchBytes(settings.inputs, picturePx));
    const std::size_t history = historyBytes(picturePx.x, picturePx.y, settings);
    largestHistory = std::max(largestHistory, history);
    need.histories += kHistoriesOfLane * history;
    need.exposures += kFrames * exposureBytes(watched, {0, 0, picturePx.x, picturePx.y});
  }
  need.inputs += scratch;
  need.histories += kFreeHistories * largestHistory;
  return need;
}

std::string bytesText(std::size_t bytes) {
  constexpr double kMebi = 1024.0 * 1024.0, kGibi = 1024.0 * kMebi;
  const auto value = static_cast<double>(bytes);
  std::ostringstream text;
  text << std::fixed;
  if (value >= kGibi)
    text << std::setprecision(1) << value / kGibi << " GiB";
  else
    text << std::setprecision(0) << value / kMebi << " MiB";
  return text.str();
}

std::string memoryRefusal(const MemoryNeed& need, const glm::ivec2& picturePx, std::size_t available) {
  if (need.total() <= available) return "";
  return "cannot use a picture of " + std::to_string(picturePx.x) + " × " + std::to_string(picturePx.y) +
         " pixels: it takes about " + bytesText(need.total()) + " of memory (inputs " +
         bytesText(need.inputs) + ", histories " + bytesText(need.histories) + ", exposures " +
         bytesText(need.exposures) + ") and " + bytesText(available) +
         " are free; choose a smaller size, fewer lanes or fewer views";
}

} // namespace taa
