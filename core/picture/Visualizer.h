// From an intermediate to a picture for a screen: channels, range, exposure, color map, zoom and pan,
// overlays.
#pragma once

#include "core/gl/Texture.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

enum class ColorMap : std::uint8_t { Gray, Viridis, Inferno, Diverging, Cyclic, Categorical };

inline constexpr ColorMap kColorMaps[] = {ColorMap::Gray,      ColorMap::Viridis, ColorMap::Inferno,
                                          ColorMap::Diverging, ColorMap::Cyclic,  ColorMap::Categorical};

/// How an intermediate is shown; each intermediate remembers its own.
struct ViewStyle {
  float low = 0.0f, high = 1.0f; ///< values drawn as the ends of the range
  float exposure = 0.0f;         ///< stops, before the range
  bool red = true, green = true, blue = true;
  ColorMap map = ColorMap::Gray; ///< for one-channel rows and for a single channel shown alone
  bool markInvalid = true;     ///< NaN red, Inf green, negative blue (negative only where the row is a color)
  bool markClipped = false;    ///< hatches what lies above and below the range
  bool markRejected = false;   ///< tints every pixel by its reject reason
  bool outlineObjects = false; ///< lines between pixels of different objects
  bool arrows = false;         ///< vectors: an arrow in each cell of a grid
  bool operator==(const ViewStyle&) const = default;
};

/// The style a row opens with.
ViewStyle defaultStyle(const Intermediate& row);
/// The style a difference of this row opens with: both ways, a quarter of the row's own range.
ViewStyle differenceStyle(const Intermediate& row);
std::string_view colorMapName(ColorMap map);

/// From this zoom on each screen pixel shows one picture pixel at any zoom; below it, where a picture pixel
/// is not a whole number of screen pixels, a screen pixel shows the mean of what lies under it, so that
/// picture pixels look equally large.
inline constexpr float kSharpZoom = 8.0f;

/// Which part of the picture is shown where. Screen pixel s shows picture position origin + s / zoom.
struct ViewTransform {
  glm::vec2 origin{0.0f}; ///< picture position (px) at the top-left corner of the viewport
  float zoom = 1.0f;      ///< screen pixels per picture pixel
  float scale = 1.0f;     ///< screen pixels a unit of what is laid over the picture: hatches, lines, arrows
  bool operator==(const ViewTransform&) const = default;
};

/// A finished picture for the screen, sRGB, row 0 the top; alpha is the share of a pixel that the image
/// covers, not multiplied in: 0 outside.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Colors of the hatches over what is clipped, linear: rising lines above the range, falling ones below it.
inline constexpr std::array<float, 3> kAboveColor{0.66539f, 0.11193f, 0.0f};     // sRGB 213, 94, 0
inline constexpr std::array<float, 3> kBelowColor{0.09306f, 0.45641f, 0.81485f}; // sRGB 86, 180, 233
/// Light of the two grays of the checkers over what has no value, linear; units of a side of one.
inline constexpr std::array<float, 2> kNothingLight{0.01f, 0.06f};
inline constexpr float kNothingSide = 4.0f;
/// Units (ViewTransform::scale) from one arrow to the next, at least; and of a cell's arrow, at most.
inline constexpr float kArrowSpacing = 24.0f, kLongestArrow = 48.0f;

/// What the arrows over vectors mean.
struct ArrowScale {
  float longest = 0.0f;  ///< units of an arrow at the end of the range, or beyond it
  float minShare = 0.0f; ///< of the range; what is less is a dot
};
ArrowScale arrowScale(const ViewTransform& transform);

/// How much of a tint is its reason's color, the rest is the picture.
inline constexpr float kTintShare = 0.6f;

/// Where a row's values are: a layer of an array, or a plain texture, from one of its channels on.
struct Layer {
  const gl::Texture* texture = nullptr; ///< null: none
  int layer = 0, firstChannel = 0;
  bool isPartial = false; ///< its fourth channel is not 0 where there is no value
};

/// Rows of one picture that are drawn together.
struct DrawnLayers {
  Layer row;
  Layer minus{};                    ///< of as many channels: their difference is drawn, row minus this
  Layer rejectReason{}, objectId{}; ///< for the overlays that show them
};

/// Nearest neighbor above 1:1, exact area average below it (of the displayed colors' linear values).
class Visualizer {
 public:
  Visualizer();
  ~Visualizer();
  Visualizer(Visualizer&&) noexcept;
  Visualizer& operator=(Visualizer&&) noexcept;

  /// Draws `layer` of `texture` (0 where it is no array), from its `firstChannel` on, as row `row` into a
  /// viewport of the given size (px).
  Picture draw(const gl::Texture& texture, int layer, int firstChannel, const Intermediate& row,
               const ViewStyle& style, const ViewTransform& transform, int width, int height);
  /// The same with what is laid over or subtracted. Of a difference the shown channel that differs most is
  /// drawn, with its sign, in the style's map; vectors of which one has no previous position have none.
  Picture draw(const DrawnLayers& layers, const Intermediate& row, const ViewStyle& style,
               const ViewTransform& transform, int width, int height);
  /// One with the same programs, compiled again; throws Error when one does not compile.
  Visualizer reloaded() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Color of `value` (0…1) in a map, linear 0…1 RGB; from the same table as the shader's (ColorMap.h).
std::array<float, 3> mapColor(ColorMap map, float value);

} // namespace taa
