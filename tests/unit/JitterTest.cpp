// The jitter pattern and its matrix: invariants 1, 2, 5, 6, 7 and 8.
#include "core/render/Jitter.h"

#include "core/scene/Pose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

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

// Techniques: J9.
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

// Techniques: J9.
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

std::vector<JitterSequence> allSequences() {
  std::vector<JitterSequence> all;
  for (int i = 0; i <= static_cast<int>(JitterSequence::WhiteNoise); ++i)
    all.push_back(static_cast<JitterSequence>(i));
  return all;
}

// Techniques: 2.2.
TEST(Jitter, StaysInsideThePixelTimesTheScale) {
  for (const JitterSequence sequence : allSequences())
    for (const float scale : {0.0f, 0.25f, 1.0f})
      for (int frame = 0; frame < 1024; ++frame) {
        const glm::vec2 jitter = jitterPx({sequence, 1024, 0, scale}, frame);
        EXPECT_LE(std::abs(jitter.x), 0.5f * scale) << static_cast<int>(sequence) << " at " << frame;
        EXPECT_LE(std::abs(jitter.y), 0.5f * scale) << static_cast<int>(sequence) << " at " << frame;
      }
}

// Techniques: J4.
TEST(Jitter, HasAPeriodOfItsOwnWhereItIsAListOfPoints) {
  const auto period = [](JitterSequence sequence) { return jitterPeriod({sequence, 12, 1, 1.0f}); };
  EXPECT_EQ(period(JitterSequence::None), 1);
  EXPECT_EQ(period(JitterSequence::Uniform2), 2);
  EXPECT_EQ(period(JitterSequence::DoubleHelix), 8);
  EXPECT_EQ(period(JitterSequence::Pentagram), 5);
  EXPECT_EQ(period(JitterSequence::Poisson10), 10);
  EXPECT_EQ(period(JitterSequence::BlueNoise16), 16);
  EXPECT_EQ(period(JitterSequence::R2), 12);
  for (const JitterSequence sequence : allSequences())
    for (int frame = 0; frame < 40; ++frame) {
      const JitterSettings settings{sequence, 12, 1, 1.0f};
      EXPECT_EQ(jitterPx(settings, frame), jitterPx(settings, frame + period(sequence)));
    }
}

// Invariant 3: these points are binary fractions, so that their sums are exact.
// Techniques: J5, J7, J15.
TEST(Jitter, SumsToZeroWhereThePatternIsSymmetric) {
  for (const JitterSequence sequence :
       {JitterSequence::Uniform2, JitterSequence::Uniform4, JitterSequence::Perpendicular,
        JitterSequence::Helix, JitterSequence::DoubleHelix, JitterSequence::Butterfly,
        JitterSequence::RotatedGrid, JitterSequence::Poisson10, JitterSequence::Msaa8,
        JitterSequence::BlueNoise16}) {
    const JitterSettings settings{sequence, 16, 1, 1.0f};
    glm::vec2 sum(0.0f);
    for (int frame = 0; frame < jitterPeriod(settings); ++frame) sum += jitterPx(settings, frame);
    EXPECT_EQ(sum, glm::vec2(0.0f)) << static_cast<int>(sequence);
  }
}

// The four orders of J2 to J4 visit the same points.
// Techniques: J3, J4.
TEST(Jitter, VisitsTheSameFourPointsInEveryOrder) {
  const auto pointsOf = [](JitterSequence sequence) {
    std::set<std::pair<float, float>> points;
    for (int frame = 0; frame < 8; ++frame) {
      const glm::vec2 jitter = jitterPx({sequence, 8, 0, 1.0f}, frame);
      points.insert({jitter.x, jitter.y});
    }
    return points;
  };
  const std::set<std::pair<float, float>> quarters = pointsOf(JitterSequence::Uniform4);
  EXPECT_EQ(quarters.size(), 4u);
  EXPECT_EQ(pointsOf(JitterSequence::Helix), quarters);
  EXPECT_EQ(pointsOf(JitterSequence::DoubleHelix), quarters);
}

// Each of the sixteen rows and columns, eight of 8×MSAA and four of the rotated grid holds one point.
// Techniques: J6, J14, J15.
TEST(Jitter, HoldsOnePointInEachRowAndColumn) {
  for (const JitterSequence sequence :
       {JitterSequence::BlueNoise16, JitterSequence::Msaa8, JitterSequence::RotatedGrid}) {
    const JitterSettings settings{sequence, 1, 0, 1.0f};
    const int count = jitterPeriod(settings);
    std::set<int> columns, rows;
    for (int frame = 0; frame < count; ++frame) {
      const glm::vec2 cell = (jitterPx(settings, frame) + 0.5f) * static_cast<float>(count);
      columns.insert(static_cast<int>(std::floor(cell.x)));
      rows.insert(static_cast<int>(std::floor(cell.y)));
    }
    EXPECT_EQ(columns.size(), static_cast<std::size_t>(count)) << static_cast<int>(sequence);
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(count)) << static_cast<int>(sequence);
  }
}

