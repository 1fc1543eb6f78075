#include "core/inspect/MemoryNeed.h"

#include "core/base/Error.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/inspect/FrameWindow.h"
#include "core/measure/References.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/settings/Parameters.h"
#include "core/taa/TaaPass.h"

#include <algorithm>
#include <optional>
#include <string>

namespace taa {

namespace {

constexpr std::size_t kFramesInUse = 2;     // on show, and being made
constexpr std::size_t kHistoriesOfLane = 3; // resolved from, shown, resolved into
constexpr std::size_t kFreeHistories = 4;   // at most, that the pool holds for later

// See ReferenceRows::texture().
std::size_t rowBytes(const Intermediate& row, const glm::ivec2& picturePx) {
  return gl::textureBytes({picturePx.x, picturePx.y},
                          row.channels == 3 ? gl::Format::RGBA32F : gl::Format::R32F);
}

std::string sizeText(const glm::ivec2& picturePx) {
  return std::to_string(picturePx.x) + " × " + std::to_string(picturePx.y);
}

} // namespace

std::size_t referenceBytes(const Settings& settings, const glm::ivec2& picturePx, const Scene* scene) {
  FrameRequest request;
  request.inputs = settings.inputs;
  const InputSettings drawn = referenceRequest(request).inputs;
  return inputBytes(drawn, picturePx, scene) + scratchBytes(drawn, picturePx, scene);
}

MemoryNeed memoryNeed(const std::vector<Settings>& lanes, const glm::ivec2& picturePx,
                      const std::vector<IntermediateId>& watched, const Scene* scene) {
  MemoryNeed need;
  std::size_t largestHistory = 0, scratch = 0, drawn = 0;
  bool drawsReference = false;
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    const Settings& settings = lanes[lane];
    const auto before = lanes.begin() + static_cast<std::ptrdiff_t>(lane);
    if (std::none_of(lanes.begin(), before,
                     [&](const Settings& other) { return sameInputs(other, settings); }))
      need.inputs += kFramesInUse * inputBytes(settings.inputs, picturePx, scene);
    scratch = std::max(scratch, scratchBytes(settings.inputs, picturePx, scene));
    const std::size_t history = historyBytes(picturePx.x, picturePx.y, settings);
    largestHistory = std::max(largestHistory, history);
    need.histories += kHistoriesOfLane * history;
    need.intermediates += kFramesInUse * exposedBytes(ExposedLayout(watched, rowSources(settings)),
                                                      {0, 0, picturePx.x, picturePx.y});
  }
  for (const IntermediateId id : watched) {
    if (!isOfReference(id)) continue;
    need.reference += lanes.size() * rowBytes(intermediate(id), picturePx);
    drawsReference |= !isOfEngine(id);
  }
  need.reference += lanes.size() * windowBytes(picturePx, kFlickerFrames, kindsOverTime(watched));
  for (std::size_t lane = 0; drawsReference && lane < lanes.size(); ++lane) // one after the other
    drawn = std::max(drawn, referenceBytes(lanes[lane], picturePx, scene));
  need.reference += drawn;
  need.inputs += scratch;
  need.histories += kFreeHistories * largestHistory;
  return need;
}

std::string bytesText(std::size_t bytes) {
  constexpr double kMebi = 1024.0 * 1024.0, kGibi = 1024.0 * kMebi;
  const auto value = static_cast<double>(bytes);
  return value >= kGibi ? fixedText(value / kGibi, 1) + " GiB" : fixedText(value / kMebi, 0) + " MiB";
}

std::string memoryRefusal(const MemoryNeed& need, const glm::ivec2& picturePx, std::size_t available) {
  if (need.total() <= available) return "";
  const std::string size = sizeText(picturePx), total = bytesText(need.total()), left = bytesText(available);
  const std::string inputs = bytesText(need.inputs), histories = bytesText(need.histories);
  const std::string intermediates = bytesText(need.intermediates);
  if (need.reference > 0)
    return say<
        "cannot use a picture of %1 pixels: it takes about %2 of memory (inputs %3, histories %4, "
        "intermediates %5, reference %6) and %7 are free; choose a smaller size, fewer lanes or fewer views">(
        size, total, inputs, histories, intermediates, bytesText(need.reference), left);
  return say<"cannot use a picture of %1 pixels: it takes about %2 of memory (inputs %3, histories %4, "
             "intermediates %5) and %6 are free; choose a smaller size, fewer lanes or fewer views">(
      size, total, inputs, histories, intermediates, left);
}

std::string referenceRefusal(std::size_t bytes, const glm::ivec2& picturePx, std::size_t available) {
  if (bytes <= available) return "";
  return say<
      "cannot draw the reference of a picture of %1 pixels: it takes about %2 of memory and %3 are free; "
      "choose a smaller size">(sizeText(picturePx), bytesText(bytes), bytesText(available));
}

void requirePicture(const gl::Driver& driver, const std::vector<Settings>& lanes, const glm::ivec2& picturePx,
                    const std::vector<IntermediateId>& watched, const Scene* scene) {
  const int most = driver.maxTextureSize;
  if (picturePx.x < 4 || picturePx.y < 4 || picturePx.x > most || picturePx.y > most)
    throw Error(say<"cannot use a picture of %1 × %2 pixels: this driver allows 4 to %3 a side">(
        picturePx.x, picturePx.y, most));
  // Asked before anything is allocated: a software driver does not run out of memory, its process is killed.
  const std::optional<std::size_t> available = gl::availableMemory(driver);
  if (!available) return;
  const std::string refusal =
      memoryRefusal(memoryNeed(lanes, picturePx, watched, scene), picturePx, *available);
  if (!refusal.empty()) throw Error(refusal);
}

void requireReference(const gl::Driver& driver, std::size_t bytes, const glm::ivec2& picturePx) {
  const std::optional<std::size_t> available = gl::availableMemory(driver);
  if (!available) return;
  const std::string refusal = referenceRefusal(bytes, picturePx, *available);
  if (!refusal.empty()) throw Error(refusal);
}

} // namespace taa
