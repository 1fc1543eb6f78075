// Shadows of the sun against the geometry of rays: what stops a ray from a wall to the sun's disk.
#include "core/measure/References.h"
#include "core/render/passes/SceneRenderer.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/FogTruth.h"
#include "tests/support/frames/SmallScene.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 160, kHeight = 90;
constexpr double kBoardPlace = 2.0; // m before the wall
const glm::dvec3 kEyeAt(0.0, 0.0, 10.0);
const glm::dvec3 kToSun = glm::normalize(glm::dvec3(1.2, 0.8, 1.0));
const glm::dvec2 kBoardMiddle(1.0, 0.5), kBoardHalf(1.5, 1.0);

/// A wall at z = 0 with a board before it, lit by nothing but the sun.
struct Stage {
  Scene scene = test::emptyScene();
  int board = 0;

  Stage() {
    scene.sky.sunEnabled = true;
    scene.sky.sunDirection = glm::vec3(kToSun);
    scene.sky.sunColor = glm::vec3(1.0f);
    scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0.0f);
    scene.shot.frames = 64;
    Material paint;
    paint.name = "paint";
    paint.roughness = 1.0f;
    paint.metallic = 0.0f;
    paint.doubleSided = true;
    scene.materials.push_back(paint);
    test::addQuad(scene, {0, 0, 0}, {16, 0, 0}, {0, 10, 0}, 1);
    board = test::addQuad(scene, {kBoardMiddle.x, kBoardMiddle.y, kBoardPlace}, {2 * kBoardHalf.x, 0, 0},
                          {0, 2 * kBoardHalf.y, 0}, 1);
    scene.bounds = {};
    scene.bounds.add({-8.0f, -5.0f, 0.0f});
    scene.bounds.add({8.0f, 5.0f, static_cast<float>(kBoardPlace)});
  }
};

/// How far inside the board a place of its plane is, m; less than 0 outside.
double insideBoard(const glm::dvec2& at) {
  const glm::dvec2 away = kBoardHalf - glm::abs(at - kBoardMiddle);
  return std::min(away.x, away.y);
}

/// Where the ray from a place of the wall along `direction` meets the plane of the board.
glm::dvec2 atBoard(const glm::dvec2& wall, const glm::dvec3& direction) {
  return wall + glm::dvec2(direction) * (kBoardPlace / direction.z);
}

/// The place of the wall that a pixel shows, or nothing: the board, or all but.
std::optional<glm::dvec2> wallAt(const glm::ivec2& pixel) {
  const glm::dvec3 ray = test::rayThrough(pixel, {kWidth, kHeight});
  const glm::dvec3 board = kEyeAt + ray * ((kBoardPlace - kEyeAt.z) / ray.z),
                   wall = kEyeAt - ray * (kEyeAt.z / ray.z);
  if (insideBoard(glm::dvec2(board)) > -0.1 || std::abs(wall.x) > 7.5 || std::abs(wall.y) > 4.5)
    return std::nullopt;
  return glm::dvec2(wall);
}

/// The share of a disk of this radius (°) that the board leaves, sampled finely.
double sunSeen(const glm::dvec2& wall, double radius) {
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), kToSun)),
                   up = glm::cross(kToSun, right);
  constexpr int kSide = 64;
  int all = 0, seen = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec2 disk = 2.0 * (glm::dvec2(x, y) + 0.5) / double(kSide) - 1.0;
      if (glm::dot(disk, disk) > 1.0) continue;
      const double aside = std::tan(glm::radians(radius));
      ++all;
      seen += insideBoard(atBoard(wall, kToSun + aside * (disk.x * right + disk.y * up))) < 0.0;
    }
  return static_cast<double>(seen) / all;
}

class ShadowTest : public test::GlTest {
 protected:
  static FrameRequest request(Shadows shadows) {
    FrameRequest request;
    request.camera = test::kEye;
    request.width = kWidth;
    request.height = kHeight;
    request.jitter.sequence = JitterSequence::None;
    request.inputs.precision = Precision::Full;
    request.inputs.shadows = shadows;
    request.inputs.sunRadius = 3.0f;
    return request;
  }
  static Image draw(SceneRenderer& renderer, const FrameRequest& request, int frame = 0) {
    FrameInputs inputs;
    renderer.draw(request, frame, inputs);
    return inputs.color.download();
  }
  static Image draw(const Scene& scene, const FrameRequest& request) {
    SceneRenderer renderer(std::make_shared<const Scene>(scene));
    return draw(renderer, request);
  }
  /// What of the sun's light reaches each pixel, mean of frames 0 to `frames` − 1.
  static std::vector<double> sunShares(const Scene& scene, const FrameRequest& request, int frames) {
    SceneRenderer renderer(std::make_shared<const Scene>(scene));
    FrameRequest without = request;
    without.inputs.shadows = Shadows::None;
    const Image full = draw(renderer, without);
    std::vector<double> shares(static_cast<std::size_t>(kWidth * kHeight), 0.0);
    for (int frame = 0; frame < frames; ++frame) {
      const Image color = draw(renderer, request, frame);
      for (std::size_t i = 0; i < shares.size(); ++i)
        shares[i] +=
            static_cast<double>(color.pixels[4 * i]) / static_cast<double>(full.pixels[4 * i]) / frames;
    }
    return shares;
  }
  template <class Check>
  static void forEachWallPixel(Check check) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        if (const auto wall = wallAt({x, y})) check(static_cast<std::size_t>(y * kWidth + x), *wall);
  }
};

