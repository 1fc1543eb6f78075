// What faults make of hand-made planes, texel by texel from the formula of each: of a renderer's frames and
// of a capture's.
#include "core/render/faults/FaultySource.h"

#include "core/measure/References.h"
#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"
#include "tests/gl/faults/HandMadeSource.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace taa {
namespace {

using test::HandMadeSource;

constexpr int kW = HandMadeSource::kWidth, kH = HandMadeSource::kHeight, kFrame = 5;
const glm::vec2 kSize{kW, kH};

class FaultySourceTest : public test::GlTest {
 protected:
  static FrameRequest requestOf(std::initializer_list<const char*> assignments) {
    Settings settings;
    for (const char* assignment : assignments) applyAssignment(settings, assignment);
    FrameRequest request;
    request.width = kW;
    request.height = kH;
    request.faults = settings.fault;
    return request;
  }

  FrameInputs drawn(const FrameRequest& request, int frame = kFrame, bool isCaptured = false) {
    FrameInputs out;
    (isCaptured ? captured_ : source_).draw(request, frame, out);
    return out;
  }

  using Motion = std::function<glm::vec2(int x, int y)>;

  /// Of a renderer and of a capture alike.
  void expectMotion(const FrameRequest& request, const Motion& expected, int frame = kFrame) {
    for (const bool isCaptured : {false, true}) {
      const Image motion = drawn(request, frame, isCaptured).motion.download();
      for (int y = 0; y < kH; ++y)
        for (int x = 0; x < kW; ++x) {
          const glm::vec2 should = expected(x, y);
          ASSERT_EQ(motion.at(x, y)[0], should.x) << x << ", " << y << (isCaptured ? " captured" : "");
          ASSERT_EQ(motion.at(x, y)[1], should.y) << x << ", " << y << (isCaptured ? " captured" : "");
        }
    }
  }

  static glm::vec2 given(int x, int y) { return HandMadeSource::motionPx(x, y, kFrame); }

