// What single techniques do to hand-made pixels, set as the table of techniques names them, and predicted
// from the formulas of the manual. TechniquesTest lists which test shows which row.
#include "core/render/Jitter.h"
#include "core/settings/Parameters.h"
#include "tests/support/frames/TwinInputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <tuple>
#include <vector>

namespace taa {
namespace {

using twin::at;
using twin::Inputs;
using twin::PixelRecord;
using twin::resolvePixel;

/// The simplest pipeline with `assignments`, "path=value".
Settings with(std::initializer_list<const char*> assignments) {
  Settings settings = test::plainSettings();
  for (const char* assignment : assignments) applyAssignment(settings, assignment);
  return settings;
}

glm::vec3 valueOf(const Inputs& inputs, const Settings& settings, IntermediateId id,
                  glm::ivec2 pixel = {1, 1}) {
  return glm::vec3(at(resolvePixel(inputs, settings, pixel.x, pixel.y), id));
}

// ---- Jitter, manual 2.2

std::vector<glm::vec2> pointsOf(const char* sequence) {
  Settings settings = with({"jitter.firstIndex=0"});
  applyAssignment(settings, std::string("jitter.sequence=") + sequence);
  std::vector<glm::vec2> points;
  for (int frame = 0; frame < jitterPeriod(settings.jitter); ++frame)
    points.push_back(jitterPx(settings.jitter, frame));
  return points;
}

// Techniques: J0, J1, J2, J3, J5, J6, J14.
TEST(TechniqueEffect, FixedPatternsHaveTheirPoints) {
  using Points = std::vector<glm::vec2>;
  const float q = 0.25f, e = 0.125f, t = 0.375f;
  EXPECT_EQ(pointsOf("none"), Points({{0, 0}}));
  EXPECT_EQ(pointsOf("still"), Points({{0.5f, 0.5f}})) << "Playdead's is the corner of the pixel";
  EXPECT_EQ(pointsOf("uniform2"), Points({{-q, -q}, {q, q}}));
  EXPECT_EQ(pointsOf("uniform4"), Points({{-q, -q}, {q, -q}, {-q, q}, {q, q}}))
      << "in the order of the raster";
  EXPECT_EQ(pointsOf("helix"), Points({{-q, -q}, {q, q}, {q, -q}, {-q, q}}))
      << "each step crosses the middle";
  EXPECT_EQ(pointsOf("doubleHelix").size(), 8u);
  const Points butterfly = pointsOf("butterfly");
  ASSERT_EQ(butterfly.size(), 4u);
  for (const glm::vec2& point : {glm::vec2(e, -e), glm::vec2(-e, e)})
    EXPECT_EQ(std::ranges::count(butterfly, point), 1);
  EXPECT_EQ(pointsOf("rotatedGrid"), Points({{-e, -t}, {t, -e}, {e, t}, {-t, e}}));
  Points msaa{{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
  for (glm::vec2& point : msaa) point /= 16.0f;
  EXPECT_EQ(pointsOf("msaa8"), msaa);
}

// Techniques: J7, J8.
TEST(TechniqueEffect, DiscsAndStarsLieInTheirCircle) {
  for (const auto& [name, count, radius] :
       {std::tuple("poisson10", 10u, 0.25f), std::tuple("pentagram", 5u, 0.5f)}) {
    const std::vector<glm::vec2> points = pointsOf(name);
    EXPECT_EQ(points.size(), count) << name;
    for (const glm::vec2& point : points)
      EXPECT_LE(std::hypot(point.x, point.y), radius * 1.0001f)
          << name << ": of the unit disc times " << radius;
    for (std::size_t a = 0; a < points.size(); ++a)
      for (std::size_t b = a + 1; b < points.size(); ++b) EXPECT_NE(points[a], points[b]) << name;
  }
}

// Techniques: 1.9.
TEST(TechniqueEffect, TheFirstIndexMovesASequenceOnByFrames) {
  const Settings zero = with({"jitter.sequence=halton", "jitter.firstIndex=0"});
  for (const int first : {1, 5}) {
    Settings later = zero;
    later.jitter.firstIndex = first;
    for (int frame = 0; frame < 8; ++frame)
      EXPECT_EQ(jitterPx(later.jitter, frame),
                glm::vec2(radicalInverse(frame + first, 2), radicalInverse(frame + first, 3)) - 0.5f);
  }
}

// ---- Dilation, manual §4

/// 7×7 texels at 1 m; (3, 3) has two special neighbors: one above it, one to the lower right.
Inputs twoNeighbors(const glm::vec2& nearness, const glm::vec2& speed) {
  Inputs inputs = test::constantInputs(7, 7, glm::vec3(0.5f));
  inputs.depth.at(3, 2)[0] = nearness.x;
  inputs.depth.at(4, 4)[0] = nearness.y;
  inputs.motion.at(3, 2)[0] = speed.x;
  inputs.motion.at(4, 4)[1] = speed.y;
  return inputs;
}

// Techniques: 4.0, 4.1, 4.2, 4.3, 4.4, 4.5, 4.6.
TEST(TechniqueEffect, EachDilationLooksAtItsOwnNeighbors) {
  const glm::ivec2 above(0, -1), corner(1, 1), own(0, 0);
  const auto offset = [](const char* method, const Inputs& inputs) {
    Settings settings = with({});
    applyAssignment(settings, std::string("dilate.method=") + method);
    const glm::vec3 value = valueOf(inputs, settings, IntermediateId::dilatedOffset, {3, 3});
    return glm::ivec2(static_cast<int>(value.x), static_cast<int>(value.y));
  };
  const Inputs edgeNearest = twoNeighbors({0.5f, 0.4f}, {0, 0}),
               cornerNearest = twoNeighbors({0.4f, 0.5f}, {0, 0});
  EXPECT_EQ(offset("none", edgeNearest), own);
  EXPECT_EQ(offset("closest3x3", edgeNearest), above);
  EXPECT_EQ(offset("closest3x3", cornerNearest), corner);
  EXPECT_EQ(offset("closestCross", edgeNearest), above);
  EXPECT_EQ(offset("closestCross", cornerNearest), above) << "diagonals are not looked at";
  EXPECT_EQ(offset("closestX", edgeNearest), corner) << "only diagonals are";
  EXPECT_EQ(offset("closestX", cornerNearest), corner);
  EXPECT_EQ(offset("closestX2", cornerNearest), own) << "misses what is one pixel away";
  Inputs far = cornerNearest;
  far.depth.at(1, 5)[0] = 0.3f;
  EXPECT_EQ(offset("closestX2", far), glm::ivec2(-2, 2));
  const Inputs edgeFastest = twoNeighbors({0.1f, 0.1f}, {5, 4}),
               cornerFastest = twoNeighbors({0.1f, 0.1f}, {4, 5});
  EXPECT_EQ(offset("longest3x3", edgeFastest), above);
  EXPECT_EQ(offset("longest3x3", cornerFastest), corner);
  EXPECT_EQ(offset("longestCross", cornerFastest), above);
  EXPECT_EQ(offset("closest3x3", cornerFastest), own) << "speed does not matter to it";
}

// Manual §26, D4: a far-plane neighborhood returns the pixel in the picture's corner.
// Techniques: D4.
TEST(TechniqueEffect, ClosestAsPrintedGivesTheSkyTheMotionOfTheCorner) {
  Inputs inputs = test::constantInputs(7, 5, glm::vec3(0.5f));
  for (float& depth : inputs.depth.pixels) depth = 0.0f;
  inputs.motion.at(0, 0)[0] = 7.0f;
  inputs.motion.at(4, 3)[0] = 2.0f;
  const auto motion = [&](const char* method) {
    return valueOf(inputs, with({method}), IntermediateId::dilatedMotion, {4, 3}).x;
  };
  EXPECT_EQ(motion("dilate.method=closest3x3AsPrinted"), 7.0f);
  EXPECT_EQ(motion("dilate.method=closest3x3"), 2.0f);
}

// ---- Off the screen, manual §5

// Techniques: 5.0, 5.1, 5.3, 5.7.
TEST(TechniqueEffect, EachRuleOfTheBorderHasItsOwnInside) {
  Inputs inputs = test::constantInputs(8, 4, glm::vec3(0.5f));
  test::setHistory(inputs, glm::vec3(0.25f), 4.0f);
  const auto isKept = [&](const char* rule, float historyX) {
    inputs.motion.at(1, 1)[0] = 1.5f - historyX; // q = 1½ − v
    Settings settings = with({});
    applyAssignment(settings, std::string("validate.offScreen=") + rule);
    return valueOf(inputs, settings, IntermediateId::rejectReason).x == 0.0f;
  };
  for (const char* rule : {"keep", "reject", "margin", "oneSided"}) EXPECT_TRUE(isKept(rule, 4.0f)) << rule;
  EXPECT_TRUE(isKept("keep", -3.0f) && isKept("keep", 11.0f));
  EXPECT_FALSE(isKept("reject", -0.125f) || isKept("reject", 8.125f));
  EXPECT_TRUE(isKept("reject", 0.25f) && isKept("reject", 7.75f));
  EXPECT_FALSE(isKept("margin", 0.25f) || isKept("margin", 7.75f)) << "half a pixel earlier";
  EXPECT_TRUE(isKept("margin", 0.5f) && isKept("margin", 7.5f));
  EXPECT_TRUE(isKept("oneSided", 8.125f)) << "the right edge is not tested: D9";
}

// ---- History filters, manual §6

using Kernel = std::array<double, 4>;

/// Σ w c of four columns of a history that is the same in every row, read at `fraction` past the second.
float readAt(float fraction, const Settings& settings, const std::array<float, 4>& columns) {
  Inputs inputs = test::constantInputs(4, 4, glm::vec3(0.5f));
  test::setHistory(inputs, glm::vec3(0.0f), 4.0f);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      test::setColor(inputs.historyColor, x, y, glm::vec3(columns[static_cast<std::size_t>(x)]));
  inputs.motion.at(1, 1)[0] = -fraction;
  return valueOf(inputs, settings, IntermediateId::historyRaw).x;
}

double sum(const Kernel& weights, const std::array<float, 4>& columns) {
  double total = 0.0, weight = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    total += weights[k] * static_cast<double>(columns[k]);
    weight += weights[k];
  }
  return total / weight;
}

// Techniques: 6.0, 6.1, 6.2, 6.3, 6.5, 6.6, 6.7, 18.8.
TEST(TechniqueEffect, HistoryFiltersHaveTheirKernels) {
  const std::array<float, 4> columns{0.75f, 1.0f, 0.25f, 2.0f};
  const auto cubic = [](double f, double c) {
    return Kernel{-c * f * f * f + 2 * c * f * f - c * f, (2 - c) * f * f * f - (3 - c) * f * f + 1,
                  -(2 - c) * f * f * f + (3 - 2 * c) * f * f + c * f, c * f * f * f - c * f * f};
  };
  const auto mitchell = [](double distance) { // B = C = ⅓
    const double x = std::abs(distance);
    if (x < 1) return (7 * x * x * x - 12 * x * x + 16.0 / 3) / 6;
    return x < 2 ? (-7.0 / 3 * x * x * x + 12 * x * x - 20 * x + 32.0 / 3) / 6 : 0.0;
  };
  const auto lanczos = [](double x) { return (x * x - 1) * std::pow(x * x - 4, 3) / 64; };
  for (const float fraction : {0.125f, 0.25f, 0.75f}) {
    const double f = static_cast<double>(fraction);
    const auto of = [&](const auto& kernel) {
      return Kernel{kernel(1 + f), kernel(f), kernel(1 - f), kernel(2 - f)};
    };
    EXPECT_EQ(readAt(fraction, with({"history.filter=point"}), columns), columns[f < 0.5 ? 1 : 2]);
    EXPECT_NEAR(readAt(fraction, with({"history.filter=bilinear"}), columns), sum({0, 1 - f, f, 0}, columns),
                1e-6);
    EXPECT_NEAR(readAt(fraction, with({"history.filter=catmullRom16"}), columns), sum(cubic(f, 0.5), columns),
                1e-6);
    EXPECT_NEAR(readAt(fraction, with({"history.filter=catmullRom9"}), columns), sum(cubic(f, 0.5), columns),
                1e-6);
    for (const char* sharpness : {"history.sharpness=0.35", "history.sharpness=0.8"}) {
      const double c = std::stod(std::string(sharpness).substr(18));
      EXPECT_NEAR(readAt(fraction, with({"history.filter=cubic", sharpness}), columns),
                  sum(cubic(f, c), columns), 1e-6);
    }
    EXPECT_NEAR(readAt(fraction, with({"history.filter=mitchell"}), columns), sum(of(mitchell), columns),
                1e-6);
    EXPECT_NEAR(readAt(fraction, with({"history.filter=lanczos"}), columns), sum(of(lanczos), columns), 1e-6);
  }
}

// Techniques: 6.9, 6.10.
TEST(TechniqueEffect, DeringingKeepsHistoryWithinWhatItWasMadeFrom) {
  const std::array<float, 4> step{1.0f, 1.0f, 1.0f, 0.0f};
  for (const char* filter :
       {"history.filter=catmullRom16", "history.filter=cubic", "history.filter=lanczos"}) {
    EXPECT_GT(readAt(0.5f, with({filter}), step), 1.01f) << filter;
    EXPECT_EQ(readAt(0.5f, with({filter, "history.dering=on"}), step), 1.0f) << filter;
  }
  EXPECT_EQ(readAt(0.5f, with({"history.filter=catmullRom16"}), {2.0f, 0.0f, 0.0f, 2.0f}), 0.0f)
      << "6.10: never below 0";
}

// ---- Current filters, manual §7

/// 3×3 texels of which only the named ones are not black.
Inputs grays(const std::array<float, 9>& values) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.0f));
  test::setGrays(inputs.color, values);
  return inputs;
}

