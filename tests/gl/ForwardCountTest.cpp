// Holes and collisions of forward reprojection behind a quad of known pixels that moves by three of them.
#include "core/render/faults/FaultySource.h"
#include "core/render/passes/SceneRenderer.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/SmallScene.h"

#include <cmath>
#include <memory>
#include <optional>

namespace taa {
namespace {

constexpr int kWidth = 32, kHeight = 18, kMovedBy = 3;
/// The quad's pixels in frame 0.
constexpr gl::Rect kQuad{8, 5, 6, 6};

class ForwardCountTest : public test::GlTest {
 protected:
  /// A quad before the sky, between frames 0 and 1 three pixels to the right; `cover`: pixels of a still one
  /// before it.
  static Scene sceneWith(const std::optional<gl::Rect>& cover = {}) {
    Scene scene = test::emptyScene();
    const int quad = add(scene, kQuad, 0.0f);
    const glm::vec3 from = scene.nodes[static_cast<std::size_t>(quad)].translation;
    const float step = kMovedBy * metersPerPx(0.0f);
    test::jump(scene, quad, AnimationPath::Translation, glm::vec4(from, 0.0f),
               glm::vec4(from + glm::vec3(step, 0, 0), 0.0f));
    if (cover) add(scene, *cover, 2.0f);
    return scene;
  }
  static FrameRequest request() {
    FrameRequest request;
    request.camera = test::kEye;
    request.width = kWidth;
    request.height = kHeight;
    request.jitter.sequence = JitterSequence::None;
    request.inputs.precision = Precision::Full;
    return request;
  }
  static FrameInputs draw(const Scene& scene, const FrameRequest& request, int frame) {
    FaultySource source(std::make_unique<SceneRenderer>(std::make_shared<const Scene>(scene)));
    FrameInputs inputs;
    source.draw(request, frame, inputs);
    return inputs;
  }
  static bool isIn(const gl::Rect& rect, int x, int y) {
    return x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height;
  }

 private:
  /// The camera stands at z = 10 and sees 60° of height.
  static float metersPerPx(float z) { return 2.0f * (10.0f - z) * std::tan(0.52359878f) / kHeight; }
  static int add(Scene& scene, const gl::Rect& px, float z) {
    const float scale = metersPerPx(z);
    const auto right = static_cast<float>(px.width), up = static_cast<float>(px.height);
    const float x = static_cast<float>(px.x) + 0.5f * right - 0.5f * kWidth;
    const float y = 0.5f * kHeight - static_cast<float>(px.y) - 0.5f * up;
    return test::addQuad(scene, {x * scale, y * scale, z}, {right * scale, 0, 0}, {0, up * scale, 0});
  }
};

// Techniques: 5.8.
TEST_F(ForwardCountTest, HasHolesBehindAndCollisionsBeforeWhatMoves) {
  const Scene scene = sceneWith();
  FrameRequest asked = request();
  asked.inputs.forward = Switch::On;
  for (const JitterSequence sequence : {JitterSequence::None, JitterSequence::Halton}) {
    asked.jitter.sequence = sequence; // pixels' centers are counted, wherever samples lie
    const Image counts = draw(scene, asked, 1).forwardCount.download();
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const bool was = isIn(kQuad, x, y), is = isIn(kQuad, x - kMovedBy, y);
        ASSERT_EQ(counts.at(x, y)[0], float(is) + float(!was)) << x << ", " << y;
      }
  }
}

TEST_F(ForwardCountTest, IsNotKnownWhereThereIsNoLastFrameOrNobodyAsks) {
  FrameRequest asked = request();
  EXPECT_FALSE(draw(sceneWith(), asked, 1).forwardCount);
  asked.inputs.forward = Switch::On;
  for (const float count : draw(sceneWith(), asked, 0).forwardCount.download().pixels)
    ASSERT_EQ(count, kForwardUnknown);
}

// What else is drawn has the same bits, whether pixels are counted or not.
TEST_F(ForwardCountTest, LeavesTheFrameAsItIs) {
  const Scene scene = sceneWith();
  FrameRequest asked = request();
  const FrameInputs without = draw(scene, asked, 1);
  asked.inputs.forward = Switch::On;
  const FrameInputs with = draw(scene, asked, 1);
  EXPECT_EQ(with.color.download().pixels, without.color.download().pixels);
  EXPECT_EQ(with.motion.download().pixels, without.motion.download().pixels);
  EXPECT_EQ(with.depth.download().pixels, without.depth.download().pixels);
}

// A still quad hides half of the one that moves. Without a depth test the hidden half writes its motion, too.
TEST_F(ForwardCountTest, UntestedMotionIsThatOfWhatIsHidden) {
  const gl::Rect cover{14, 2, 10, 12};
  const Scene scene = sceneWith(cover);
  FrameRequest asked = request();
  const Image healthy = draw(scene, asked, 1).motion.download();
  asked.faults.motionUntested = Switch::On;
  const Image faulty = draw(scene, asked, 1).motion.download();
  int hidden = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool isQuad = isIn(kQuad, x - kMovedBy, y), isHidden = isQuad && isIn(cover, x, y);
      ASSERT_NEAR(healthy.at(x, y)[0], isQuad && !isHidden ? kMovedBy : 0, 1e-4) << x << ", " << y;
      ASSERT_NEAR(faulty.at(x, y)[0], isQuad ? kMovedBy : 0, 1e-4) << x << ", " << y;
      ASSERT_NEAR(faulty.at(x, y)[1], 0, 1e-4);
      hidden += isHidden;
    }
  EXPECT_EQ(hidden, 18) << "three columns of six";
}

} // namespace
} // namespace taa
