// Stage 10, output: what is shown of the resolved picture, sharpened (manual §18) and blurred where it is
// fast (14.4).
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Random.h"
#include "core/taa/twin/Stages.h"
#include "core/taa/twin/Upsample.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace taa::twin {
namespace {

using Nine = std::array<glm::vec3, 9>; // 3×3, row-major

/// Speed of what has no previous position, px; no motion is faster.
constexpr float kUnknownSpeed = 65504.0f;

constexpr std::array<std::size_t, 4> kCross{1, 3, 5, 7};
constexpr std::array<std::size_t, 4> kCorners{0, 2, 6, 8};

/// Sum of the differences of four to the middle one.
glm::vec3 differences(const Nine& c, const std::array<std::size_t, 4>& places) {
  glm::vec3 sum = c[places[0]] - c[4];
  for (std::size_t i = 1; i < 4; ++i) sum = sum + (c[places[i]] - c[4]);
  return sum;
}

glm::vec3 sharpenedByLuma(const Nine& c, float amount) {
  const float center = luma(c[4]);
  if (!(center > 1e-6f)) return c[4];
  float sum = 0.0f;
  for (const glm::vec3& color : c) sum = sum + (luma(color) - center);
  return (1.0f - amount * ((sum / 9.0f) / center)) * c[4];
}

/// By the mean of the four around (manual 18.3).
glm::vec3 sharpenedByLaplacian(const Nine& c, float amount) {
  return c[4] - amount * (differences(c, kCross) / 4.0f);
}

/// By that of all nine (manual 18.3).
glm::vec3 unsharpMasked(const Nine& c, float amount) {
  return c[4] - amount * ((differences(c, kCross) + differences(c, kCorners)) / 9.0f);
}

glm::vec3 sharpenedByRcas(const Nine& c, float amount) {
  const Nine t = compressMax(c);
  const float lobe = rcasLobe(t, amount);
  const glm::vec3 result = t[4] - (lobe * differences(t, kCross)) / (1.0f - 4.0f * lobe);
  return result == t[4] ? c[4] : decompress(result, ToneSpace::MaxChannel);
}

glm::vec3 brightenedInResolve(const Nine& c, const Nine& current, float amount) {
  return c[4] + (3.0f * amount) * maximum(c[4] - meanInResolve(current), glm::vec3(0.0f));
}

glm::vec3 squareRoot(const glm::vec3& x) {
  return {std::sqrt(x.x), std::sqrt(x.y), std::sqrt(x.z)};
}

/// ratio^(steps/256) from its whole power and its square roots.
glm::vec3 toAmount(const glm::vec3& ratio, int steps) {
  glm::vec3 result(1.0f);
  for (int whole = steps / 256; whole > 0; --whole) result = result * ratio;
  glm::vec3 root = ratio;
  for (int bit = 7; bit >= 0; --bit) {
    root = squareRoot(root);
    if ((steps >> bit & 1) != 0) result = result * root;
  }
  return result;
}

glm::vec3 sharpenedInLogarithms(const Nine& c, float amount) {
  const glm::vec3 upright = squareRoot((1.0f + c[1]) * (1.0f + c[7]));
  const glm::vec3 level = squareRoot((1.0f + c[3]) * (1.0f + c[5]));
  const glm::vec3 center = 1.0f + c[4];
  const int steps = static_cast<int>(std::floor(amount * 256.0f + 0.5f));
  return c[4] + center * (toAmount(center / squareRoot(upright * level), steps) - 1.0f);
}

glm::vec3 reconstructed(const Nine& c, float amount) {
  const float b = amount / 6.0f;
  return c[4] + ((b * b) * differences(c, kCorners) - (b * (1.0f + 2.0f * b)) * differences(c, kCross));
}

/// 1/18, 8/9, 1/18 each way (manual 6.6).
glm::vec3 mitchellFiltered(const Nine& c) {
  return c[4] + (differences(c, kCorners) + 16.0f * differences(c, kCross)) / 324.0f;
}

glm::vec3 sharpenedBy(const OutputSettings& settings, const Nine& c, const Nine& current) {
  const float k = settings.amount;
  switch (settings.sharpen) {
  case Sharpen::None:
    break;
  case Sharpen::LumaRatio:
    return sharpenedByLuma(c, k);
  case Sharpen::Laplacian:
    return sharpenedByLaplacian(c, k);
  case Sharpen::Unsharp:
    return unsharpMasked(c, k);
  case Sharpen::Rcas:
    return sharpenedByRcas(c, k);
  case Sharpen::InResolve:
    return brightenedInResolve(c, current, k);
  case Sharpen::Logarithm:
    return sharpenedInLogarithms(c, k);
  case Sharpen::Reconstruct:
    return reconstructed(c, k);
  case Sharpen::Mitchell:
    return mitchellFiltered(c);
  }
  return c[4];
}

glm::vec3 deringed(const glm::vec3& color, const Nine& c) {
  glm::vec3 low = c[0], high = c[0];
  for (const glm::vec3& other : c) {
    low = minimum(low, other);
    high = maximum(high, other);
  }
  return clamped(color, low, high);
}

/// Start of the taps: interleaved gradient noise, 0 to 1.
float gradientNoise(const glm::ivec2& pixel, int frame) {
  const auto fraction = [](float x) { return x - std::floor(x); };
  const glm::vec2 place = glm::vec2(pixel) + 5.588238f * static_cast<float>(frame % 64);
  return fraction(52.9829189f * fraction(0.06711056f * place.x + 0.00583715f * place.y));
}

glm::vec3 currentAt(const Inputs& inputs, const glm::vec2& position) {
  const glm::vec2 corner(std::floor(position.x - 0.5f), std::floor(position.y - 0.5f));
  const glm::vec2 share = (position - 0.5f) - corner;
  const auto row = [&](int y) {
    const glm::ivec2 first(glm::ivec2(corner) + glm::ivec2(0, y));
    const glm::vec3 left = currentColor(inputs, first);
    return left + share.x * (currentColor(inputs, first + glm::ivec2(1, 0)) - left);
  };
  const glm::vec3 top = row(0);
  return top + share.y * (row(1) - top);
}

glm::vec3 blurredAlong(const Inputs& inputs, const glm::vec2& position, const glm::vec2& motion,
                       float noise) {
  const glm::vec2 step = motion / 6.0f;
  const float start = noise - 0.5f;
  const auto tap = [&](float number) { return currentAt(inputs, position + (start + number) * step); };
  const glm::vec3 first = tap(-3.0f);
  glm::vec3 sum(0.0f);
  for (int i = -2; i <= 3; ++i) sum = sum + (tap(static_cast<float>(i)) - first);
  return first + sum / 7.0f;
}

/// The layer drawn without jitter over a color (manual 21.1); `texel`: the one that holds the pixel's
/// center.
glm::vec3 covered(const Inputs& inputs, const glm::ivec2& texel, const glm::vec3& color) {
  if (inputs.overlay.empty()) return color;
  const glm::vec4 layer = inputs.overlay.texel(texel.x, texel.y);
  return storable(color * (1.0f - layer.w) + glm::vec3(layer));
}

/// The sharp color, and where it is fast the blurred one joined to it (manual 14.4). `texel`: the pixel's
/// nearest sample.
ShownColor blurredByMotion(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                           const glm::ivec2& texel, const ShownColor& sharp) {
  const glm::vec2 motion = dilateMotion(inputs, settings.dilate, texel).motion;
  const float speed = reproject(inputs, settings.reproject, motion, pixel).speed;
  ShownColor shown = sharp;
  if (speed >= kUnknownSpeed) return shown;
  shown.trust = 1.0f - saturated((speed - 2.0f) / 13.0f);
  if (shown.trust >= 1.0f) return shown;
  const glm::vec2 position = (glm::vec2(pixel) + 0.5f) * renderRatio(inputs); // render px, as the blur's way
  const glm::vec3 fast =
      blurredAlong(inputs, position, motion * renderRatio(inputs), gradientNoise(pixel, inputs.frame));
  shown.fast = fast;
  shown.color = fast + shown.trust * (sharp.color - fast);
  return shown;
}

} // namespace