// Invariant 4; the expectations have five and six digits.
// Techniques: J11, J12, J13.
TEST(Jitter, FollowsThePublishedFormulas) {
  const JitterSettings r2{JitterSequence::R2, 16, 0, 1.0f};
  EXPECT_EQ(jitterPx(r2, 0), glm::vec2(0.0f));
  EXPECT_NEAR(jitterPx(r2, 1).x, -0.24512f, 5e-6f);
  EXPECT_NEAR(jitterPx(r2, 1).y, -0.43016f, 5e-6f);
  EXPECT_NEAR(jitterPx(r2, 2).x, -0.49024f, 5e-6f);
  EXPECT_NEAR(jitterPx(r2, 2).y, 0.13968f, 5e-6f);
  for (int frame = 0; frame < 8; ++frame) {
    const glm::vec2 jitter = jitterPx({JitterSequence::Hammersley, 8, 0, 1.0f}, frame);
    EXPECT_EQ(jitter.x, static_cast<float>(frame) / 8.0f - 0.5f);
    EXPECT_EQ(jitter.y, radicalInverse(frame, 2) - 0.5f);
  }
  EXPECT_NEAR(gradientNoise(1, 0, 0), 0.555713, 5e-7);
  EXPECT_NEAR(gradientNoise(0, 1, 0), 0.309269, 5e-7);
  EXPECT_NEAR(gradientNoise(1, 1, 0), 0.864983, 5e-7);
  const glm::vec2 noise = jitterPx({JitterSequence::GradientNoise, 16, 0, 1.0f}, 0);
  EXPECT_NEAR(noise.x, 0.864983f - 0.5f, 5e-7f);
}

// One tenth of a pixel is 17 standard errors of the mean of 1024 uniform points.
// Techniques: J16.
TEST(Jitter, SpreadsWhiteNoiseOverThePixel) {
  std::array<int, 16> cells{};
  glm::vec2 mean(0.0f);
  for (int frame = 0; frame < 1024; ++frame) {
    const glm::vec2 unit = jitterPx({JitterSequence::WhiteNoise, 1024, 0, 1.0f}, frame) + 0.5f;
    mean += unit / 1024.0f;
    ++cells[static_cast<std::size_t>(unit.x * 4.0f) + 4 * static_cast<std::size_t>(unit.y * 4.0f)];
  }
  EXPECT_NEAR(mean.x, 0.5f, 0.1f);
  EXPECT_NEAR(mean.y, 0.5f, 0.1f);
  for (const int count : cells) EXPECT_NEAR(count, 64, 40); // five standard deviations of 64 in 1024
}

// Techniques: 2.2.
TEST(Jitter, RepeatsAfterThePeriod) {
  const JitterSettings settings = halton(16);
  for (int frame = 0; frame < 16; ++frame) {
    EXPECT_EQ(jitterIndex(settings, frame), frame);
    EXPECT_EQ(jitterIndex(settings, frame + 48), frame);
    EXPECT_EQ(jitterPx(settings, frame), jitterPx(settings, frame + 48));
  }
  EXPECT_NE(jitterPx(settings, 0), jitterPx(settings, 1));
}

// Two points, turned with the way: index 0 to its left.
// Techniques: J10.
TEST(Jitter, LiesAcrossTheWayThatItIsGiven) {
  const JitterSettings settings{JitterSequence::Perpendicular, 16, 0, 1.0f};
  EXPECT_EQ(jitterPeriod(settings), 2);
  EXPECT_EQ(jitterPx(settings, 0), glm::vec2(0.0f, -0.25f));
  EXPECT_EQ(jitterPx(settings, 1), glm::vec2(0.0f, 0.25f));
  EXPECT_EQ(jitterPx(settings, 0, {0.0, -1.0}), glm::vec2(-0.25f, 0.0f)); // up, so to the left
  EXPECT_EQ(jitterPx(settings, 3, {0.0, -1.0}), glm::vec2(0.25f, 0.0f));
  EXPECT_EQ(jitterPx(settings, 0, {0.6, 0.8}), glm::vec2(0.2f, -0.15f));
  EXPECT_EQ(jitterPx({JitterSequence::Perpendicular, 16, 1, 0.5f}, 0, {0.6, 0.8}), glm::vec2(-0.1f, 0.075f));
  EXPECT_EQ(jitterPx({JitterSequence::Halton, 16, 1, 1.0f}, 3, {0.0, 1.0}), jitterPx(halton(16), 3));
}

