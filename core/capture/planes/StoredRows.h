// Rows of pixels as a picture file stores them, each channel in its own format, and the rows of planes that
// they are.
#pragma once

#include "core/capture/planes/Planes.h"

#include <OpenImageIO/typedesc.h>

#include <cstddef>
#include <vector>

namespace taa::capture {

/// Where a channel stands in the bytes of a pixel, and what it is.
struct StoredChannel {
  std::size_t offset = 0;
  OIIO::TypeDesc::BASETYPE type = OIIO::TypeDesc::FLOAT;
};

/// Row `row` of `plane` from the pixels at `at`, `pixelBytes` apart. Expects a channel for each of the
/// plane's, of 8, 16 or 32-bit integers or 16, 32 or 64-bit floats.
void unpackRow(PlaneData& plane, int row, const std::byte* at, std::size_t pixelBytes,
               const std::vector<StoredChannel>& channels);

} // namespace taa::capture