std::array<glm::vec3, 9> compressMax(const std::array<glm::vec3, 9>& colors) {
  Nine result;
  for (std::size_t k = 0; k < 9; ++k) result[k] = compress(colors[k], ToneSpace::MaxChannel);
  return result;
}

float rcasLobe(const std::array<glm::vec3, 9>& t, float amount) {
  const glm::vec3 low = minimum(minimum(t[1], t[3]), minimum(t[5], t[7]));
  const glm::vec3 high = maximum(maximum(t[1], t[3]), maximum(t[5], t[7]));
  float lobe = 0.1875f;
  for (int i = 0; i < 3; ++i) {
    const float least = low[i] < t[4][i] ? low[i] : t[4][i];
    const float most = high[i] > t[4][i] ? high[i] : t[4][i];
    const float room = high[i] > 0.0f ? least / (4.0f * high[i]) : 0.0f;
    const float headroom = (1.0f - most) / (4.0f - 4.0f * low[i]);
    lobe = room < lobe ? room : lobe;
    lobe = headroom < lobe ? headroom : lobe;
  }
  return lobe * saturated(amount);
}

glm::vec3 meanInResolve(const std::array<glm::vec3, 9>& current) {
  const glm::vec3 center = compress(current[4], ToneSpace::ReinhardLuma);
  glm::vec3 sum(0.0f);
  for (const glm::vec3& color : current) sum = sum + (compress(color, ToneSpace::ReinhardLuma) - center);
  const glm::vec3 mean = center + sum / 9.0f;
  return mean == center ? current[4] : decompress(mean, ToneSpace::ReinhardLuma);
}