float filtered(const Inputs& inputs, const Settings& settings) {
  return valueOf(inputs, settings, IntermediateId::currentFiltered).x;
}

// Techniques: 7.2, 7.3.
TEST(TechniqueEffect, LumaWeightsMakeBrightSamplesCountLess) {
  const Inputs bright = grays({0, 0, 0, 0, 1, 0, 0, 0, 0});
  EXPECT_FLOAT_EQ(filtered(bright, with({"current.filter=tent"})), 4.0f / 16.0f);
  // The bright one weighs 4/(1 + 1), the others 2·4 + 1·4.
  EXPECT_FLOAT_EQ(filtered(bright, with({"current.filter=tent", "current.lumaWeighted=on"})), 2.0f / 14.0f);
  EXPECT_FLOAT_EQ(filtered(bright, with({"current.filter=box"})), 1.0f / 9.0f);
  EXPECT_FLOAT_EQ(filtered(bright, with({"current.filter=box", "current.lumaWeighted=on"})), 0.5f / 8.5f);
}

// Techniques: 7.4.
TEST(TechniqueEffect, DistancesAreThoseOfTheJitteredSamplesUnlessToldOtherwise) {
  Inputs inputs = grays({0, 0, 0, 0, 1, 2, 0, 0, 0});
  for (const char* filter :
       {"current.filter=gaussian", "current.filter=mitchell", "current.filter=lanczos"}) {
    inputs.jitterPx = {};
    const float still = filtered(inputs, with({filter, "current.jitterAware=on"}));
    inputs.jitterPx = {0.25f, 0.0f};
    EXPECT_EQ(filtered(inputs, with({filter, "current.jitterAware=off"})), still) << filter;
    EXPECT_GT(filtered(inputs, with({filter, "current.jitterAware=on"})), still)
        << filter << ": the center landed nearer to the brighter one";
  }
}

