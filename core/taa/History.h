// What one frame leaves for the next, and which of it a lane's settings need.
#pragma once

#include "core/gl/Texture.h"
#include "core/settings/Settings.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace taa {

/// Written once, then only read. What only some settings need is empty without them; see historyLayers().
struct History {
  gl::Texture color;   ///< RGBA16F or RGBA32F by history.precision: the resolved color, alpha 1
  gl::Texture surface; ///< RG32F: history length N, view depth of the dilated sample (m, 0 = sky)
  gl::Texture object;  ///< RG32F, of the dilated sample: number of the object, its class
  gl::Texture normal;  ///< RGBA16F, of the dilated sample, world space; 0 for the sky
  gl::Texture motion;  ///< RG32F, of the dilated sample, px
  gl::Texture lock;    ///< RG32F: life of the pixel's lock, 0 to 2; luma it was locked at
  gl::Texture lumas;   ///< RGBA8: luma of this frame and the three before, as L/(1 + L) in 255 steps
  gl::Texture stale;   ///< as color, of the frame before: with fault.notSwapped, what is read in its place
  /// What the next frame reads as color.
  const gl::Texture& readColor() const { return stale ? stale : color; }
  std::size_t bytes() const;
};

/// A texture of the history that only some settings need. The resolve writes `keep_<name>(value)`, which is
/// nothing where it is not kept, and reads it from unit kFirstLayerUnit + its place in the table.
struct HistoryLayer {
  std::string_view name;
  std::string_view type; ///< GLSL's
  gl::Format format;
  gl::Texture History::*texture;
  bool (*isNeeded)(const Settings&);
};
std::span<const HistoryLayer> historyLayers();
/// What fitHistory() allocates, bytes.
std::size_t historyBytes(int width, int height, const Settings& settings);
inline constexpr unsigned kFirstLayerUnit = 8;

/// Color targets of the resolve that are the history's.
std::size_t historyTargets(const Settings& settings);

/// GLSL text: an output and `keep_<name>(value)` for each layer that is kept, an empty macro for the others,
/// and `const int kLayer_<name>`, the layer's bit in the resolve block's state. The outputs o_color and
/// o_surface as well, which are mere variables of a run that keeps no history.
std::string historyPrelude(const Settings& settings, bool keepsHistory = true);

/// Makes the textures of `history` fit size and settings; keeps those that do, frees those not needed.
void fitHistory(History& history, int width, int height, const Settings& settings);

} // namespace taa
