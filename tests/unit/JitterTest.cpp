// The jitter pattern and its matrix: invariants 1, 2, 5, 6, 7 and 8.
#include "core/render/Jitter.h"

#include "core/scene/Pose.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace taa {
namespace {

constexpr glm::vec2 kSize{320.0f, 180.0f};

struct Rational {
  int numerator, denominator;
  float value() const { return static_cast<float>(numerator) / static_cast<float>(denominator); }
};

JitterSettings halton(int period, int firstIndex = 1) {
  return {JitterSequence::Halton, period, firstIndex, 1.0f};
}

TEST(Jitter, GivesTheExactFractionsOfHalton) {
  const std::array<Rational, 8> two{{{1, 2}, {1, 4}, {3, 4}, {1, 8}, {5, 8}, {3, 8}, {7, 8}, {1, 16}}};
  const std::array<Rational, 8> three{{{1, 3}, {2, 3}, {1, 9}, {4, 9}, {7, 9}, {2, 9}, {5, 9}, {8, 9}}};
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(radicalInverse(i + 1, 2), two[static_cast<std::size_t>(i)].value()) << i + 1;
    EXPECT_EQ(radicalInverse(i + 1, 3), three[static_cast<std::size_t>(i)].value()) << i + 1;
  }
  EXPECT_EQ(radicalInverse(0, 2), 0.0f);
  EXPECT_EQ(radicalInverse(0, 3), 0.0f);
}

TEST(Jitter, HasTheMeanOfItsPeriod) {
  for (const int period : {8, 16, 32}) {
    glm::dvec2 fromOne(0.0), fromZero(0.0);
    for (int frame = 0; frame < period; ++frame) {
      fromOne += glm::dvec2(jitterPx(halton(period), frame)) / double(period);
      fromZero += glm::dvec2(jitterPx(halton(period, 0), frame)) / double(period);
    }
    // Binary fractions and their sums are exact.
    EXPECT_EQ(fromOne.x, -1.0 / (2.0 * period) + 1.0 / (2.0 * period * period));
    EXPECT_EQ(fromZero.x, -1.0 / (2.0 * period));
    const double expectedY = period == 8 ? 0.0 : period == 16 ? -0.037037 : -0.018519;
    EXPECT_NEAR(fromOne.y, expectedY, 1e-6) << "thirds are rounded, and the expectation has six digits";
  }
}

TEST(Jitter, StaysInsideThePixelTimesTheScale) {
  for (const float scale : {0.0f, 0.25f, 1.0f}) {
    JitterSettings settings = halton(1024, 0);
    settings.scale = scale;
    for (int frame = 0; frame < 1024; ++frame) {
      const glm::vec2 jitter = jitterPx(settings, frame);
      EXPECT_LE(std::abs(jitter.x), 0.5f * scale);
      EXPECT_LE(std::abs(jitter.y), 0.5f * scale);
    }
  }
}

TEST(Jitter, RepeatsAfterThePeriod) {
  const JitterSettings settings = halton(16);
  for (int frame = 0; frame < 16; ++frame) {
    EXPECT_EQ(jitterIndex(settings, frame), frame);
    EXPECT_EQ(jitterIndex(settings, frame + 48), frame);
    EXPECT_EQ(jitterPx(settings, frame), jitterPx(settings, frame + 48));
  }
  EXPECT_NE(jitterPx(settings, 0), jitterPx(settings, 1));
}

TEST(Jitter, IsNothingWithoutASequence) {
  const JitterSettings none{JitterSequence::None, 16, 1, 1.0f};
  EXPECT_EQ(jitterPx(none, 3), glm::vec2(0.0f));
  EXPECT_EQ(jitterIndex(none, 3), 0);
}

const std::array<glm::mat4, 2>& projections() {
  static const std::array<glm::mat4, 2> kProjections{perspectiveReversed(0.8f, 16.0f / 9.0f, 0.1f),
                                                     orthographicReversed(4.0f, 16.0f / 9.0f, 0.1f, 100.0f)};
  return kProjections;
}

glm::dvec2 pixelOf(const glm::mat4& clipFromView, const glm::vec3& point) {
  const glm::dvec4 clip = glm::dmat4(clipFromView) * glm::dvec4(point, 1.0);
  const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
  return glm::dvec2(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) * glm::dvec2(kSize);
}

const std::array<glm::vec3, 4> kPoints{{{0, 0, -1}, {0.3f, -0.2f, -0.5f}, {-4, 2, -9}, {5, 7, -80}}};

TEST(Jitter, MovesContentTheSameWayAtEveryDepth) {
  const glm::vec2 jitter(0.375f, -0.25f);
  for (const glm::mat4& projection : projections())
    for (const glm::vec3& point : kPoints) {
      const glm::dvec2 moved =
          pixelOf(jittered(projection, jitter, kSize), point) - pixelOf(projection, point);
      EXPECT_NEAR(moved.x, jitter.x, 1e-4) << "the matrix holds 24 bits of a displacement in 320 px";
      EXPECT_NEAR(moved.y, jitter.y, 1e-4);
    }
}

TEST(Jitter, DoesNotTouchDepth) {
  for (const glm::mat4& projection : projections())
    for (const glm::vec3& point : kPoints) {
      const glm::vec4 plain = projection * glm::vec4(point, 1.0f);
      const glm::vec4 moved = jittered(projection, glm::vec2(0.5f, -0.4f), kSize) * glm::vec4(point, 1.0f);
      EXPECT_EQ(plain.z, moved.z);
      EXPECT_EQ(plain.w, moved.w);
    }
}

TEST(Jitter, MultipliesTheProjectionFromTheLeft) {
  const glm::vec2 jitter(0.4375f, 0.3125f);
  glm::mat4 translation(1.0f);
  translation[3] = glm::vec4(2.0f * jitter.x / kSize.x, -2.0f * jitter.y / kSize.y, 0.0f, 1.0f);
  for (const glm::mat4& projection : projections()) {
    const glm::mat4 expected = translation * projection, wrong = projection * translation;
    const glm::mat4 actual = jittered(projection, jitter, kSize);
    bool equalsWrong = true;
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) {
        EXPECT_FLOAT_EQ(actual[column][row], expected[column][row]);
        equalsWrong = equalsWrong && actual[column][row] == wrong[column][row];
      }
    EXPECT_FALSE(equalsWrong);
  }
}

TEST(Jitter, EditsTheElementsOfEitherProjection) {
  const glm::vec2 jitter(0.25f, -0.5f), ndc(2.0f * jitter.x / kSize.x, -2.0f * jitter.y / kSize.y);
  glm::mat4 perspective = projections()[0], orthographic = projections()[1];
  perspective[2][0] -= ndc.x; // w = −z
  perspective[2][1] -= ndc.y;
  orthographic[3][0] += ndc.x;
  orthographic[3][1] += ndc.y;
  EXPECT_EQ(jittered(projections()[0], jitter, kSize), perspective);
  EXPECT_EQ(jittered(projections()[1], jitter, kSize), orthographic);
}

} // namespace
} // namespace taa