// Techniques: 7.6.
TEST(TechniqueEffect, DeringingKeepsTheFilteredColorWithinTheNine) {
  Inputs inputs = grays({0, 0, 1, 0, 0, 1, 0, 0, 1});
  inputs.jitterPx = {-0.25f, 0.0f};
  for (const char* filter : {"current.filter=catmullRom", "current.filter=lanczos"}) {
    inputs.color.at(1, 1)[0] = inputs.color.at(1, 0)[0] = inputs.color.at(1, 2)[0] = 0.0f;
    test::setGrays(inputs.color, {1, 1, 0, 1, 1, 0, 1, 1, 0});
    EXPECT_GT(filtered(inputs, with({filter, "current.dering=off"})), 1.0f) << filter;
    EXPECT_EQ(filtered(inputs, with({filter, "current.dering=on"})), 1.0f) << filter;
  }
}

// ---- The space of the box, manual §9

// Techniques: 9.1, 9.2, 9.4, 9.5.
TEST(TechniqueEffect, AxesOfTheBoxAreThoseOfTheSpace) {
  const float r = 0.75f, g = 0.25f, b = 0.5f;
  const Inputs inputs = test::constantInputs(3, 3, {r, g, b});
  const auto expectMean = [&](const char* space, const glm::vec3& wanted) {
    const glm::vec3 mean = valueOf(inputs, with({space}), IntermediateId::neighborhoodMean);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], wanted[k], 1e-6f) << space << ", channel " << k;
  };
  const float y = r / 4 + g / 2 + b / 4, co = (r - b) / 2, cg = -r / 4 + g / 2 - b / 4;
  expectMean("space.color=rgb", {r, g, b});
  expectMean("space.color=yCoCg", {y, co, cg});
  expectMean("space.color=yCoCgLifting", {y, 2 * co, 2 * cg});
  const float luma = 0.2126f * r + 0.7152f * g + 0.0722f * b;
  expectMean("space.color=yCbCr", {luma, (b - luma) / 1.8556f, (r - luma) / 1.5748f});
  expectMean("space.tone=reinhardLuma", glm::vec3(r, g, b) / (1 + luma));
  expectMean("space.tone=reinhardChannel", {r / (1 + r), g / (1 + g), b / (1 + b)});
  expectMean("space.tone=maxChannel", glm::vec3(r, g, b) / (1 + r));
  expectMean("space.tone=logarithm", {std::log2(1 + r), std::log2(1 + g), std::log2(1 + b)});
}

