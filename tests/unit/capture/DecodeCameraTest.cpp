// Matrices of every engine, and the places on the screen that points have under them, computed by hand.
#include "core/base/Error.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/scene/Pose.h"
#include "tests/support/ErrorOf.h"
#include "tests/unit/capture/CaptureFixtures.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {
namespace {

constexpr glm::ivec2 kSize(200, 100);

Manifest withCamera(const Conventions& conventions, const StatedMatrix& view,
                    const StatedMatrix& projection) {
  Manifest manifest = manifestOf(conventions, kSize);
  for (CapturedFrame& frame : manifest.frames) {
    frame.view = view;
    frame.projection = projection;
  }
  return manifest;
}

/// Device coordinates of a point, meters.
glm::dvec3 projected(const DecodedCamera& camera, const glm::dvec3& world) {
  const glm::dvec4 clip = camera.clipFromView * camera.viewFromWorld * glm::dvec4(world, 1.0);
  return glm::dvec3(clip) / clip.w;
}

void expectNear(const glm::dvec3& value, const glm::dvec3& expected, std::string_view what) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], 1e-12) << what << " " << i;
}

/// The message of the Error that decoding camera 0 throws.
std::string cameraErrorOf(const Manifest& manifest) {
  return test::errorOf([&] { static_cast<void>(decodeCamera(manifest, manifest.frames[0])); });
}

} // namespace

TEST(DecodeCamera, TakesWhatEachEngineStates) {
  for (const StartingPoint& point : startingPoints()) {
    const EngineCamera stated = engineCamera(point.id);
    const Manifest manifest = withCamera(point.conventions, stated.view, stated.projection);
    const std::optional<DecodedCamera> camera = decodeCamera(manifest, manifest.frames[0]);
    ASSERT_TRUE(camera) << point.id;
    // 4 m before the camera at (1, 2, 3), 0.5 to the right and 0.25 up: slopes 1 and 2 and near 0.1.
    const bool looksAlongPlusZ = point.conventions.matrices.forward == ForwardAxis::PositiveZ;
    const glm::dvec3 place(1.5, 2.25, looksAlongPlusZ ? 7.0 : -1.0);
    expectNear(projected(*camera, place), {0.5 / 4.0, 2.0 * 0.25 / 4.0, 0.1 / 4.0}, point.id);
    const glm::dvec4 inView = camera->viewFromWorld * glm::dvec4(place, 1.0);
    expectNear(glm::dvec3(inView), {0.5, 0.25, -4.0}, point.id);
    EXPECT_EQ(camera->clipFromView[2], glm::dvec4(0, 0, 0, -1)) << point.id;
    EXPECT_FALSE(camera->orthographic);
  }
}

TEST(DecodeCamera, OwnMatricesKeepTheirBits) {
  const glm::mat4 view = glm::lookAt(glm::vec3(1.3f, 2.7f, -4.1f), glm::vec3(0.2f), glm::vec3(0, 1, 0));
  for (const glm::mat4& clip :
       {perspectiveReversed(0.87f, 1.77f, 0.013f), orthographicReversed(3.3f, 1.6f, 0.07f, 91.3f)}) {
    StatedMatrix statedView{}, statedClip{};
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) {
        statedView[static_cast<std::size_t>(4 * row + column)] = static_cast<double>(view[column][row]);
        statedClip[static_cast<std::size_t>(4 * row + column)] = static_cast<double>(clip[column][row]);
      }
    const Manifest manifest = withCamera({}, statedView, statedClip);
    const std::optional<DecodedCamera> camera = decodeCamera(manifest, manifest.frames[1]);
    ASSERT_TRUE(camera);
    EXPECT_EQ(camera->viewFromWorld, glm::dmat4(view));
    EXPECT_EQ(camera->clipFromView, glm::dmat4(clip));
    EXPECT_EQ(camera->orthographic, clip[2][3] == 0.0f);
  }
}