// Techniques: J0, D18.
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

// Techniques: 2.1.
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

constexpr std::array kForms{JitterProjection::Translation, JitterProjection::AddedAsPrinted,
                            JitterProjection::ColumnAsPrinted, JitterProjection::RightAsPrinted};

// Invariant 6 fails for each of the printed forms, by what each comes to (manual §2.1).
// Techniques: 2.1, D15.
TEST(Jitter, MovesContentAsEachPrintedFormDoes) {
  const glm::vec2 jitter(0.375f, -0.25f);
  const auto& [perspective, orthographic] = projections();
  for (const glm::vec3& point : kPoints) {
    const double depth = -point.z;
    const auto expectMoved = [&](const glm::mat4& projection, JitterProjection form, glm::dvec2 expected) {
      const glm::dvec2 moved =
          pixelOf(jittered(projection, jitter, kSize, form), point) - pixelOf(projection, point);
      EXPECT_NEAR(moved.x, expected.x, 1e-4 * std::max(1.0, std::abs(expected.x)))
          << int(form) << " at " << depth;
      EXPECT_NEAR(moved.y, expected.y, 1e-4 * std::max(1.0, std::abs(expected.y)))
          << int(form) << " at " << depth;
    };
    const glm::dvec2 j(jitter);
    const auto slope = [](const glm::mat4& projection) {
      return glm::dvec2(projection[0][0], projection[1][1]);
    };
    expectMoved(perspective, JitterProjection::AddedAsPrinted, -j);
    expectMoved(orthographic, JitterProjection::AddedAsPrinted, j);
    expectMoved(perspective, JitterProjection::ColumnAsPrinted, j);
    expectMoved(orthographic, JitterProjection::ColumnAsPrinted, 0.5 * slope(orthographic) * j * depth);
    expectMoved(perspective, JitterProjection::RightAsPrinted, slope(perspective) * j / depth);
    expectMoved(orthographic, JitterProjection::RightAsPrinted, slope(orthographic) * j);
  }
}

// Invariant 7: the element-edited column is the translation where there is perspective.
TEST(Jitter, ThirdColumnIsTheTranslationWithPerspective) {
  const glm::vec2 jitter(0.4375f, 0.3125f);
  const auto& [perspective, orthographic] = projections();
  EXPECT_EQ(jittered(perspective, jitter, kSize, JitterProjection::ColumnAsPrinted),
            jittered(perspective, jitter, kSize));
  EXPECT_NE(jittered(orthographic, jitter, kSize, JitterProjection::ColumnAsPrinted),
            jittered(orthographic, jitter, kSize));
  EXPECT_EQ(jittered(orthographic, jitter, kSize, JitterProjection::AddedAsPrinted),
            jittered(orthographic, jitter, kSize));
}

// Vertices are moved in clip space: by terms of their z and w that come to the same as the matrix.
TEST(Jitter, OfEachFormIsASumOfClipSpaceZAndW) {
  const glm::vec2 jitter(0.375f, -0.25f);
  for (const JitterProjection form : kForms)
    for (const glm::mat4& projection : projections()) {
      const glm::mat4 moved = jittered(projection, jitter, kSize, form);
      const glm::vec4 added = addedInClip(projection, moved);
      for (const glm::vec3& point : kPoints) {
        const glm::dvec4 clip = glm::dmat4(projection) * glm::dvec4(point, 1.0);
        const glm::dvec4 wanted = glm::dmat4(moved) * glm::dvec4(point, 1.0) - clip;
        EXPECT_NEAR(added.x * clip.w + added.z * clip.z, wanted.x, 1e-8 * (1.0 + clip.w)) << int(form);
        EXPECT_NEAR(added.y * clip.w + added.w * clip.z, wanted.y, 1e-8 * (1.0 + clip.w)) << int(form);
      }
    }
}

TEST(Jitter, DoesNotTouchDepth) {
  for (const JitterProjection form : kForms)
    for (const glm::mat4& projection : projections())
      for (const glm::vec3& point : kPoints) {
        const glm::vec4 plain = projection * glm::vec4(point, 1.0f);
        const glm::vec4 moved =
            jittered(projection, glm::vec2(0.5f, -0.4f), kSize, form) * glm::vec4(point, 1.0f);
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