// ---- Neighborhoods, boxes: manual §8, §10

struct Range {
  float low, high;
  bool operator==(const Range&) const = default;
};

Range boxOf(const Inputs& inputs, const Settings& settings) {
  return {valueOf(inputs, settings, IntermediateId::boxMin).x,
          valueOf(inputs, settings, IntermediateId::boxMax).x};
}

// Techniques: 8.1, 8.2, 8.3, 8.4, 8.6.
TEST(TechniqueEffect, ShapesTakeTheirOwnSamples) {
  Inputs inputs = grays({0.5f, 8, 0.5f, 2, 3, 4, 16, 1, 0.5f}); // corners ½ and 16, edges 8, 2, 4 and 1
  const Range cross{1, 8}, x{0.5f, 16}, all{0.5f, 16};
  EXPECT_EQ(boxOf(inputs, with({"neighborhood.shape=cross"})), cross);
  EXPECT_EQ(boxOf(inputs, with({"neighborhood.shape=x"})), x);
  EXPECT_EQ(boxOf(inputs, with({"neighborhood.shape=square3x3"})), all);
  EXPECT_EQ(boxOf(inputs, with({"neighborhood.shape=rounded"})), Range({0.75f, 12})) << "½(½ + 1), ½(16 + 8)";
  inputs.frame = 4;
  EXPECT_EQ(boxOf(inputs, with({"neighborhood.shape=alternate"})), cross);
  inputs.frame = 5;
  EXPECT_EQ(boxOf(inputs, with({"neighborhood.shape=alternate"})), x);
  const Inputs edges = grays({5, 8, 5, 2, 5, 4, 5, 1, 5});
  EXPECT_EQ(boxOf(edges, with({"neighborhood.shape=x"})), Range({5, 5})) << "edges are none of its samples";
}

