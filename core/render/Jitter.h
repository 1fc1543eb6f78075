// The jitter pattern: a pure function of settings, frame index and the way the camera moves.
#pragma once

#include "core/render/JitterWay.h"
#include "core/settings/Settings.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace taa {

/// Radical inverse of `index` in `base`: exact digits, rounded once. 0 for index 0.
float radicalInverse(int index, int base);

/// Interleaved gradient noise along time, 0 to 1: manual J13, Jimenez 2014.
double gradientNoise(double x, double y, int index);

/// Frames until the pattern repeats: that of the points where the pattern has its own, else the setting.
int jitterPeriod(const JitterSettings& settings);

/// Position in the pattern at `frame`, 0 to period − 1.
int jitterIndex(const JitterSettings& settings, int frame);

/// Displacement of image content in px (x right, y down), scaled: manual §2.2, J0 to J16.
/// The manual's y is up; here y is down, and a pattern's second component is used as y down.
/// `way` matters for points across the camera's motion alone: jitterWay() of the frame.
glm::vec2 jitterPx(const JitterSettings& settings, int frame, const glm::dvec2& way = kFirstWay);

/// T(2jx/W, −2jy/H) · clipFromView: the same displacement at every depth, perspective and orthographic
/// (manual §2.1). Or what sources print instead of it.
glm::mat4 jittered(const glm::mat4& clipFromView, glm::vec2 jitterPx, glm::vec2 sizePx,
                   JitterProjection projection = JitterProjection::Translation);

/// What `jittered` adds to x and y in clip space: xy times w and zw times z, which each projection can be
/// written as. Expects nothing but x and y to differ.
glm::vec4 addedInClip(const glm::mat4& clipFromView, const glm::mat4& jittered);

} // namespace taa
