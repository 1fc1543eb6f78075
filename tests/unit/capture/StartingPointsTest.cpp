// What is known of engines, written out by hand, and each way of jittering worked out by its own formula.
#include "core/base/Error.h"
#include "core/capture/format/Conventions.h"

#include <gtest/gtest.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {
namespace {

using Facts = std::set<std::string>;

/// What differs from this program's conventions, but for those of matrices.
const std::map<std::string, Facts>& facts() {
  static const std::map<std::string, Facts> kFacts = {
      {"taa-inspector", {"motion.notWritten=65504", "motion.fallback=noPrevious"}},
      {"unreal",
       {"motion.unit=ndc", "motion.yAxis=up", "motion.encoding=unreal", "motion.notWritten=0",
        "color.preExposed=on"}},
      {"unity", {"motion.unit=uv", "jitter.yAxis=up"}},
      {"godot", {"motion.direction=previousMinusCurrent", "motion.unit=uv", "jitter.unit=ndc"}},
      {"bevy", {"motion.unit=uv", "jitter.meaning=sample"}},
      {"three",
       {"motion.unit=ndc", "motion.yAxis=up", "jitter.meaning=sample", "depth.reversed=off",
        "depth.nothing=1"}},
      {"babylon",
       {"motion.direction=previousMinusCurrent", "motion.unit=uv", "motion.yAxis=up", "jitter.unit=ndc",
        "jitter.yAxis=up", "jitter.delay=1", "depth.kind=planar", "depth.scale=-1", "depth.nothing=0",
        "depth.jittered=off"}},
      {"fsr", {"motion.direction=previousMinusCurrent", "depth.reversed=off", "color.preExposed=on"}},
      {"xess", {"motion.direction=previousMinusCurrent", "depth.reversed=off"}},
      {"streamline", {"motion.direction=previousMinusCurrent", "motion.unit=uv", "depth.reversed=off"}},
      {"metalfx", {"motion.direction=previousMinusCurrent", "jitter.meaning=sample", "depth.reversed=off"}},
      {"blender",
       {"motion.direction=previousMinusCurrent", "motion.yAxis=up", "motion.whereNothing=camera",
        "jitter.meaning=sample", "depth.kind=planar", "depth.nothing=1e+10"}},
  };
  return kFacts;
}

constexpr double kWidth = 480.0, kHeight = 270.0;

/// By how many pixels, y down, these conventions say that a stated jitter moves content.
glm::dvec2 contentPx(const JitterConventions& c, glm::dvec2 stated) {
  glm::dvec2 px = stated;
  if (c.unit == ScreenUnit::Uv) px *= glm::dvec2(kWidth, kHeight);
  if (c.unit == ScreenUnit::Ndc) px *= glm::dvec2(kWidth, kHeight) / 2.0;
  if (c.yAxis == VerticalAxis::Up) px.y = -px.y;
  return c.meaning == JitterMeaning::Sample ? -px : px;
}

/// By how many pixels, y down, a place before the camera is elsewhere with `jittered`; device y is up.
glm::dvec2 movedPx(const glm::dmat4& projection, const glm::dmat4& jittered, double z) {
  const glm::dvec4 place(0.3, -0.2, z, 1.0);
  const glm::dvec4 a = projection * place, b = jittered * place;
  return {(b.x / b.w - a.x / a.w) * kWidth / 2.0, -(b.y / b.w - a.y / a.w) * kHeight / 2.0};
}

/// Columns; z of what is in front is `sign`, and w is its distance.
glm::dmat4 perspective(double sign) {
  glm::dmat4 projection(0.0);
  projection[0][0] = 1.2;
  projection[1][1] = 2.1;
  projection[2][3] = sign;
  projection[3][2] = 0.1;
  return projection;
}

glm::dmat4 translation(double x, double y) {
  glm::dmat4 matrix(1.0);
  matrix[3][0] = x;
  matrix[3][1] = y;
  return matrix;
}

void expectJitter(const char* id, glm::dvec2 stated, glm::dvec2 moved) {
  const glm::dvec2 said = contentPx(startingPoint(id).conventions.jitter, stated);
  EXPECT_NEAR(said.x, moved.x, 1e-9) << id; // of numbers near 1, in double
  EXPECT_NEAR(said.y, moved.y, 1e-9) << id;
}

const glm::dvec2 kJitter(0.25, -0.375);

} // namespace

TEST(StartingPoints, AreTwelveInTheirOrder) {
  std::vector<std::string_view> ids;
  for (const StartingPoint& point : startingPoints()) {
    ids.push_back(point.id);
    EXPECT_FALSE(point.label.empty() || point.source.empty()) << point.id;
    EXPECT_TRUE(point.notes.ends_with('.')) << point.id;
  }
  EXPECT_EQ(ids,
            (std::vector<std::string_view>{"taa-inspector", "unreal", "unity", "godot", "bevy", "three",
                                           "babylon", "fsr", "xess", "streamline", "metalfx", "blender"}));
}

TEST(StartingPoints, SayWhatIsKnown) {
  for (const StartingPoint& point : startingPoints()) {
    Facts said;
    for (const std::string& assignment : differences(point.conventions, {}))
      if (!assignment.starts_with("matrices.")) said.insert(assignment);
    EXPECT_EQ(said, facts().at(std::string(point.id))) << point.id;
  }
}

