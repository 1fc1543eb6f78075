// What a surface's last moments say by themselves. No GL.
#pragma once

#include "core/taa/rows/Intermediates.h"
#include "core/verdict/pixel/Evidence.h"

#include <glm/vec3.hpp>

#include <vector>

namespace taa {

double largestMagnitude(const glm::dvec3& value);

/// First channel of a row.
double recordValue(const twin::PixelRecord& record, IntermediateId id);

/// The upper quartile of how much more each moment stands out from those beside it than truth does there, as
/// shown, 0 to 1, or where there are few of them what no single one makes: what comes and goes with the
/// jitter, not what comes once and fades, nor what a moving edge or texture does.
double flickerOf(const std::vector<SurfaceMoment>& moments);

/// Whether white is exceeded anywhere, by truth, by single samples or by those around that the filter takes
/// in.
bool isHighlight(const std::vector<SurfaceMoment>& moments);

/// Whether what lay at the surface's place a frame ago hid it: of the depths there, the best match was
/// nearer.
bool wasBehind(const twin::PixelRecord& record);

} // namespace taa