TEST(DecodeCamera, KeepsWhatIsOffCenter) {
  // glFrustum's (r + l) / (r − l) and (t + b) / (t − b): what lies on the axis is seen at minus these.
  Conventions conventions;
  conventions.matrices.clipZ = ClipRange::MinusOneToOne;
  StatedMatrix projection = projections::gl(1, 2, 0.1, 100);
  projection[2] = 0.25;
  projection[6] = -0.5;
  const Manifest manifest = withCamera(conventions, moveBy(0, 0, 0), projection);
  const DecodedCamera camera = decodeCamera(manifest, manifest.frames[0]).value();
  expectNear(projected(camera, {0, 0, -4}), {-0.25, 0.5, 0.025}, "axis");
  expectNear(projected(camera, {1, 1, -4}), {0.0, 1.0, 0.025}, "beside it");
}

TEST(DecodeCamera, TakesTheJitterOut) {
  // Content that is moved 2 px to the right and 1 px down of 200 × 100: NDC +0.02, −0.02.
  for (const StartingPoint& point : startingPoints()) {
    if (point.conventions.jitter.delay != 0) continue;
    const EngineCamera stated = engineCamera(point.id);
    Manifest manifest = withCamera(point.conventions, stated.view, stated.projection);
    manifest.conventions.jitter = {};
    manifest.conventions.matrices.jittered = true;
    manifest.frames[0].jitter = {2.0, 1.0};
    // x and y of the column that w is made of: the third of four, by order and side.
    const bool inColumns = (point.conventions.matrices.order == MatrixOrder::ColumnMajor) !=
                           (point.conventions.matrices.vectors == VectorSide::Row);
    const double w = point.conventions.matrices.forward == ForwardAxis::PositiveZ ? 1.0 : -1.0;
    (*manifest.frames[0].projection)[inColumns ? 8 : 2] += 0.02 * w;
    (*manifest.frames[0].projection)[inColumns ? 9 : 6] -= 0.02 * w;
    const DecodedCamera camera = decodeCamera(manifest, manifest.frames[0]).value();
    const glm::dvec3 place(1.5, 2.25, w > 0.0 ? 7.0 : -1.0);
    expectNear(projected(camera, place), {0.125, 0.125, 0.025}, point.id);
  }
}

TEST(DecodeCamera, ClipSpaceMayPointDown) {
  Conventions conventions;
  conventions.matrices.clipY = VerticalAxis::Down;
  const Manifest manifest = withCamera(conventions, moveBy(0, 0, 0), projections::reversed(1, -2, 0.1));
  const DecodedCamera camera = decodeCamera(manifest, manifest.frames[0]).value();
  expectNear(projected(camera, {0.5, 0.25, -4}), {0.125, 0.125, 0.025}, "Vulkan");
}

TEST(DecodeCamera, OrthographicDepthIsReversedAndFinite) {
  // glOrtho's reference page in centimeters: half a width of 200, half a height of 100, near 100, far 1100.
  Conventions conventions;
  conventions.matrices.clipZ = ClipRange::MinusOneToOne;
  conventions.matrices.metersPerUnit = 0.01;
  const StatedMatrix ortho = {0.005, 0, 0, 0.25, 0, 0.01, 0, 0, 0, 0, -0.002, -1.2, 0, 0, 0, 1};
  const Manifest manifest = withCamera(conventions, moveBy(0, 0, 0), ortho);
  const DecodedCamera camera = decodeCamera(manifest, manifest.frames[0]).value();
  EXPECT_TRUE(camera.orthographic);
  expectNear(projected(camera, {1, 0.5, -1}), {0.75, 0.5, 1.0}, "near");
  expectNear(projected(camera, {0, 0, -6}), {0.25, 0.0, 0.5}, "middle");
  expectNear(projected(camera, {0, 0, -11}), {0.25, 0.0, 0.0}, "far");
}

TEST(DecodeCamera, IsNoneWhereOneMatrixIsMissing) {
  Manifest manifest = withCamera({}, moveBy(0, 0, 0), projections::reversed(1, 1, 0.1));
  manifest.frames[0].view = {};
  EXPECT_FALSE(decodeCamera(manifest, manifest.frames[0]));
  manifest.frames[1].projection = {};
  EXPECT_FALSE(decodeCamera(manifest, manifest.frames[1]));
}

