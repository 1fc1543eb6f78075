#include "core/measure/StageShares.h"

#include "core/measure/ChangedShare.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cassert>
#include <cstddef>

namespace taa {

namespace {

/// A row, and the value that says that its stage left a pixel as it was.
struct ShareRow {
  IntermediateId id;
  float untouched;
};

constexpr std::array kStageRows{
    ShareRow{IntermediateId::onScreen, 1.0f},     ShareRow{IntermediateId::clipAmount, 0.0f},
    ShareRow{IntermediateId::rejectReason, 0.0f}, ShareRow{IntermediateId::sharpenDetail, 0.0f},
    ShareRow{IntermediateId::blurTrust, 1.0f},    ShareRow{IntermediateId::overlayAlpha, 0.0f}};

/// On a surface that leans all pixels follow a neighbor, with the same motion: only another one is a change.
constexpr std::array kMotions{IntermediateId::motion, IntermediateId::dilatedMotion};

/// Share of pixels whose motion another takes the place of: by more than a tenth of a pixel and a hundredth
/// of it. `motion` in render px, `dilated` in those of the picture.
double shareOfOtherMotion(const Image& motion, const Image& dilated, float renderScale) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < motion.pixels.size(); at += 2) {
    const glm::vec2 own(motion.pixels[at] / renderScale, motion.pixels[at + 1] / renderScale);
    const glm::vec2 used(dilated.pixels[at], dilated.pixels[at + 1]);
    if (!(glm::distance(own, used) <= 0.1f + 0.01f * glm::length(used))) ++count; // NaN is another
  }
  return 2.0 * static_cast<double>(count) / static_cast<double>(motion.pixels.size());
}

/// The overlay is an input, but it is Output that lays it over the picture.
Stage stageOf(const ShareRow& row) {
  return row.id == IntermediateId::overlayAlpha ? Stage::Output : intermediate(row.id).stage;
}

} // namespace

const std::vector<IntermediateId>& shareRows() {
  static const std::vector<IntermediateId> ids = [] {
    std::vector<IntermediateId> list(kMotions.begin(), kMotions.end());
    for (const ShareRow& row : kStageRows) list.push_back(row.id);
    return list;
  }();
  return ids;
}

std::vector<StageShare> sharesOf(const std::vector<Image>& rows, const Settings& settings) {
  assert(rows.size() == kMotions.size() + kStageRows.size());
  std::vector<StageShare> shares{
      {Stage::DilateMotion, shareOfOtherMotion(rows[0], rows[1], settings.inputs.renderScale)}};
  std::vector<ChangedRow> ofStage;
  for (std::size_t index = 0; index < kStageRows.size(); ++index) {
    const Stage stage = stageOf(kStageRows[index]);
    if (shares.empty() || shares.back().stage != stage) {
      shares.push_back({stage, 0.0});
      ofStage.clear();
    }
    ofStage.push_back({rows[kMotions.size() + index], kStageRows[index].untouched});
    shares.back().share = shareOfChanged(ofStage);
  }
  return shares;
}

} // namespace taa
