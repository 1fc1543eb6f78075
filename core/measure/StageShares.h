// What stages did to a frame, in one metric each: the share of pixels that they changed.
#pragma once

#include "core/base/Image.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <vector>

namespace taa {

/// How a stage's share is to be read.
struct StageShare {
  Stage stage{};
  double share = 0.0; ///< 0 to 1: another motion taken, off the screen, pulled, rejected, changed for showing
};

/// Of the stages of which "changed nothing" can be said.
struct StageShares {
  int frame = 0;
  bool startsHistory = false; ///< there is no history to change
  std::vector<StageShare> stages;
};

/// The rows that sharesOf() wants, in its order.
const std::vector<IntermediateId>& shareRows();
/// From pictures of shareRows(), made with `settings`.
std::vector<StageShare> sharesOf(const std::vector<Image>& rows, const Settings& settings);

} // namespace taa
