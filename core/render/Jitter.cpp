#include "core/render/Jitter.h"

#include "core/render/JitterPoints.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

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
  case JitterSequence::Halton:
  case JitterSequence::None: // those from here on are points of a table and do not come here
  case JitterSequence::Still:
  case JitterSequence::Uniform2:
  case JitterSequence::Uniform4:
  case JitterSequence::Helix:
  case JitterSequence::DoubleHelix:
  case JitterSequence::Butterfly:
  case JitterSequence::RotatedGrid:
  case JitterSequence::Poisson10:
  case JitterSequence::Pentagram:
  case JitterSequence::Perpendicular:
  case JitterSequence::Msaa8:
  case JitterSequence::BlueNoise16:
    break;
  }
  return {radicalInverse(index, 2), radicalInverse(index, 3)};
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
  if (settings.taa == Switch::Off) return 1;
  const std::span<const glm::vec2> points = pointsOf(settings.sequence);
  return points.empty() ? settings.period : static_cast<int>(points.size());
}

int jitterIndex(const JitterSettings& settings, int frame) {
  assert(frame >= 0);
  return frame % jitterPeriod(settings);
}

glm::vec2 jitterPx(const JitterSettings& settings, int frame, const glm::dvec2& way) {
  if (settings.taa == Switch::Off) return glm::vec2(0.0f);
  const int index = settings.firstIndex + jitterIndex(settings, frame);
  const std::span<const glm::vec2> points = pointsOf(settings.sequence);
  if (!points.empty()) {
    const glm::vec2 point = points[static_cast<std::size_t>(index) % points.size()];
    if (settings.sequence != JitterSequence::Perpendicular) return settings.scale * point;
    // + 0: no −0 in files and tables.
    return settings.scale * glm::vec2(double(point.y) * glm::dvec2(-way.y, way.x) + 0.0);
  }
  return settings.scale * (glm::vec2(sequencePoint(settings, index)) - 0.5f);
}

glm::mat4 jittered(const glm::mat4& clipFromView, glm::vec2 jitterPx, glm::vec2 sizePx,
                   JitterProjection projection) {
  const glm::vec2 offset = glm::vec2(2.0f, -2.0f) * (jitterPx / sizePx); // NDC, y up
  const glm::vec2 slope(clipFromView[0][0], clipFromView[1][1]);
  const bool isOrthographic = clipFromView[2][3] == 0.0f;
  glm::mat4 result = clipFromView;
  const auto add = [&](int column, const glm::vec2& value) {
    result[column][0] += value.x;
    result[column][1] += value.y;
  };
  switch (projection) {
  case JitterProjection::Translation:
    for (int column = 0; column < 4; ++column) add(column, offset * clipFromView[column][3]);
    break;
  case JitterProjection::AddedAsPrinted: // right for w = z
    add(isOrthographic ? 3 : 2, offset);
    break;
  case JitterProjection::ColumnAsPrinted: // Bevy takes half of the slope where there is no perspective
    add(2, isOrthographic ? -0.5f * slope * offset : -offset);
    break;
  case JitterProjection::RightAsPrinted:
    add(3, slope * offset);
    break;
  }
  return result;
}

glm::vec4 addedInClip(const glm::mat4& clipFromView, const glm::mat4& jittered) {
  // Of view z and of 1, which clip z and w are made of: two equations for the two factors.
  const glm::dmat4 plain(clipFromView), added = glm::dmat4(jittered) - plain;
  const double determinant = plain[2][3] * plain[3][2] - plain[3][3] * plain[2][2];
  const glm::dvec2 ofZ(added[2]), ofOne(added[3]);
  const glm::dvec2 timesW = (ofZ * plain[3][2] - ofOne * plain[2][2]) / determinant;
  const glm::dvec2 timesZ = (ofOne * plain[2][3] - ofZ * plain[3][3]) / determinant;
  return glm::vec4(timesW, timesZ);
}

} // namespace taa