  FaultySource source_{std::make_unique<HandMadeSource>()};
  FaultySource captured_{std::make_unique<HandMadeSource>(true)};
};

glm::vec2 jitterOf(int frame) {
  return HandMadeSource::jitterPx(frame);
}

TEST_F(FaultySourceTest, GivesWhatItsSourceGivesWithoutFaults) {
  auto made = std::make_unique<HandMadeSource>();
  HandMadeSource& source = *made;
  FaultySource faulty(std::move(made));
  FrameRequest request = requestOf({"fault.region=sky", "fault.firstFrame=2"});
  request.part = gl::Rect{1, 2, 3, 4};
  FrameInputs out;
  faulty.draw(request, kFrame, out);
  ASSERT_EQ(source.asked.size(), 1u) << "nothing else is drawn";
  EXPECT_FALSE(source.asked[0].second.jitterPx);
  EXPECT_EQ(source.asked[0].second.part, request.part);
  EXPECT_TRUE(source.asked[0].second.faults == FaultSettings{});
  expectMotion(requestOf({}), given);
  EXPECT_EQ(out.info.jitterPx, jitterOf(kFrame));
  EXPECT_EQ(out.block.jitterPx, jitterOf(kFrame));
}

TEST_F(FaultySourceTest, ScalesNegatesAndSwapsMotion) {
  expectMotion(requestOf({"fault.motionX=-1"}), [](int x, int y) { return given(x, y) * glm::vec2(-1, 1); });
  expectMotion(requestOf({"fault.motionY=-1"}), [](int x, int y) { return given(x, y) * glm::vec2(1, -1); });
  expectMotion(requestOf({"fault.motionX=2", "fault.motionY=0.5"}),
               [](int x, int y) { return given(x, y) * glm::vec2(2.0f, 0.5f); });
  expectMotion(requestOf({"fault.motionSwapped=on"}),
               [](int x, int y) { return glm::vec2(given(x, y).y, given(x, y).x); });
  expectMotion(requestOf({"fault.motion=zero"}), [](int, int) { return glm::vec2(0.0f); });
}

TEST_F(FaultySourceTest, WritesMotionInOtherUnits) {
  expectMotion(requestOf({"fault.motionUnit=uv"}), [](int x, int y) { return given(x, y) / kSize; });
  expectMotion(requestOf({"fault.motionUnit=ndc"}),
               [](int x, int y) { return glm::vec2(2, -2) * (given(x, y) / kSize); });
  expectMotion(requestOf({"fault.motionUnit=biased"}),
               [](int x, int y) { return 0.5f * given(x, y) + 0.5f * kSize; });
  expectMotion(requestOf({"fault.motionUnit=unwritten"}), [](int, int) { return -kSize; });
  expectMotion(requestOf({"fault.motionUnit=asUv"}), [](int x, int y) { return given(x, y) * kSize; });
  expectMotion(requestOf({"fault.motionUnit=asNdc"}),
               [](int x, int y) { return glm::vec2(0.5f, -0.5f) * (given(x, y) * kSize); });
  expectMotion(requestOf({"fault.motionUnit=asBiased"}),
               [](int x, int y) { return 2.0f * given(x, y) - kSize; });
  expectMotion(requestOf({"fault.motionUnit=asRoot"}),
               [](int x, int y) { return glm::abs(given(x, y)) * given(x, y) / kSize; });
  const Image root = drawn(requestOf({"fault.motionUnit=root"})).motion.download();
  for (int x = 0; x < kW; ++x) {
    const glm::vec2 v = given(x, 3) / kSize;
    EXPECT_NEAR(root.at(x, 3)[0], std::sqrt(v.x) * kSize.x, 1e-4) << "roots differ in the last bit";
    EXPECT_NEAR(root.at(x, 3)[1], -std::sqrt(-v.y) * kSize.y, 1e-4);
  }
}

TEST_F(FaultySourceTest, LeavesJitterInMotion) {
  const glm::vec2 now = jitterOf(kFrame), last = jitterOf(kFrame - 1);
  expectMotion(requestOf({"fault.motionJitter=this"}), [&](int x, int y) { return given(x, y) + now; });
  expectMotion(requestOf({"fault.motionJitter=last"}), [&](int x, int y) { return given(x, y) - last; });
  expectMotion(requestOf({"fault.motionJitter=both"}),
               [&](int x, int y) { return given(x, y) + now - last; });
  expectMotion(requestOf({"fault.motionJitter=thisOff"}), [&](int x, int y) { return given(x, y) - now; });
  expectMotion(requestOf({"fault.motionJitter=lastOff"}), [&](int x, int y) { return given(x, y) + last; });
  expectMotion(requestOf({"fault.motionJitter=bothOff"}),
               [&](int x, int y) { return given(x, y) - now + last; });
}

TEST_F(FaultySourceTest, TakesZeroForMissing) {
  expectMotion(requestOf({"fault.zeroIsMissing=on"}), [](int x, int y) {
    return given(x, y) == glm::vec2(0.0f) ? glm::vec2(kNoPreviousPosition) : given(x, y);
  });
}

TEST_F(FaultySourceTest, ReadsMotionElsewhere) {
  expectMotion(requestOf({"fault.motionShift=2"}),
               [](int x, int y) { return given(x < 2 ? 0 : x - 2, y < 2 ? 0 : y - 2); });
  expectMotion(requestOf({"fault.motionShift=-2"}),
               [](int x, int y) { return given(std::min(x + 2, kW - 1), std::min(y + 2, kH - 1)); });
  expectMotion(requestOf({"fault.motionCoarse=4"}),
               [](int x, int y) { return given(x / 4 * 4 + 2, y / 4 * 4 + 2); });
}

TEST_F(FaultySourceTest, TakesMotionOfEarlierFrames) {
  expectMotion(requestOf({"fault.motionLag=3"}),
               [](int x, int y) { return HandMadeSource::motionPx(x, y, kFrame - 3); });
  expectMotion(
      requestOf({"fault.motionLag=8"}), [](int x, int y) { return HandMadeSource::motionPx(x, y, 0); }, 2);
  expectMotion(requestOf({"fault.motionLag=-1"}),
               [](int x, int y) { return HandMadeSource::motionPx(x, y, kFrame + 1); });
  expectMotion(requestOf({"fault.previousAge=2"}), [](int x, int y) {
    const glm::vec2 v = given(x, y), before = glm::vec2(x, y) + 0.5f - v;
    const glm::ivec2 texel(glm::floor(before));
    const bool isSeen = before.x >= 0 && before.y >= 0 && before.x < kW && before.y < kH;
    return isSeen ? v + HandMadeSource::motionPx(texel.x, texel.y, kFrame - 1) : v;
  });
  expectMotion(
      requestOf({"fault.previousAge=4"}),
      [](int x, int y) { return HandMadeSource::motionPx(x, y, HandMadeSource::kCut); },
      HandMadeSource::kCut);
}

TEST_F(FaultySourceTest, KeepsToItsRegion) {
  const std::vector<std::pair<const char*, std::function<bool(int, int)>>> regions{
      {"fault.region=sky", [](int x, int y) { return HandMadeSource::objectAt(x, y) == 0; }},
      {"fault.region=surfaces", [](int x, int y) { return HandMadeSource::objectAt(x, y) != 0; }},
      {"fault.region=still", [](int x, int y) { return HandMadeSource::objectAt(x, y) == 1; }},
      {"fault.region=moving", [](int x, int y) { return HandMadeSource::objectAt(x, y) == 2; }},
      {"fault.region=deforming", [](int x, int y) { return HandMadeSource::objectAt(x, y) == 3; }},
      {"fault.region=object",
       [](int x, int y) { return HandMadeSource::objectAt(x, y) == 1; }}, // 1 by default
      {"fault.region=rectangle",
       [](int x, int y) { return x >= kW / 4 && x < 3 * kW / 4 && y >= kH / 4 && y < 3 * kH / 4; }}};
  for (const auto& entry : regions)
    expectMotion(requestOf({"fault.motion=zero", entry.first}),
                 [&](int x, int y) { return entry.second(x, y) ? glm::vec2(0.0f) : given(x, y); });
}

TEST_F(FaultySourceTest, TakesOlderTransformsInItsRegionAlone) {
  const Image all = drawn(requestOf({"fault.previousAge=2"})).motion.download();
  expectMotion(requestOf({"fault.previousAge=2", "fault.region=still"}), [&](int x, int y) {
    return HandMadeSource::objectAt(x, y) == 1 ? glm::vec2(all.at(x, y)[0], all.at(x, y)[1]) : given(x, y);
  });
}

TEST_F(FaultySourceTest, KeepsToItsFrames) {
  const FrameRequest request = requestOf({"fault.motion=zero", "fault.firstFrame=4", "fault.lastFrame=5"});
  for (int frame = 3; frame < 7; ++frame)
    expectMotion(
        request,
        [&](int x, int y) {
          return frame == 4 || frame == 5 ? glm::vec2(0.0f) : HandMadeSource::motionPx(x, y, frame);
        },
        frame);
}

const glm::ivec2 kSurfaceTexel(5, 40);

glm::dmat4 projectionOf(int frame) {
  return glm::dmat4(HandMadeSource::cameraOf(frame).clipFromView);
}

glm::dmat4 viewOf(int frame) {
  return glm::dmat4(HandMadeSource::cameraOf(frame).viewFromWorld);
}

/// Where a camera sees what is at kSurfaceTexel in kFrame, px from the picture's middle.
glm::dvec2 placeIn(const glm::dmat4& clipFromWorld) {
  const glm::dvec2 at = (glm::dvec2(kSurfaceTexel) + 0.5 - glm::dvec2(jitterOf(kFrame))) / glm::dvec2(kSize);
  const glm::dvec4 ndc(2.0 * at.x - 1.0, 1.0 - 2.0 * at.y, HandMadeSource::kDepth, 1.0);
  const glm::dvec4 seen = clipFromWorld * glm::inverse(projectionOf(kFrame) * viewOf(kFrame)) * ndc;
  return glm::dvec2(0.5, -0.5) * (glm::dvec2(seen) / seen.w) * glm::dvec2(kSize);
}

// The camera's part is taken out of what is given, and that of another camera put in.
TEST_F(FaultySourceTest, MakesMotionWithAnotherCamera) {
  const glm::dmat4 projection = projectionOf(kFrame), view = viewOf(kFrame - 1), one(1.0);
  const std::vector<std::pair<const char*, glm::dmat4>> cameras{
      {"fault.previousCamera=ofNow", projection * viewOf(kFrame)},
      {"fault.previousCamera=turned",
       projection * glm::rotate(one, glm::radians(1.0), glm::dvec3(0, 1, 0)) * view},
      {"fault.previousCamera=mirrored", projection * view * glm::scale(one, glm::dvec3(1, -1, 1))},
      {"fault.previousCamera=secondView", projection * glm::translate(one, glm::dvec3(-0.5, 0, 0)) * view},
      {"fault.previousCamera=identity", one}};
  for (const auto& [assignment, wrong] : cameras) {
    const Image motion = drawn(requestOf({assignment})).motion.download();
    const float* is = motion.at(kSurfaceTexel.x, kSurfaceTexel.y);
    const glm::dvec2 should =
        glm::dvec2(given(kSurfaceTexel.x, kSurfaceTexel.y)) + placeIn(projection * view) - placeIn(wrong);
    EXPECT_NEAR(is[0], should.x, 1e-3) << assignment << ": matrices are floats";
    EXPECT_NEAR(is[1], should.y, 1e-3) << assignment;
  }
}

TEST_F(FaultySourceTest, AddsTheCamerasMotionOnceMore) {
  const Image motion = drawn(requestOf({"fault.previousCamera=twice"})).motion.download();
  const float* is = motion.at(kSurfaceTexel.x, kSurfaceTexel.y);
  const glm::dmat4 projection = projectionOf(kFrame);
  const glm::dvec2 should = glm::dvec2(given(kSurfaceTexel.x, kSurfaceTexel.y)) +
                            placeIn(projection * viewOf(kFrame)) - placeIn(projection * viewOf(kFrame - 1));
  EXPECT_NEAR(is[0], should.x, 1e-3) << "matrices are floats";
  EXPECT_NEAR(is[1], should.y, 1e-3);
}

TEST_F(FaultySourceTest, EndsWithTheFramesOfACapture) {
  const int last = HandMadeSource::kFrames - 1;
  const Image motion = drawn(requestOf({"fault.motionLag=-1"}), last, true).motion.download();
  EXPECT_EQ(motion.at(3, 3)[0], HandMadeSource::motionPx(3, 3, last).x) << "after it there is none";
}

TEST_F(FaultySourceTest, MakesMotionOfTheCameraAlone) {
  const Image motion = drawn(requestOf({"fault.motion=cameraOnly"})).motion.download();
  const float* is = motion.at(kSurfaceTexel.x, kSurfaceTexel.y);
  const glm::dmat4 projection = projectionOf(kFrame);
  const glm::dvec2 should = placeIn(projection * viewOf(kFrame)) - placeIn(projection * viewOf(kFrame - 1));
  EXPECT_GT(glm::length(should - glm::dvec2(given(kSurfaceTexel.x, kSurfaceTexel.y))), 0.1);
  EXPECT_NEAR(is[0], should.x, 1e-3) << "matrices are floats";
  EXPECT_NEAR(is[1], should.y, 1e-3);
}

TEST_F(FaultySourceTest, ReferencesHaveNone) {
  const FrameRequest healthy = requestOf({});
  for (const FaultInfo& info : faultTable()) {
    Settings settings;
    inject(info.fault, settings);
    FrameRequest request = healthy;
    request.faults = settings.fault;
    EXPECT_EQ(referenceRequest(request), referenceRequest(healthy)) << info.id;
  }
}

TEST_F(FaultySourceTest, MistakesDepth) {
  const auto depths = [this](std::initializer_list<const char*> assignments) {
    return drawn(requestOf(assignments)).depth.download();
  };
  const Image reversed = depths({"fault.depth=reversed"}), linear = depths({"fault.depth=linear"}),
              coarse = depths({"fault.depthCoarse=8"});
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) {
      const float d = HandMadeSource::depthAt(x, y);
      ASSERT_EQ(reversed.at(x, y)[0], 1.0f - d);
      ASSERT_FLOAT_EQ(linear.at(x, y)[0], d == 0.0f ? 1.0f : 0.08f) << "8 m of 100";
      ASSERT_EQ(coarse.at(x, y)[0], HandMadeSource::depthAt(x / 8 * 8 + 4, y / 8 * 8 + 4));
    }
  const Image sky = depths({"fault.depth=reversed", "fault.region=sky"});
  EXPECT_EQ(sky.at(3, 3)[0], 1.0f);
  EXPECT_EQ(sky.at(3, 40)[0], HandMadeSource::kDepth) << "a surface";
  const FrameInputs healthy = drawn(requestOf({})), near = drawn(requestOf({"fault.nearPlane=2"}));
  EXPECT_EQ(near.block.depthTerms.y, 2.0f * healthy.block.depthTerms.y);
  EXPECT_EQ(near.previousDepth.download().at(3, 40)[0], 4.0f);
}

