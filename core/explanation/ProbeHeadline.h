// What happened at a pixel in a few lines, and single values in a few words: made from the values, so that
// nothing is said that they do not say.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"

#include <cstdint>
#include <string>
#include <vector>

namespace taa {

/// What speaks for history being of something else although it was not rejected.
enum class HistoryDoubt : std::uint8_t {
  None,
  OffScreen,    ///< it was read beyond the picture
  OtherColor,   ///< nothing was pulled, and its color is none of those around
  OtherSurface, ///< its depth is another than the surface had
  Ghost,        ///< both: another surface, in a color that is not around
};
HistoryDoubt historyDoubt(const twin::PixelRecord& record, const Settings& settings);

/// Whose motion and what became of history; how α came about; how many samples that holds; what is shown
/// instead of the resolved color, where something is; which faults are injected, where some are.
std::vector<std::string> probeHeadline(const twin::PixelRecord& record, const Settings& settings,
                                       const FrameInfo& info);

/// A row's value in a few words ("kept", "sky", "31 % current"); empty where it has none.
std::string meaningOf(IntermediateId id, const twin::PixelRecord& record, const Settings& settings);

} // namespace taa