bool equalColors(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

TEST_F(ShadowTest, OfAPointFallWhereTheBoardStopsTheRay) {
  const Stage stage;
  const std::vector<double> shares = sunShares(stage.scene, request(Shadows::Hard), 1);
  int lit = 0, dark = 0;
  forEachWallPixel([&](std::size_t pixel, const glm::dvec2& wall) {
    const double inside = insideBoard(atBoard(wall, kToSun));
    if (std::abs(inside) < 0.03) return; // two texels of 16 m / 2048, and what they are wide across the sun
    ASSERT_NEAR(shares[pixel], inside > 0.0 ? 0.0 : 1.0, 1e-6) << pixel << ", " << inside << " m inside";
    ++(inside > 0.0 ? dark : lit);
  });
  EXPECT_GT(dark, 150);
  EXPECT_GT(lit, 2000);
}

// Every wall and every floor lies in the map itself: nothing of them may darken itself, at any angle.
TEST_F(ShadowTest, NothingDarkensItself) {
  Stage stage;
  stage.scene.nodes[static_cast<std::size_t>(stage.board)].mesh = -1;
  for (const glm::vec3 toSun :
       {glm::vec3(0, 0, 1), glm::vec3(1, 1, 1), glm::vec3(5, 1, 1), glm::vec3(0, -9, 1)})
    for (const Shadows shadows : {Shadows::Hard, Shadows::Soft}) {
      stage.scene.sky.sunDirection = toSun;
      FrameRequest asked = request(shadows);
      const Image with = draw(stage.scene, asked);
      asked.inputs.shadows = Shadows::None;
      EXPECT_TRUE(equalColors(with, draw(stage.scene, asked)))
          << toSun.x << ", " << toSun.y << ", " << toSun.z;
    }
}

// A floor goes on behind the box that shadows are drawn of: a map that has nothing there is no shadow.
TEST_F(ShadowTest, WhatLiesBehindTheMapIsLit) {
  Stage stage;
  stage.scene.nodes[static_cast<std::size_t>(stage.board)].mesh = -1;
  stage.scene.sky.shadowed = {{-2.0f, -2.0f, 3.0f}, {2.0f, 2.0f, 4.0f}};
  for (const Shadows shadows : {Shadows::Hard, Shadows::Soft}) {
    const Image with = draw(stage.scene, request(shadows));
    EXPECT_TRUE(equalColors(with, draw(stage.scene, request(Shadows::None))));
  }
}

TEST_F(ShadowTest, OfTheDiskAreTheShareOfItThatIsSeen) {
  const Stage stage;
  FrameRequest asked = request(Shadows::Soft);
  asked.inputs.shadowRays = 8;
  asked.inputs.shadowNoise = InputNoise::White;
  const std::vector<double> shares = sunShares(stage.scene, asked, 48);
  int between = 0;
  double sum = 0.0;
  forEachWallPixel([&](std::size_t pixel, const glm::dvec2& wall) {
    const double seen = sunSeen(wall, 3.0);
    ASSERT_NEAR(shares[pixel], seen, 0.08) << wall.x << ", " << wall.y;
    between += seen > 0.05 && seen < 0.95;
    sum += shares[pixel] - seen;
  });
  EXPECT_GT(between, 60);
  EXPECT_LT(std::abs(sum / between), 0.02) << "neither darker nor brighter";
}

TEST_F(ShadowTest, AreAsWideAsTheSun) {
  const Stage stage;
  const auto between = [&](float radius) {
    FrameRequest asked = request(Shadows::Soft);
    asked.inputs.sunRadius = radius;
    asked.inputs.shadowRays = 16;
    asked.inputs.shadowNoise = InputNoise::None;
    const std::vector<double> shares = sunShares(stage.scene, asked, 1);
    int count = 0;
    forEachWallPixel(
        [&](std::size_t pixel, const glm::dvec2&) { count += shares[pixel] > 0.01 && shares[pixel] < 0.99; });
    return count;
  };
  const int narrow = between(2.0f), wide = between(4.0f);
  EXPECT_GT(narrow, 40);
  EXPECT_NEAR(static_cast<double>(wide) / narrow, 2.0, 0.35);
}

// One ray is stopped or not; in another frame, with another noise, another one is.
TEST_F(ShadowTest, OneRayIsNoiseWhoseMeanIsTheTruth) {
  const Stage stage;
  for (const InputNoise noise : {InputNoise::Gradient, InputNoise::Blue, InputNoise::White}) {
    FrameRequest asked = request(Shadows::Soft);
    asked.inputs.shadowNoise = noise;
    const std::vector<double> once = sunShares(stage.scene, asked, 1);
    const std::vector<double> often = sunShares(stage.scene, asked, 64);
    double error = 0.0, errorOfOne = 0.0;
    int between = 0;
    forEachWallPixel([&](std::size_t pixel, const glm::dvec2& wall) {
      EXPECT_TRUE(once[pixel] < 1e-6 || std::abs(once[pixel] - 1.0) < 1e-6) << once[pixel];
      const double seen = sunSeen(wall, 3.0);
      if (seen < 0.1 || seen > 0.9) return;
      ++between;
      error += std::abs(often[pixel] - seen);
      errorOfOne += std::abs(once[pixel] - seen);
    });
    EXPECT_LT(error, 0.3 * errorOfOne) << static_cast<int>(noise);
    EXPECT_LT(error / between, 0.1) << static_cast<int>(noise);
  }
}

TEST_F(ShadowTest, WhatIsCutOutCastsNone) {
  Stage stage;
  const Image solid = draw(stage.scene, request(Shadows::Hard));
  Material paper = stage.scene.materials[1];
  paper.alphaMode = AlphaMode::Mask;
  paper.alphaCutoff = 0.5f;
  for (const float alpha : {0.8f, 0.2f}) {
    paper.baseColor.w = alpha;
    stage.scene.materials.push_back(paper);
    stage.scene.meshes[1].primitives[0].material = static_cast<int>(stage.scene.materials.size()) - 1;
    const Image color = draw(stage.scene, request(Shadows::Hard));
    int differing = 0;
    forEachWallPixel([&](std::size_t pixel, const glm::dvec2&) {
      differing += color.pixels[4 * pixel] != solid.pixels[4 * pixel];
    });
    if (alpha > 0.5f)
      EXPECT_EQ(differing, 0);
    else
      EXPECT_GT(differing, 150);
  }
}

TEST_F(ShadowTest, WhatIsBlendedLetsAllLightThrough) {
  Stage stage;
  stage.scene.materials.push_back(stage.scene.materials[1]);
  stage.scene.materials[2].alphaMode = AlphaMode::Blend;
  stage.scene.meshes[1].primitives[0].material = 2;
  FrameRequest asked = request(Shadows::Hard);
  asked.inputs.blended = BlendedAs::Before;
  const Image with = draw(stage.scene, asked);
  asked.inputs.shadows = Shadows::None;
  const Image without = draw(stage.scene, asked);
  forEachWallPixel([&](std::size_t pixel, const glm::dvec2&) {
    ASSERT_EQ(with.pixels[4 * pixel], without.pixels[4 * pixel]) << pixel;
  });
}

TEST_F(ShadowTest, AreAsTheSceneWantsThemUnlessSomebodySaysElse) {
  Stage stage;
  const auto isAs = [&](Shadows asked, Shadows other) {
    return equalColors(draw(stage.scene, request(asked)), draw(stage.scene, request(other)));
  };
  EXPECT_TRUE(isAs(Shadows::AsScene, Shadows::None)) << "who says nothing wants none";
  stage.scene.sky.shadows = SunShadows::Hard;
  EXPECT_TRUE(isAs(Shadows::AsScene, Shadows::Hard));
  EXPECT_FALSE(isAs(Shadows::None, Shadows::AsScene));
  stage.scene.sky.shadows = SunShadows::Soft;
  EXPECT_TRUE(isAs(Shadows::AsScene, Shadows::Soft));
  EXPECT_FALSE(isAs(Shadows::Hard, Shadows::AsScene));
}

TEST_F(ShadowTest, ASceneWithoutASunHasNone) {
  Stage stage;
  stage.scene.sky.sunEnabled = false;
  EXPECT_TRUE(
      equalColors(draw(stage.scene, request(Shadows::Soft)), draw(stage.scene, request(Shadows::None))));
}

// The first directional light of a file stands for the sun.
TEST_F(ShadowTest, ALightOfAFileCastsTheSame) {
  Stage stage;
  const Image sunny = draw(stage.scene, request(Shadows::Hard));
  stage.scene.sky.sunEnabled = false;
  Node lamp;
  lamp.name = "lamp";
  lamp.hasMatrix = true;
  const glm::vec3 z(kToSun), x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), z));
  lamp.matrix = glm::mat4(glm::mat3(x, glm::cross(z, x), z));
  lamp.light = 0;
  stage.scene.nodes.push_back(lamp);
  Light light;
  light.node = static_cast<int>(stage.scene.nodes.size()) - 1;
  stage.scene.lights.push_back(light);
  const Image lit = draw(stage.scene, request(Shadows::Hard));
  int differing = 0;
  forEachWallPixel([&](std::size_t pixel, const glm::dvec2&) {
    differing += std::abs(lit.pixels[4 * pixel] - sunny.pixels[4 * pixel]) > 1e-4f;
  });
  EXPECT_LE(differing, 4) << "the light's direction is rounded otherwise";
}

