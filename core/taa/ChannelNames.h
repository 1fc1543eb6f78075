// Names of the channels of a row: what a box is made of depends on the settings.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <string>
#include <vector>

namespace taa {

/// In files, probes, legends and plots: "R G B", "X Y", of box space what its axes are called: "Y Co Cg" …;
/// as many as the row has.
std::vector<std::string> channelNames(const Intermediate& row, const SpaceSettings& space);

/// Of a row as such, whatever the settings: "X, Y"; of box space all that there are: "R, G, B or Y, Co, Cg or
/// …".
std::string channelNamesText(const Intermediate& row);

} // namespace taa