TEST_F(FaultySourceTest, MistakesColor) {
  const Image bright = drawn(requestOf({"fault.exposure=2", "fault.region=surfaces"})).color.download();
  const Image nan = drawn(requestOf({"fault.nan=on", "fault.firstFrame=5"})).color.download();
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) {
      const glm::vec4 c = HandMadeSource::colorAt(x, y, kFrame, jitterOf(kFrame));
      const float factor = HandMadeSource::objectAt(x, y) == 0 ? 1.0f : 4.0f;
      ASSERT_EQ(bright.at(x, y)[1], factor * c.y);
      ASSERT_EQ(std::isnan(nan.at(x, y)[0]), x == kW / 2 && y == kH / 2) << x << ", " << y;
    }
  const Image later = drawn(requestOf({"fault.nan=on", "fault.firstFrame=4"})).color.download();
  EXPECT_FALSE(std::isnan(later.at(kW / 2, kH / 2)[0])) << "in the first frame only";
}

// Bars of 24 px with lines a px wide and 8 px apart.
TEST_F(FaultySourceTest, DrawsAnInterface) {
  const float paper = 0.05f, j = jitterOf(kFrame).x;
  ASSERT_LT(j, 0.0f);
  const Image still = drawn(requestOf({"fault.interface=still"})).color.download();
  EXPECT_EQ(still.at(8, 8)[0], 1.0f) << "a line";
  EXPECT_EQ(still.at(9, 9)[0], paper);
  EXPECT_EQ(still.at(9, 30)[0], 9.0f) << "between the bars";
  const Image moved = drawn(requestOf({"fault.interface=jittered"})).color.download();
  EXPECT_FLOAT_EQ(moved.at(7, 12)[0], paper + (1.0f - paper) * -j) << "the line moved left by a part of a px";
  EXPECT_FLOAT_EQ(moved.at(8, 12)[0], paper + (1.0f - paper) * (1.0f + j));
}