TEST(DecodeCamera, ThePreviousOneIsThatOfTheFrameBefore) {
  Manifest manifest = withCamera({}, moveBy(0, 0, 0), projections::reversed(1, 1, 0.1));
  manifest.frames[0].view = moveBy(-5, 0, 0);
  DecodedFrame frame = decode(manifest, 1, planesOf(manifest));
  EXPECT_EQ(frame.previousCamera->viewFromWorld[3].x, -5.0);
  manifest.frames[1].previousView = moveBy(-6, 0, 0);
  frame = decode(manifest, 1, planesOf(manifest));
  EXPECT_EQ(frame.previousCamera->viewFromWorld[3].x, -6.0);
  manifest.frames[1].cut = true;
  frame = decode(manifest, 1, planesOf(manifest));
  EXPECT_EQ(frame.previousCamera, frame.camera);
  EXPECT_TRUE(frame.startsHistory);
  EXPECT_EQ(decode(manifest, 0, planesOf(manifest)).previousCamera->viewFromWorld[3].x, -5.0);
}

TEST(DecodeCamera, MatricesThatCannotBeAreErrorsThatSayWhy) {
  const StatedMatrix view = moveBy(0, 0, 0), projection = projections::gl(1, 2, 0.1, 100);
  Conventions gl;
  gl.matrices.clipZ = ClipRange::MinusOneToOne;
  const auto error = [&](StatedMatrix v, StatedMatrix p, const Conventions& c) {
    return cameraErrorOf(withCamera(c, v, p));
  };
  ASSERT_EQ(error(view, projection, gl), "");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  StatedMatrix bad = view;
  bad[5] = nan;
  EXPECT_NE(error(bad, projection, gl).find("view matrix holds"), std::string::npos);
  bad = projection;
  bad[0] = nan;
  EXPECT_NE(error(view, bad, gl).find("projection matrix holds"), std::string::npos);
  bad = view;
  bad[0] = 0.0;
  EXPECT_NE(error(bad, projection, gl).find("singular"), std::string::npos);
  EXPECT_NE(error(StatedMatrix{}, projection, gl), "");
  EXPECT_NE(error(view, StatedMatrix{}, gl), "");
  EXPECT_NE(error(view, projections::gl(1, 0, 0.1, 100), gl).find("singular"), std::string::npos);
  // A moved view in columns where rows are stated.
  EXPECT_NE(error(transposed(moveBy(1, 2, 3)), projection, gl).find("matrices.order"), std::string::npos);
  EXPECT_NE(error(view, transposed(projections::d3d(1, 2, 0.1, 100)), {}).find("matrices.forward"),
            std::string::npos);
  EXPECT_NE(error(view, projections::reversed(1, 2, 0.0), {}).find("near plane"), std::string::npos);
  EXPECT_NE(error(view, projections::reversed(1, 2, -1.0), {}).find("near plane"), std::string::npos);
  bad = projection;
  bad[8] = 0.5;
  EXPECT_NE(error(view, bad, gl).find("slanted"), std::string::npos);
  StatedMatrix huge{};
  huge.fill(1e308);
  EXPECT_NE(error(huge, huge, gl), "");
}

TEST(DecodeCamera, SizesAndUnitsThatCannotBeAreErrors) {
  Manifest manifest = withCamera({}, moveBy(0, 0, 0), projections::reversed(1, 1, 0.1));
  manifest.conventions.matrices.metersPerUnit = 0.0;
  EXPECT_NE(cameraErrorOf(manifest), "");
  manifest.conventions.matrices.metersPerUnit = 1.0;
  for (const glm::ivec2 size : {glm::ivec2(-4, 4), glm::ivec2(4, 0)}) {
    manifest.sizePx = size;
    EXPECT_NE(cameraErrorOf(manifest), "");
    EXPECT_THROW(decode(manifest, 0, {}), Error);
  }
}

} // namespace taa::capture
