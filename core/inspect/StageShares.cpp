#include "core/inspect/StageShares.h"

#include "core/inspect/ChangedShare.h"

#include <array>
#include <cassert>
#include <cstddef>

namespace taa {

namespace {

/// A row, and the value that says that its stage left a pixel as it was.
struct Row {
  IntermediateId id;
  float untouched;
};

constexpr std::array kRows{Row{IntermediateId::dilatedOffset, 0.0f}, Row{IntermediateId::onScreen, 1.0f},
                           Row{IntermediateId::clipAmount, 0.0f},    Row{IntermediateId::rejectReason, 0.0f},
                           Row{IntermediateId::sharpenDetail, 0.0f}, Row{IntermediateId::blurTrust, 1.0f},
                           Row{IntermediateId::overlayAlpha, 0.0f}};

/// The overlay is an input, but it is Output that lays it over the picture.
Stage stageOf(const Row& row) {
  return row.id == IntermediateId::overlayAlpha ? Stage::Output : intermediate(row.id).stage;
}

} // namespace

const std::vector<IntermediateId>& shareRows() {
  static const std::vector<IntermediateId> ids = [] {
    std::vector<IntermediateId> list;
    for (const Row& row : kRows) list.push_back(row.id);
    return list;
  }();
  return ids;
}

std::vector<StageShare> sharesOf(const std::vector<Image>& rows) {
  assert(rows.size() == kRows.size());
  std::vector<StageShare> shares;
  std::vector<ChangedRow> ofStage;
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const Stage stage = stageOf(kRows[index]);
    if (shares.empty() || shares.back().stage != stage) {
      shares.push_back({stage, 0.0});
      ofStage.clear();
    }
    ofStage.push_back({rows[index], kRows[index].untouched});
    shares.back().share = shareOfChanged(ofStage);
  }
  return shares;
}

} // namespace taa