// Techniques: 10.1, 10.2, 10.3, 10.4.
TEST(TechniqueEffect, BoxesAreMadeAsTheirNamesSay) {
  const Inputs inputs = grays({0, 0, 0, 0, 1, 1, 0, 1, 0}); // three of nine: μ = ⅓, σ = √(3·6)/9
  const float mean = 1.0f / 3, deviation = std::sqrt(18.0f) / 9;
  EXPECT_EQ(boxOf(inputs, with({"neighborhood.box=minMax"})), Range({0, 1}));
  const Range variance = boxOf(inputs, with({"neighborhood.box=variance", "neighborhood.gamma=0.5"}));
  EXPECT_NEAR(variance.low, mean - 0.5f * deviation, 1e-6f);
  EXPECT_NEAR(variance.high, mean + 0.5f * deviation, 1e-6f);
  const Range both = boxOf(inputs, with({"neighborhood.box=intersection", "neighborhood.gamma=1"}));
  EXPECT_EQ(both.low, 0.0f) << "μ − σ lies below every sample";
  EXPECT_NEAR(both.high, mean + deviation, 1e-6f);
  const Range grown =
      boxOf(inputs,
            with({"neighborhood.box=variance", "neighborhood.gamma=0.5", "neighborhood.includeFiltered=on"}));
  EXPECT_EQ(grown.high, 1.0f) << "the filtered color, here the sample itself";
  EXPECT_EQ(grown.low, variance.low);
}