TEST_F(ShadowTest, AreTheSameInAPartAndAtAnotherSampleOfThePixel) {
  const Stage stage;
  FrameRequest asked = request(Shadows::Soft);
  asked.jitterPx = glm::vec2(0.25f, -0.125f);
  SceneRenderer renderer(std::make_shared<const Scene>(stage.scene));
  const Image whole = draw(renderer, asked);
  FrameRequest other = asked;
  other.jitterPx = glm::vec2(-0.375f, 0.25f);
  EXPECT_FALSE(equalColors(draw(renderer, other), whole));
  EXPECT_TRUE(equalColors(draw(renderer, asked), whole));
  asked.part = gl::Rect{40, 30, 24, 16};
  const Image part = draw(renderer, asked);
  for (int y = 30; y < 46; ++y)
    for (int x = 40; x < 64; ++x) ASSERT_EQ(part.texel(x, y), whole.texel(x, y)) << x << ", " << y;
}

// Parts share a map, of what is drawn in their frame: neither of another frame, nor of what is hidden now.
TEST_F(ShadowTest, AreOfThisFrameAndOfWhatIsDrawn) {
  Stage stage;
  stage.scene.nodes[static_cast<std::size_t>(stage.board)].name = "board";
  stage.scene.nodes[static_cast<std::size_t>(stage.board)].visibleFrom = 0.1;
  SceneRenderer renderer(std::make_shared<const Scene>(stage.scene));
  FrameRequest shown = request(Shadows::Hard);
  shown.part = gl::Rect{0, 0, kWidth, kHeight}; // whole frames have a map of their own
  FrameRequest hidden = shown, soft = shown;
  soft.inputs.shadows = Shadows::Soft;
  hidden.filter.hidden = {"board"};
  const auto expectAsFresh = [&](const FrameRequest& asked, int frame, const char* what) {
    SceneRenderer fresh(std::make_shared<const Scene>(stage.scene));
    EXPECT_TRUE(equalColors(draw(renderer, asked, frame), draw(fresh, asked, frame))) << what;
  };
  expectAsFresh(shown, 0, "before the board is there");
  expectAsFresh(shown, 10, "with the board");
  expectAsFresh(hidden, 10, "hidden");
  expectAsFresh(shown, 10, "shown again");
  expectAsFresh(soft, 10, "soft");
  expectAsFresh(shown, 0, "back");
  SceneRenderer fresh(std::make_shared<const Scene>(stage.scene));
  EXPECT_FALSE(equalColors(draw(fresh, shown, 10), draw(fresh, hidden, 10)));
}