TEST(StartingPoints, HaveTheMatricesOfTheirLibraries) {
  const auto matricesOf = [](const char* id) {
    Facts said;
    for (const std::string& assignment : differences(startingPoint(id).conventions, {}))
      if (assignment.starts_with("matrices.")) said.insert(assignment.substr(9));
    return said;
  };
  EXPECT_EQ(matricesOf("taa-inspector"), Facts());
  EXPECT_EQ(matricesOf("unreal"), (Facts{"vectors=row", "forward=positiveZ", "metersPerUnit=0.01"}));
  EXPECT_EQ(matricesOf("unity"), (Facts{"order=columnMajor", "clipZ=minusOneToOne"}));
  EXPECT_EQ(matricesOf("godot"), (Facts{"order=columnMajor", "clipZ=minusOneToOne"}));
  EXPECT_EQ(matricesOf("bevy"), (Facts{"order=columnMajor"}));
  EXPECT_EQ(matricesOf("three"), (Facts{"clipZ=minusOneToOne"}));
  EXPECT_EQ(matricesOf("babylon"), (Facts{"vectors=row", "clipZ=minusOneToOne"}));
  EXPECT_EQ(matricesOf("blender"), (Facts{"clipZ=minusOneToOne"}));
}

TEST(StartingPoints, AreConsistent) {
  for (const StartingPoint& point : startingPoints()) {
    EXPECT_EQ(contradiction(point.conventions), "") << point.id;
    EXPECT_EQ(normalized(point.conventions), point.conventions) << point.id;
  }
}

TEST(StartingPoints, AreRefusedByTheListOfThem) {
  try {
    startingPoint("unrael");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "there is no starting point \"unrael\": give one of taa-inspector, unreal, unity, godot, bevy, "
              "three, babylon, fsr, xess, streamline, metalfx, blender");
  }
}

// T(2jx/W, −2jy/H)·P, of this program and of FSR.
TEST(StartingPoints, TranslationsMoveContent) {
  const glm::dmat4 projection = perspective(-1.0);
  const glm::dmat4 jittered = translation(2.0 * kJitter.x / kWidth, -2.0 * kJitter.y / kHeight) * projection;
  const glm::dvec2 moved = movedPx(projection, jittered, -3.0);
  EXPECT_NEAR(moved.x, kJitter.x, 1e-9);
  expectJitter("taa-inspector", kJitter, moved);
  expectJitter("fsr", kJitter, moved);
}

// Both components are added: T(2jx/W, 2jy/H)·P.
TEST(StartingPoints, UnityJittersWithYUp) {
  const glm::dmat4 projection = perspective(-1.0);
  const glm::dmat4 jittered = translation(2.0 * kJitter.x / kWidth, 2.0 * kJitter.y / kHeight) * projection;
  expectJitter("unity", kJitter, movedPx(projection, jittered, -3.0));
}

// P[2][0] += 2jx/W, P[2][1] −= 2jy/H with w = +z: of XeSS and of Unreal.
TEST(StartingPoints, TheThirdRowMovesContentWhereWIsPlusZ) {
  const glm::dmat4 projection = perspective(1.0);
  glm::dmat4 jittered = projection;
  jittered[2][0] += 2.0 * kJitter.x / kWidth;
  jittered[2][1] -= 2.0 * kJitter.y / kHeight;
  const glm::dvec2 moved = movedPx(projection, jittered, 3.0);
  expectJitter("xess", kJitter, moved);
  expectJitter("unreal", kJitter, moved);
}

// offset · (2, −2)/size is added to the third column, where w = −z.
TEST(StartingPoints, BevyMovesTheSample) {
  const glm::dmat4 projection = perspective(-1.0);
  glm::dmat4 jittered = projection;
  jittered[2][0] += 2.0 * kJitter.x / kWidth;
  jittered[2][1] -= 2.0 * kJitter.y / kHeight;
  expectJitter("bevy", kJitter, movedPx(projection, jittered, -3.0));
}

// Added in device coordinates after y was turned down for Vulkan.
TEST(StartingPoints, GodotJittersAfterTheCorrection) {
  const glm::dvec2 stated = 2.0 * kJitter / glm::dvec2(kWidth, kHeight);
  glm::dmat4 correction(1.0);
  correction[1][1] = -1.0;
  const glm::dmat4 projection = correction * perspective(-1.0);
  const glm::dvec2 moved = movedPx(projection, translation(stated.x, stated.y) * projection, -3.0);
  expectJitter("godot", stated, {moved.x, -moved.y}); // movedPx has y of device coordinates up
}

// READMEs of the measured sequences: the pixel at c shows the picture without jitter at c + j, y down.
TEST(StartingPoints, ThreeAndBlenderSampleAtPlusJitter) {
  for (const char* id : {"three", "blender", "metalfx"}) expectJitter(id, kJitter, -kJitter);
}

// In clip units, y up.
TEST(StartingPoints, BabylonMovesContentInClipUnits) {
  const glm::dmat4 projection = perspective(-1.0);
  const glm::dvec2 stated(0.002, -0.003);
  expectJitter("babylon", stated, movedPx(projection, translation(stated.x, stated.y) * projection, -3.0));
}

} // namespace taa::capture
