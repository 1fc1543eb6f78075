#include "core/render/Jitter.h"

#include "core/render/JitterPoints.h"

#include <cassert>
#include <cmath>
#include <cstdint>

namespace taa {

namespace {

constexpr double kPlastic = 1.32471795724474602596; // x³ = x + 1

// Two words in, two well mixed words out: the two-dimensional hash of Jarzynski and Olano 2020 (pcg2d).
glm::uvec2 hashed(glm::uvec2 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  return v ^ (v >> 16u);
}

// In the unit square. Doubles keep the fractions of large indices; they are rounded to floats once.
glm::dvec2 sequencePoint(const JitterSettings& settings, int index) {
  switch (settings.sequence) {
  case JitterSequence::R2: {
    const glm::dvec2 point = 0.5 + double(index) / glm::dvec2(kPlastic, kPlastic * kPlastic);
    return point - glm::floor(point);
  }
  case JitterSequence::Hammersley: {
    const int i = index % settings.period;
    return {double(i) / settings.period, radicalInverse(i, 2)};
  }
  case JitterSequence::GradientNoise:
    return {gradientNoise(1, 1, index), gradientNoise(1, 2, index)};
  case JitterSequence::WhiteNoise: {
    const glm::uvec2 hash = hashed({static_cast<std::uint32_t>(index), 0x9e3779b9u}) >> 8u;
    return glm::dvec2(hash) / 16777216.0; // 24 bits: below 1 in a float too
  }
  default:
    return {radicalInverse(index, 2), radicalInverse(index, 3)};
  }
}

} // namespace

float radicalInverse(int index, int base) {
  assert(index >= 0 && base >= 2);
  // Numerator and denominator are exact integers. While the denominator is below 2^27 (indices to 10^7) no
  // quotient comes near enough to the middle of two floats for the double in between to round twice.
  std::int64_t numerator = 0, denominator = 1;
  for (int rest = index; rest > 0; rest /= base) {
    numerator = numerator * base + rest % base;
    denominator *= base;
  }
  return static_cast<float>(static_cast<double>(numerator) / static_cast<double>(denominator));
}

double gradientNoise(double x, double y, int index) {
  const auto fraction = [](double value) { return value - std::floor(value); };
  const double shift = 5.588238 * index;
  return fraction(52.9829189 * fraction(0.06711056 * (x + shift) + 0.00583715 * (y + shift)));
}

int jitterPeriod(const JitterSettings& settings) {
  assert(settings.period > 0);
  const std::span<const glm::vec2> points = pointsOf(settings.sequence);
  return points.empty() ? settings.period : static_cast<int>(points.size());
}

int jitterIndex(const JitterSettings& settings, int frame) {
  assert(frame >= 0);
  return frame % jitterPeriod(settings);
}

glm::vec2 jitterPx(const JitterSettings& settings, int frame) {
  const int index = settings.firstIndex + jitterIndex(settings, frame);
  const std::span<const glm::vec2> points = pointsOf(settings.sequence);
  if (!points.empty()) return settings.scale * points[static_cast<std::size_t>(index) % points.size()];
  return settings.scale * (glm::vec2(sequencePoint(settings, index)) - 0.5f);
}

glm::mat4 jittered(const glm::mat4& clipFromView, glm::vec2 jitterPx, glm::vec2 sizePx) {
  const glm::vec2 offset = glm::vec2(2.0f, -2.0f) * (jitterPx / sizePx); // NDC, y up
  glm::mat4 result = clipFromView;
  for (int column = 0; column < 4; ++column) {
    result[column][0] += offset.x * clipFromView[column][3];
    result[column][1] += offset.y * clipFromView[column][3];
  }
  return result;
}

} // namespace taa