TEST_F(FaultySourceTest, DrawsWithOneJitterAndReportsAnother) {
  const FrameInputs none = drawn(requestOf({"fault.jitterApplied=0"}));
  EXPECT_EQ(none.color.download().at(3, 3)[2], 1.0f) << "it was drawn without";
  EXPECT_EQ(none.info.jitterPx, jitterOf(kFrame));
  EXPECT_EQ(none.block.jitterPx, jitterOf(kFrame));
  const FrameInputs negated = drawn(requestOf({"fault.jitter=negated"}));
  EXPECT_EQ(negated.color.download().at(3, 3)[2], 1.0f + jitterOf(kFrame).x);
  EXPECT_EQ(negated.info.jitterPx, -jitterOf(kFrame));
  EXPECT_EQ(glm::vec2(negated.block.previousJitter), -jitterOf(kFrame - 1));
  const FrameInputs captured = drawn(requestOf({"fault.jitterApplied=0"}), kFrame, true);
  EXPECT_EQ(captured.color.download().at(3, 3)[2], 1.0f + jitterOf(kFrame).x) << "drawn already";
  EXPECT_EQ(drawn(requestOf({"fault.jitter=early"}), HandMadeSource::kFrames - 1, true).info.jitterPx,
            jitterOf(HandMadeSource::kFrames - 1))
      << "after the last frame there is none";
}