glm::vec3 sharpen(const OutputSettings& settings, const std::array<glm::vec3, 9>& c,
                  const std::array<glm::vec3, 9>& current) {
  if (settings.sharpen == Sharpen::None) return c[4];
  const glm::vec3 result = sharpenedBy(settings, c, current);
  return storable(settings.dering == Switch::On ? deringed(result, c) : result);
}

ShownColor showOutput(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  const glm::ivec2 texel = isUpsampled(settings) ? placeOf(inputs, pixel).texel : pixel;
  Nine around, current;
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 step(k % 3 - 1, k / 3 - 1);
    const glm::ivec2 at = clampedToPicture(pixel + step, inputs);
    around[static_cast<std::size_t>(k)] = glm::vec3(inputs.resolved.texel(at.x, at.y));
    current[static_cast<std::size_t>(k)] = currentColor(inputs, texel + step);
  }
  ShownColor shown;
  const OutputSettings output = isTaaOn(settings) ? settings.output : OutputSettings{};
  const glm::vec3 sharp = sharpen(output, around, current);
  shown.detail = luma(sharp) - luma(around[4]);
  shown.color = shown.sharp = sharp;
  if (output.motionBlur == Switch::On) shown = blurredByMotion(inputs, settings, pixel, texel, shown);
  shown.color = covered(inputs, isUpsampled(settings) ? placeOf(inputs, pixel).still : pixel, shown.color);
  if (output.dither == Switch::On) { // manual 20.8
    shown.noise = triangularNoise(pixel, inputs.frame) / 255.0f;
    shown.smooth = shown.color;
    const glm::vec3 root = maximum(squareRoot(shown.color) + shown.noise, glm::vec3(0.0f));
    shown.color = storable(root * root);
  }
  return shown;
}

} // namespace taa::twin