// Techniques: 10.7.
TEST(TechniqueEffect, WeightedMomentsFollowTheirWeights) {
  const Inputs inputs = grays({0, 0, 0, 0, 0, 0, 0, 0, 3}); // one corner of 3
  const auto mean = [&](const char* weights) {
    return valueOf(inputs, with({weights}), IntermediateId::neighborhoodMean).x;
  };
  EXPECT_NEAR(mean("neighborhood.weights=equal"), 3.0 / 9.0, 1e-6);
  EXPECT_NEAR(mean("neighborhood.weights=luma"), 3.0 * 0.25 / 8.25, 1e-6) << "1/(1 + 3)";
  const double edge = std::exp(-0.75), corner = std::exp(-1.5);
  EXPECT_NEAR(mean("neighborhood.weights=distance"), 3.0 * corner / (1 + 4 * edge + 4 * corner), 1e-6);
}

// Techniques: 10.8, 10.11, 17.5.
TEST(TechniqueEffect, GammaFollowsMotionHeightAndContrast) {
  Inputs inputs = grays({0, 0, 0, 0, 1, 1, 0, 1, 0});
  test::setHistory(inputs, glm::vec3(0.25f), 4.0f);
  const auto gamma = [&](std::initializer_list<const char*> more) {
    Settings settings = with({"neighborhood.box=variance", "neighborhood.gamma=1"});
    for (const char* assignment : more) applyAssignment(settings, assignment);
    return valueOf(inputs, settings, IntermediateId::boxGamma).x;
  };
  EXPECT_EQ(gamma({}), 1.0f);
  inputs.motion.at(1, 1)[0] = 64.0f; // half of the full speed: ¾ + ¼·(½)²
  EXPECT_FLOAT_EQ(
      gamma({"neighborhood.motionGamma=on", "neighborhood.gammaMoving=0.75", "neighborhood.gammaSpeed=128"}),
      0.8125f);
  EXPECT_FLOAT_EQ(
      gamma({"neighborhood.motionGamma=on", "neighborhood.gammaMoving=0.5", "neighborhood.gammaSpeed=32"}),
      0.5f);
  EXPECT_EQ(gamma({"neighborhood.motionGamma=off", "neighborhood.gammaMoving=0.5"}), 1.0f);
  inputs.motion.at(1, 1)[0] = 0.0f;
  EXPECT_EQ(gamma({"neighborhood.contrastGamma=off"}), 1.0f);
  EXPECT_FLOAT_EQ(gamma({"neighborhood.contrastGamma=on", "neighborhood.contrastGrowth=2"}), 3.0f)
      << "lumas 1 and about 0.25: more than 0.55 of the larger, so all of the growth";
}

// ---- Rectification, manual §11

/// Samples whose mean is their middle in each channel: 0 or 1 around ½, so μ ± γσ is symmetric about ½.
struct Rectified {
  glm::vec3 value;
  float strength;
};

Rectified rectified(const glm::vec3& history, std::initializer_list<const char*> assignments,
                    float speed = 0.0f) {
  Inputs inputs = grays({0, 1, 0, 1, 0.5f, 0, 1, 0, 1}); // four of each, and ½
  test::setHistory(inputs, history, 4.0f);
  inputs.motion.at(1, 1)[0] = speed;
  const PixelRecord record = resolvePixel(inputs, with(assignments), 1, 1);
  return {glm::vec3(at(record, IntermediateId::historyRectified)),
          at(record, IntermediateId::rectifyStrength).x};
}