// A sample that lies where the report says must be found there by the matrices that go with it.
TEST_F(FaultySourceTest, ReportsMatricesWithTheJitterItReports) {
  const FrameInputs out = drawn(requestOf({"fault.jitter=negated"}));
  const glm::vec4 world(0.5f, 1.0f, -8.0f, 1.0f);
  const glm::vec4 still = out.block.clipFromWorld * world, moved = out.block.jitteredClipFromWorld * world;
  const glm::vec2 px =
      glm::vec2(0.5f, -0.5f) * (glm::vec2(moved) / moved.w - glm::vec2(still) / still.w) * kSize;
  EXPECT_NEAR(px.x, -jitterOf(kFrame).x, 1e-4);
  EXPECT_NEAR(px.y, -jitterOf(kFrame).y, 1e-4);
  const glm::mat4 back = out.block.worldFromJitteredClip * out.block.jitteredClipFromWorld;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) EXPECT_NEAR(back[column][row], column == row ? 1.0f : 0.0f, 1e-4);
}

TEST_F(FaultySourceTest, DrawsSkyWithAJitterOfItsOwn) {
  const Image color = drawn(requestOf({"fault.skyJitter=0"})).color.download();
  EXPECT_EQ(color.at(3, 3)[2], 1.0f) << "sky";
  EXPECT_EQ(color.at(3, 40)[2], 1.0f + jitterOf(kFrame).x) << "a surface";
}

