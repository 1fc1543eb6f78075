// Traces of probes as text, the same in the window and in taa-batch.
#pragma once

#include "core/probe/PixelTrace.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace taa {

/// "probe,frame,x,y,alpha,resolved.R,…", then a line for each known frame of each probe; probes count from 1.
/// Numbers are the shortest that read back as the same float. Nothing stands where there is no
/// value. `space`: of the settings that made them.
std::string traceCsv(const std::vector<ProbeTrace>& traces, const std::vector<IntermediateId>& rows,
                     const SpaceSettings& space);

/// [{"probe": 1, "pixel": [x, y], "follow": "screen", "frames": [{"frame": n, "pixel": [x, y], "values":
/// {"alpha": …}}]}]; null where there is no value
nlohmann::ordered_json traceJson(const std::vector<ProbeTrace>& traces,
                                 const std::vector<IntermediateId>& rows, const SpaceSettings& space);

} // namespace taa