// Techniques: 11.0, 11.1, 11.2, 11.3, 11.5.
TEST(TechniqueEffect, MethodsEndWhereTheirFormulasSay) {
  // Box 0…1 of gray samples around ½; history (2½, ½, ¼) is 2 from the middle in red.
  const glm::vec3 history(2.5f, 0.5f, 0.25f);
  const auto of = [&](const char* method) {
    return rectified(history, {method, "neighborhood.box=minMax"}).value;
  };
  const auto expectNear = [](const glm::vec3& value, const glm::vec3& wanted, const char* method) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(value[k], wanted[k], 1e-6f) << method << ", channel " << k;
  };
  expectNear(of("rectify.method=none"), history, "none");
  expectNear(of("rectify.method=clamp"), {1.0f, 0.5f, 0.25f}, "clamp");
  // To the middle: m = 2/½ = 4, so a quarter of the way is left.
  const glm::vec3 quarter(1.0f, 0.5f, 0.4375f);
  expectNear(of("rectify.method=clipToCenter"), quarter, "clipToCenter");
  expectNear(of("rectify.method=clipToFiltered"), quarter, "clipToFiltered"); // the filtered color is ½ too
  expectNear(of("rectify.method=shrinkAxes"), quarter, "shrinkAxes");         // the mean is ½
  expectNear(of("rectify.method=clampForget"), {1.0f, 0.5f, 0.25f}, "clampForget");
  expectNear(of("rectify.method=select"), glm::vec3(1.0f),
             "select"); // |h − 1|² = 3.06 is the least of the grays'
}

// Manual 10.5: clamped to the samples' box, then clipped to the center of the variance box.
// Techniques: 10.5.
TEST(TechniqueEffect, ClampThenClipGoesBothWaysInTurn) {
  const float deviation = std::sqrt(8.0f * 0.25f / 9.0f); // eight samples ½ from the mean
  const glm::vec3 value =
      rectified({2.5f, 0.5f, 0.25f},
                {"rectify.method=clampThenClip", "neighborhood.box=variance", "neighborhood.gamma=0.5"})
          .value;
  // (1, ½, ¼) is ½ from the center in red, where the wall is half a deviation away.
  const float left = 0.5f * deviation / 0.5f;
  EXPECT_NEAR(value.x, 0.5f + 0.5f * left, 1e-6f);
  EXPECT_NEAR(value.z, 0.5f - 0.25f * left, 1e-6f) << "blue goes on along the way to the center";
  const glm::vec3 clipped =
      rectified({2.5f, 0.5f, 0.25f},
                {"rectify.method=clipToCenter", "neighborhood.box=variance", "neighborhood.gamma=0.5"})
          .value;
  EXPECT_LT(value.z, clipped.z - 0.05f) << "from where it was, the way is another";
}

// Manual 11.4: the hit of the ray to the current color, unless it is farther than T.
// Techniques: 11.4.
TEST(TechniqueEffect, TheRayToTheCurrentColorCountsHitsNearerThanItsLimit) {
  // From 2½ to the current ½ the box's wall at 1 is three quarters of the way.
  const glm::vec3 hit =
      rectified(glm::vec3(2.5f), {"rectify.method=rayToCurrent", "rectify.maxSteps=1"}).value;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(hit[k], 1.0f, 1e-6f);
  // Beside the box: red and green 2½, the current color ½; blue runs out of it. All slabs are left at ¾.
  Inputs inputs = grays({0, 1, 0, 1, 0.5f, 0, 1, 0, 1});
  test::setColor(inputs.color, 1, 1, glm::vec3(0.5f));
  test::setHistory(inputs, glm::vec3(9.0f, 0.5f, 0.5f), 4.0f);
  const glm::vec3 far = valueOf(inputs, with({"rectify.method=rayToCurrent", "rectify.maxSteps=100"}),
                                IntermediateId::historyRectified);
  EXPECT_NEAR(far.x, 1.0f, 1e-5f);
  EXPECT_NEAR(far.y, 0.5f, 1e-6f);
}

