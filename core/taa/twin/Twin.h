// The resolve of one pixel on the CPU, written from the formulas of the manual, for tests and "what if"
// questions.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"
#include "core/taa/twin/Numbers.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace taa::twin {

/// Downloaded inputs of one frame, row 0 at the top. Channels and units as in FrameInputs and History: what
/// is drawn has one size, the picture and its history another where settings draw less.
struct Inputs {
  Texels color;          ///< 4 channels
  Texels depth;          ///< 1
  Texels motion;         ///< 2
  Texels normal;         ///< 4
  Texels objectId;       ///< 1
  Texels previousDepth;  ///< 1
  Texels mask;           ///< 2: reactive, responsive; empty: none
  Texels overlay;        ///< 4, premultiplied; empty: none
  Texels fog;            ///< 4: scattered light, opacity; empty: none
  Texels forwardCount;   ///< 1: pixels of the last frame that land there; empty: not counted
  Texels historyColor;   ///< 4; empty: no history
  Texels historySurface; ///< 2: N, view depth
  Texels resolved;       ///< 3 or more: what all pixels resolved to; empty: nothing is known of stage Output
  // What only some settings keep; empty: not kept.
  Texels historyObject;            ///< 2: number, class
  Texels historyNormal;            ///< 4
  Texels historyMotion;            ///< 2
  Texels historyLock;              ///< 2: life, luma
  Texels historyLumas;             ///< 4: latest first, as L/(1 + L)
  int frame = 0;                   ///< its number
  double stepSeconds = 1.0 / 60.0; ///< from frame to frame
  glm::vec2 jitterPx{0.0f};
  glm::vec2 lastJitterPx{0.0f}; ///< of the frame before
  glm::vec4 depthTerms{0.0f};   ///< (P33, P32, P23, P22)
  glm::ivec2 outputPx{0};       ///< size of the picture; 0: that of the inputs
  int width() const { return color.width; }
  int height() const { return color.height; }
  int outputWidth() const { return outputPx.x > 0 ? outputPx.x : width(); }
  int outputHeight() const { return outputPx.y > 0 ? outputPx.y : height(); }
};

/// Every intermediate of one pixel; missing channels are 0, rows without a value NaN (isKnown() of Known.h).
template <typename Real>
using PixelRecordOf = std::array<Vec4<Real>, kIntermediateCount>;
using PixelRecord = PixelRecordOf<float>;

template <typename Real = float>
Vec4<Real>& at(PixelRecordOf<Real>& record, IntermediateId id) {
  return record[static_cast<std::size_t>(id)];
}
template <typename Real = float>
const Vec4<Real>& at(const PixelRecordOf<Real>& record, IntermediateId id) {
  return record[static_cast<std::size_t>(id)];
}

// Of a row that is made: what the stages go on with is its value, or, of an Interval, what a driver made of
// it.
template <typename Real>
void observe(IntermediateId, Real&, int = 0) {}
template <glm::length_t n, typename Real>
void observe(IntermediateId id, glm::vec<n, Real>& value) {
  for (glm::length_t i = 0; i < n; ++i) observe(id, value[i], i);
}

/// What was compared since the row that was decided last has decided this one: numbers that remember how they
/// were made write it down. `isAll`: it decides no other row besides.
template <typename Real>
void decided(IntermediateId, bool isAll = true) {
  static_cast<void>(isAll);
}

/// What was compared since then only found the best of some candidates: it decides no row.
template <typename Real>
void searched() {}

/// What the pixel leaves in the layers that only some settings keep; see History.
struct KeptLayers {
  glm::vec2 object{0.0f};
  glm::vec4 normal{0.0f};
  glm::vec2 motion{0.0f};
  glm::vec2 lock{0.0f};
  glm::vec4 lumas{0.0f};
};

/// All intermediates of pixel (x, y) of the picture, in 32-bit floats rounded after every operation. Those of
/// stage Output are 0 without `inputs.resolved`. Fills `kept` when given.
PixelRecord resolvePixel(const Inputs& inputs, const Settings& settings, int x, int y,
                         KeptLayers* kept = nullptr);

/// What no intermediate holds but formulas are made of.
struct Details;
/// As resolvePixel, and fills `details`.
PixelRecord resolvePixel(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                         Details& details);

/// A pixel in other numbers.
template <Remembering Real>
struct PixelIn {
  PixelRecordOf<Real> record{};
  Vec3<Real> rectifiedBox{0.0f}; ///< where all of the correction moves history, box space; 0: nowhere
};
template <Remembering Real>
PixelIn<Real> resolvePixelIn(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel);

} // namespace taa::twin
