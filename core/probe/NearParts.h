// Parts of a picture that are drawn: some small ones cost less than one around all of them, others more.
#pragma once

#include "core/gl/Rect.h"

#include <vector>

namespace taa {

/// Whether it costs less to draw two parts as one.
bool areNear(const gl::Rect& a, const gl::Rect& b);

/// Rectangles that hold all of the parts, with those put together that are near; no two of them are.
std::vector<gl::Rect> nearParts(const std::vector<gl::Rect>& parts);

} // namespace taa
