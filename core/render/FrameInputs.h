// What the resolve is given for one frame, wherever it comes from: the built-in renderer or somebody's
// engine.
#pragma once

#include "core/gl/Texture.h"
#include "core/settings/Settings.h"
#include "shaders/shared/FrameBlock.h"

#include <glm/vec2.hpp>

#include <cstddef>

namespace taa {

struct FrameRequest;
struct Scene;

/// Motion of a point that has no previous position (behind the previous camera): both components, px.
/// The largest half float, so that it survives 16-bit storage.
inline constexpr float kNoPreviousPosition = 65504.0f;

/// In FrameInputs::forwardCount where nothing says where the last frame's pixels are now.
inline constexpr float kForwardUnknown = -1.0f;

/// Where in time and in the jitter pattern a frame lies.
struct FrameInfo {
  int frame = 0;
  double time = 0.0;               ///< seconds
  int jitterIndex = 0;             ///< 0 to period − 1
  glm::vec2 jitterPx{0.0f};        ///< displacement of image content, x right, y down, |j| ≤ ½
  bool startsHistory = false;      ///< first frame, cut or restart: no history may be used
  double stepSeconds = 1.0 / 60.0; ///< from frame to frame
  glm::dvec2 jitterWay{1.0, 0.0};  ///< jitterWay() of the frame where the jitter lies across it
};

/// All textures have the same size, row 0 at the top; pixels are theirs, not those of the picture.
struct FrameInputs {
  FrameInfo info;
  shared::FrameBlock block{};
  gl::Texture color;    ///< RGBA16F or RGBA32F, scene-linear Rec. 709
  gl::Texture depth;    ///< Depth32F, reversed, 0 = sky
  gl::Texture motion;   ///< RG16F or RG32F, px, current − previous, jitter removed; see kNoPreviousPosition
  gl::Texture normal;   ///< RGBA16F, world space, 0 for the sky; alpha: number of the ObjectClass
  gl::Texture objectId; ///< R32UI, 0 = sky
  gl::Texture previousDepth; ///< R32F, view depth the surface had in the previous frame, m; 0 = sky or none
  // None where the settings ask for none.
  gl::Texture mask;         ///< RG8: reactive (what was blended in), responsive (what changes without motion)
  gl::Texture overlay;      ///< RGBA16F, premultiplied, not jittered: what is laid over the output
  gl::Texture forwardCount; ///< R32F: pixels of the last frame whose surface lies here now; −1: not known
  // None where the scene has none.
  gl::Texture fog; ///< as color: light that fog scatters to the camera; alpha: what it takes of the surface's
  glm::ivec2 outputPx{0}; ///< size of the picture that is made of them; 0: their own
  int width() const { return color.width(); }
  int height() const { return color.height(); }
  int outputWidth() const { return outputPx.x > 0 ? outputPx.x : width(); }
  int outputHeight() const { return outputPx.y > 0 ? outputPx.y : height(); }
};

/// ⌈r·W⌉ × ⌈r·H⌉ of a picture of W × H: the size of what is drawn at inputs.renderScale r, px.
glm::ivec2 drawnSize(const glm::ivec2& picturePx, float renderScale);

/// Makes the textures that are drawn for a request, with undefined contents; keeps those that fit.
void fitInputs(const FrameRequest& request, FrameInputs& out);
/// As above, for inputs of a size that no setting says.
void fitInputs(const InputSettings& settings, const glm::ivec2& drawnPx, const glm::ivec2& picturePx,
               FrameInputs& out);
/// Makes a texture anew unless it has this size and format; its contents are undefined then.
void fitTexture(gl::Texture& texture, const glm::ivec2& sizePx, gl::Format format, const char* label);
/// What the textures of a frame's inputs take for a picture, bytes. Without a scene: of one without fog.
std::size_t inputBytes(const InputSettings& settings, const glm::ivec2& picturePx,
                       const Scene* scene = nullptr);
/// The format of what is drawn.
gl::Format colorFormat(const InputSettings& settings);

} // namespace taa