TEST_F(FaultySourceTest, GoesOnThroughCutsWhenItIsToldTo) {
  const FaultySource& source = source_;
  EXPECT_TRUE(source.info(requestOf({}), HandMadeSource::kCut).startsHistory);
  FrameRequest request = requestOf({"fault.keepsAtCuts=on"});
  EXPECT_FALSE(source.info(request, HandMadeSource::kCut).startsHistory);
  EXPECT_TRUE(source.info(request, 0).startsHistory) << "there is nothing before";
  request.restarts = {HandMadeSource::kCut};
  EXPECT_TRUE(source.info(request, HandMadeSource::kCut).startsHistory) << "somebody asked for it";
}

// Faulty frames are functions too: whatever was drawn before, a frame has the same bits.
TEST_F(FaultySourceTest, GivesTheSameBitsInAnyOrder) {
  for (const FaultInfo& info : faultTable()) {
    Settings settings;
    inject(info.fault, settings);
    FrameRequest request = requestOf({});
    request.faults = settings.fault;
    FrameInputs played, sought;
    for (int frame = 0; frame <= kFrame; ++frame) source_.draw(request, frame, played);
    source_.draw(request, 11, sought);
    source_.draw(request, kFrame, sought);
    EXPECT_EQ(played.motion.download().pixels, sought.motion.download().pixels) << info.id;
    EXPECT_EQ(played.depth.download().pixels, sought.depth.download().pixels) << info.id;
    EXPECT_EQ(played.color.download().pixels, sought.color.download().pixels) << info.id;
    EXPECT_EQ(played.info.jitterPx, sought.info.jitterPx) << info.id;
  }
}

} // namespace
} // namespace taa
