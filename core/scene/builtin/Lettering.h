// Letters painted into the pictures of the built-in scenes.
#pragma once

#include "core/scene/Scene.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace taa {

/// An RGBA picture of one color.
SceneImage plainImage(std::string name, int width, int height, const std::array<std::uint8_t, 3>& color);

/// Pixels from the start of one letter to the start of the next at scale 1; letters are 5 × 7.
inline constexpr int kLetterStep = 6;

/// The color of tickers.
inline constexpr std::array<std::uint8_t, 3> kAmber{255, 176, 40};

/// Paints capitals, digits, point, comma and dash with their top left at (x, y), each dot `scale` pixels
/// wide; what lies outside the picture is dropped, other characters are blank.
void paintText(SceneImage& image, int x, int y, int scale, std::string_view text,
               const std::array<std::uint8_t, 3>& color);

} // namespace taa
