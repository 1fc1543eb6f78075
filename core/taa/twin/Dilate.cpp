// Stage 1, dilate motion: whose motion a pixel follows, so that silhouettes move with what is in front.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"
#include "core/taa/twin/Upsample.h"

#include <array>
#include <vector>

namespace taa::twin {

template <typename Real>
Real viewDepth(Real depth, const glm::vec4& depthTerms) {
  const auto& [p33, p32, p23, p22] = std::array{depthTerms.x, depthTerms.y, depthTerms.z, depthTerms.w};
  return depth == 0.0f ? 0.0f : (depth * p33 - p32) / (depth * p23 - p22);
}

namespace {

/// Steps to the neighbors that are asked, in the order in which a tie is decided: row by row, and in Raptor's
/// loop column by column.
std::vector<glm::ivec2> candidates(DilateMethod method) {
  switch (method) {
  case DilateMethod::None: // these two do not ask for any
  case DilateMethod::ClosestXAsPrinted:
    return {};
  case DilateMethod::Closest3x3AsPrinted:
    return {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 0}, {0, 1}, {1, -1}, {1, 0}, {1, 1}};
  case DilateMethod::ClosestCross:
  case DilateMethod::LongestCross:
    return {{0, -1}, {-1, 0}, {0, 0}, {1, 0}, {0, 1}};
  case DilateMethod::ClosestX:
    return {{-1, -1}, {1, -1}, {0, 0}, {-1, 1}, {1, 1}};
  case DilateMethod::ClosestX2:
    return {{-2, -2}, {2, -2}, {0, 0}, {-2, 2}, {2, 2}};
  case DilateMethod::Closest3x3:
  case DilateMethod::Longest3x3:
  case DilateMethod::Farthest3x3:
    return {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};
  }
  return {};
}

/// The nearest of them, 4.1 to 4.4, or the farthest. Reversed depth: larger is nearer. Starts from what
/// `result` holds, or from the first of them.
template <typename Real>
void findClosest(const Inputs& inputs, const DilateSettings& settings, const glm::ivec2& pixel,
                 DilatedMotionOf<Real>& result) {
  const bool startsFromFar = settings.method == DilateMethod::Closest3x3AsPrinted;
  bool hasAny = settings.ties != DilateTies::First || startsFromFar;
  const auto isPreferred = [&](Real depth) {
    if (!hasAny) return true;
    if (depth == result.depth) return settings.ties == DilateTies::Last;
    return settings.method == DilateMethod::Farthest3x3 ? depth < result.depth : depth > result.depth;
  };
  for (const glm::ivec2& step : candidates(settings.method)) {
    if (step == glm::ivec2(0) && hasAny && settings.ties != DilateTies::First && !startsFromFar) continue;
    const glm::ivec2 neighbor = clampedToDrawn(pixel + step, inputs);
    const Real depth = read<Real>(inputs.depth, neighbor).x;
    if (!isPreferred(depth)) continue;
    hasAny = true;
    result.depth = depth;
    result.offset = neighbor - pixel;
  }
}

/// The fastest of them, 4.5 and 4.6.
template <typename Real>
void findLongest(const Inputs& inputs, DilateMethod method, const glm::ivec2& pixel,
                 DilatedMotionOf<Real>& result) {
  const auto squaredLength = [&inputs](const glm::ivec2& p) -> Real {
    const Vec4<Real> motion = read<Real>(inputs.motion, p);
    const Real squared = motion.x * motion.x + motion.y * motion.y;
    return squared >= 0.0f ? squared : 0.0f; // NaN is no motion
  };
  Real longest = squaredLength(pixel);
  for (const glm::ivec2& step : candidates(method)) {
    const glm::ivec2 neighbor = clampedToDrawn(pixel + step, inputs);
    const Real length = squaredLength(neighbor);
    if (length > longest) {
      longest = length;
      result.offset = neighbor - pixel;
      result.depth = read<Real>(inputs.depth, neighbor).x;
    }
  }
}

/// HDRP's four taps as printed (D13): a tap that is no farther than what is kept is chosen, but the depth
/// kept with it is the next tap's.
template <typename Real>
void findClosestXAsPrinted(const Inputs& inputs, const glm::ivec2& pixel, DilatedMotionOf<Real>& result) {
  const auto tap = [&](int dx, int dy) { return clampedToDrawn(pixel + glm::ivec2(dx, dy), inputs); };
  const std::array taps{tap(1, 1), tap(-1, -1), tap(1, -1), tap(-1, 1), tap(1, 1)};
  const auto depthAt = [&inputs](const glm::ivec2& p) { return read<Real>(inputs.depth, p).x; };
  Real kept = result.depth;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!(depthAt(taps[k]) >= kept)) continue;
    kept = depthAt(taps[k + 1]);
    result.offset = taps[k] - pixel;
  }
  result.depth = depthAt(pixel + result.offset);
}

} // namespace

template <typename Real>
DilatedMotionOf<Real> dilateMotion(const Inputs& inputs, const DilateSettings& settings,
                                   const glm::ivec2& texel) {
  DilatedMotionOf<Real> result;
  result.depth = read<Real>(inputs.depth, texel).x;
  switch (settings.method) {
  case DilateMethod::None:
    break;
  case DilateMethod::Longest3x3:
  case DilateMethod::LongestCross:
    findLongest(inputs, settings.method, texel, result);
    break;
  case DilateMethod::Closest3x3AsPrinted: // starts from nothing at texel (0, 0): D4
    result.depth = 0.0f;
    result.offset = -texel;
    findClosest(inputs, settings, texel, result);
    break;
  case DilateMethod::ClosestXAsPrinted:
    findClosestXAsPrinted(inputs, texel, result);
    break;
  case DilateMethod::Closest3x3:
  case DilateMethod::ClosestCross:
  case DilateMethod::ClosestX:
  case DilateMethod::ClosestX2:
  case DilateMethod::Farthest3x3:
    findClosest(inputs, settings, texel, result);
    break;
  }
  glm::ivec2 chosen = texel + result.offset;
  if (settings.upLeft == Switch::On) { // Godot's missing border
    chosen = clampedToDrawn(chosen - 1, inputs);
    result.offset = chosen - texel;
    result.depth = read<Real>(inputs.depth, chosen).x;
  }
  result.motion = pictureMotion(inputs, Vec2<Real>(read<Real>(inputs.motion, chosen)));
  return result;
}

#define TAA_DILATE(Real)                                                                                     \
  template Real viewDepth(Real depth, const glm::vec4& depthTerms);                                          \
  template DilatedMotionOf<Real> dilateMotion(const Inputs& inputs, const DilateSettings& settings,          \
                                              const glm::ivec2& texel);
TAA_EACH_NUMBER(TAA_DILATE)
#undef TAA_DILATE

} // namespace taa::twin
