// The color maps as one table, from which both the shader and mapColor read.
#pragma once

#include "core/base/Image.h"
#include "core/picture/Visualizer.h"

#include <glm/vec2.hpp>

#include <array>

namespace taa {

inline constexpr int kColorMapCount = 6;
/// Entries of a map, evenly spaced over 0…1; odd, so that the middle of a diverging map is an entry.
inline constexpr int kColorMapEntries = 257;
/// Colors of ColorMap::Categorical, in the first entries of its row: the first for number 0, the others
/// repeat.
inline constexpr int kCategoryCount = 10;

/// OKLab lightness of every color of ColorMap::Cyclic.
inline constexpr float kCyclicLightness = 0.72f;

/// RGBA, linear Rec. 709, one row a map in the order of ColorMap. Values between two entries are
/// a + f·(b − a); categories are not interpolated.
const Image& colorMapTable();

/// The color of a vector, linear: its direction as hue of ColorMap::Cyclic, and `saturation`, 0 to 1, from
/// gray as light as that to the hue. As shaders/inspect/visual_color.glsl.
std::array<float, 3> vectorColor(const glm::vec2& direction, float saturation);

/// The color of integer `number` in the categorical palette, linear: 0 has one of its own.
std::array<float, 3> categoryColor(int number);

} // namespace taa
