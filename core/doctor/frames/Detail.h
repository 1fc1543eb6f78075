// Where a picture has detail that a place can be told by.
#pragma once

#include "core/base/Image.h"
#include "core/doctor/frames/Regions.h"

#include <vector>

namespace taa::doctor {

/// Whether a pixel's luma stands out from the mean of the 5×5 pixels around it: shading alone does not, and
/// it need not move with its surface.
bool hasDetail(const Image& luma, int x, int y);
/// The same from the mean of those pixels alone that have its label: the silhouette of a plain surface is no
/// detail of it. `labels`: of all pixels, row by row.
bool hasDetail(const Image& luma, const std::vector<RegionIndex>& labels, int x, int y);
/// The same of a pixel of the sky around which all is sky: silhouettes of what is before it are no detail of
/// it, and beside them a mean of one side alone makes a gradient look like some.
bool skyHasDetail(const DoctorFrame& frame, int x, int y);

} // namespace taa::doctor