// A reference is the mean of its samples, each with rays of its own.
TEST_F(ShadowTest, OfAReferenceAreTheTruth) {
  const Stage stage;
  const FrameRequest asked = referenceRequest(request(Shadows::Soft));
  FrameRequest without = asked;
  without.inputs.shadows = Shadows::None;
  SceneRenderer renderer(std::make_shared<const Scene>(stage.scene));
  const Image full = draw(renderer, without);
  std::vector<double> shares(static_cast<std::size_t>(kWidth * kHeight), 0.0);
  constexpr int kSamples = 32;
  for (int sample = 0; sample < kSamples; ++sample) {
    FrameRequest one = asked;
    // All in the middle of the pixel but for what no one sees, so that the truth is that of a point.
    one.jitterPx = glm::vec2(1e-4f * static_cast<float>(sample + 1), 0.0f);
    one.sample = sample;
    const Image color = draw(renderer, one);
    for (std::size_t i = 0; i < shares.size(); ++i)
      shares[i] +=
          static_cast<double>(color.pixels[4 * i]) / static_cast<double>(full.pixels[4 * i]) / kSamples;
  }
  forEachWallPixel([&](std::size_t pixel, const glm::dvec2& wall) {
    ASSERT_NEAR(shares[pixel], sunSeen(wall, 3.0), 0.09) << wall.x << ", " << wall.y;
  });
}

} // namespace
} // namespace taa