// Manual 11.6, 17.2: κ = κmin + (1 − κmin)·min(1, (‖v‖/θ)²).
// Techniques: 11.6, 17.1, 17.2.
TEST(TechniqueEffect, AtRestOnlyAPartOfTheCorrectionIsApplied) {
  const auto at = [](float speed) {
    return rectified(
        glm::vec3(2.5f),
        {"rectify.method=clamp", "rectify.relaxAtRest=on", "rectify.minStrength=0.25", "rectify.restSpeed=2"},
        speed);
  };
  EXPECT_EQ(at(0.0f).strength, 0.25f);
  EXPECT_EQ(at(0.0f).value, glm::vec3(2.5f - 0.25f * 1.5f));
  EXPECT_EQ(at(1.0f).strength, 0.25f + 0.75f * 0.25f);
  EXPECT_EQ(at(2.0f).strength, 1.0f);
  EXPECT_EQ(at(8.0f).value, glm::vec3(1.0f));
  EXPECT_EQ(
      rectified(glm::vec3(2.5f), {"rectify.method=clamp", "rectify.relaxAtRest=on", "rectify.minStrength=0"})
          .value,
      glm::vec3(2.5f))
      << "17.1: none of it";
  EXPECT_EQ(rectified(glm::vec3(2.5f), {"rectify.method=clamp", "rectify.relaxAtRest=off"}).strength, 1.0f);
}

// ---- Validation and weight, manual §12, §13, §15

// Techniques: 12.6.
TEST(TechniqueEffect, WhatIsFasterThanTheLimitHasNoHistory) {
  Inputs inputs = test::constantInputs(64, 4, glm::vec3(0.5f));
  test::setHistory(inputs, glm::vec3(0.25f), 4.0f);
  const auto reason = [&](const char* test, float speed) {
    inputs.motion.at(1, 1)[0] = -speed;
    return valueOf(inputs, with({test, "validate.speedLimit=20"}), IntermediateId::rejectReason).x;
  };
  EXPECT_EQ(reason("validate.speed=on", 20.0f), 0.0f);
  EXPECT_EQ(reason("validate.speed=on", 20.5f), 5.0f);
  EXPECT_EQ(reason("validate.speed=off", 20.5f), 0.0f);
}

// Manual §26, D19: the luma of c/(1 + max c).
// Techniques: D19.
TEST(TechniqueEffect, InverseLumaAsPrintedHardlySuppressesFireflies) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(100.0f));
  test::setHistory(inputs, glm::vec3(0.0f), 4.0f);
  const auto weight = [&](const char* tone) {
    return valueOf(inputs, with({tone}), IntermediateId::toneWeightCurrent).x;
  };
  EXPECT_NEAR(weight("blend.tone=luma"), 1.0 / 101.0, 1e-7);
  EXPECT_NEAR(weight("blend.tone=lumaAsPrinted"), 1.0 / (1.0 + 100.0 / 101.0), 1e-6) << "never below a half";
  EXPECT_EQ(weight("blend.tone=none"), 1.0f);
}

// Manual 13.11, §26, D17: 0.1·(1 − 1/1.001)² of a change from 0 to 1, and a floor of α that ends it.
// Techniques: D17.
TEST(TechniqueEffect, LumaDampsAlphaToNothingWithoutAFloor) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(1.0f));
  test::setHistory(inputs, glm::vec3(0.0f), 9.0f);
  const auto alpha = [&](const char* floor) {
    return valueOf(inputs, with({"weight.source=historyLength", "weight.lumaFlicker=on", floor}),
                   IntermediateId::alpha)
        .x;
  };
  EXPECT_NEAR(alpha("weight.minimum=0"), 0.1 * std::pow(1.0 - 1.0 / 1.001, 2), 1e-9);
  EXPECT_EQ(alpha("weight.minimum=0.05"), 0.05f);
}

// Techniques: 5.2, 5.5, 5.6, 7.8.
TEST(TechniqueEffect, WithoutHistoryTheFilteredOrABlurredColorIsShown) {
  const Inputs inputs = grays({1, 0, 1, 0, 2, 0, 1, 0, 1}); // diagonals 1, center 2
  EXPECT_EQ(valueOf(inputs, with({"blend.restart=filtered"}), IntermediateId::resolved).x, 2.0f);
  EXPECT_FLOAT_EQ(valueOf(inputs, with({"blend.restart=blurred"}), IntermediateId::resolved).x, 6.0f / 5.0f);
  EXPECT_EQ(valueOf(inputs, with({"blend.restart=filtered"}), IntermediateId::historyLength).x, 1.0f);
}

} // namespace
} // namespace taa
