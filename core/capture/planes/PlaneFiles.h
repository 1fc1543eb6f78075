// One file of a frame: a raw plane, or a picture that holds one plane or several.
#pragma once

#include "core/capture/planes/Planes.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace taa::capture {

/// A plane to read, and where it lies.
struct PlaneRequest {
  PlaneKind kind = PlaneKind::Color;
  const PlaneSource* source = nullptr;
  std::string file;         ///< below the folder, filled in for the frame
  bool bottomFirst = false; ///< order of rows in the file
};

/// Throws Error unless a file of `size` can hold a plane of this capture: color is of the render size, output
/// of the output size, nothing is larger than both; where the plane is a part of it, that lies inside.
void requireSize(const Manifest& manifest, const PlaneRequest& request, glm::ivec2 size);
/// A plane of zeros. Throws Error where there is no memory for it.
PlaneData makePlane(PlaneKind kind, glm::ivec2 size, int channels);

/// The whole file. Throws Error.
PlaneData readRawPlane(const std::filesystem::path& folder, const Manifest& manifest,
                       const PlaneRequest& request);
/// Planes of one file, each kind once, in the order of `requests`; the whole of it. Throws Error.
std::vector<PlaneData> readPicture(const std::filesystem::path& folder, const Manifest& manifest,
                                   const std::vector<PlaneRequest>& requests);

/// An id that a picture or plane stores as a float. Throws Error where it is not a whole number of 32 bits.
std::uint32_t idOf(float stored);

} // namespace taa::capture
