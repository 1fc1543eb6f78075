// Wherever the driver runs out of memory, an Error says so and everything is as it was before.
#include "core/inspect/Inspector.h"

#include "core/base/Error.h"
#include "core/gl/Memory.h"
#include "core/inspect/MemoryNeed.h"
#include "core/settings/Parameters.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 48, kHeight = 27;
const std::vector<IntermediateId> kLookedAt{IntermediateId::color, IntermediateId::motion,
                                            IntermediateId::historyRectified, IntermediateId::resolved};

/// What must not change.
struct State {
  std::string source, camera;
  int frame = 0, width = 0, height = 0;
  std::vector<Settings> lanes;
  std::vector<bool> exact;
  std::vector<Image> images;
  bool operator==(const State& other) const {
    return source == other.source && camera == other.camera && frame == other.frame && width == other.width &&
           height == other.height && lanes == other.lanes && exact == other.exact &&
           std::ranges::equal(images, other.images, [](const Image& a, const Image& b) {
             return a.width == b.width && a.pixels.size() == b.pixels.size() &&
                    std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
           });
  }
};

State stateOf(Inspector& inspector) {
  State state{inspector.shot().source(),
              inspector.shot().camera(),
              inspector.shot().frame(),
              inspector.shot().width(),
              inspector.shot().height(),
              {},
              {},
              {}};
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane) {
    state.lanes.push_back(inspector.shot().settings(lane));
    state.exact.push_back(inspector.shot().isExact(lane));
    for (Image& image : inspector.views().images(kLookedAt, lane)) state.images.push_back(std::move(image));
  }
  return state;
}

class OutOfMemoryTest : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    inspector_ = std::make_unique<Inspector>();
    inspector_->shot().setSize(kWidth, kHeight);
    inspector_->shot().open("builtin:text");
    inspector_->shot().seek(3);
  }
  void TearDown() override {
    gl::failAllocationsAfter(-1);
    inspector_.reset();
    GlTest::TearDown();
  }

  /// Lets `act` fail at its first allocation, then at its second, until it needs no more; how many there
  /// were.
  int failEverywhere(const std::function<void()>& act) {
    for (int count = 0;; ++count) {
      const State before = stateOf(*inspector_);
      gl::failAllocationsAfter(count);
      try {
        act();
        gl::failAllocationsAfter(-1);
        return count;
      } catch (const Error& error) {
        gl::failAllocationsAfter(-1);
        EXPECT_NE(std::string(error.what()).find("out of memory"), std::string::npos) << error.what();
        EXPECT_TRUE(stateOf(*inspector_) == before) << "after allocation " << count << ": " << error.what();
      }
      if (testing::Test::HasFailure()) return count;
    }
  }

  std::unique_ptr<Inspector> inspector_;
};

/// The same frame of an inspector that never lacked memory; on a thread of its own, for its context.
State fresh(const std::function<void(Inspector&)>& prepare) {
  return std::async(std::launch::async,
                    [&] {
                      Inspector inspector;
                      inspector.shot().setSize(kWidth, kHeight);
                      inspector.shot().open("builtin:text");
                      inspector.shot().seek(3);
                      prepare(inspector);
                      return stateOf(inspector);
                    })
      .get();
}

Settings hungrySettings() {
  Settings settings;
  for (const char* assignment : {"validate.object=on", "validate.normal=on", "inputs.noise=blueNoise",
                                 "inputs.mask=autoReactive", "inputs.precision=full"})
    applyAssignment(settings, assignment);
  return settings;
}

TEST_F(OutOfMemoryTest, LeavesThePictureWhereAnotherSizeDoesNotFit) {
  const auto change = [](Inspector& inspector) { inspector.shot().setSize(64, 36); };
  EXPECT_GE(failEverywhere([&] { change(*inspector_); }), 8);
  inspector_->shot().seek(3);
  EXPECT_TRUE(stateOf(*inspector_) == fresh([&](Inspector& inspector) {
                change(inspector);
                inspector.shot().seek(3);
              }));
}

TEST_F(OutOfMemoryTest, LeavesTheSceneWhereAnotherDoesNotFit) {
  EXPECT_GE(failEverywhere([&] { inspector_->shot().open("builtin:thin"); }), 8);
  EXPECT_EQ(inspector_->shot().source(), "builtin:thin");
}

TEST_F(OutOfMemoryTest, LeavesTheLanesWhereMoreDoNotFit) {
  const auto change = [](Inspector& inspector) { inspector.shot().setLanes({Settings{}, hungrySettings()}); };
  EXPECT_GE(failEverywhere([&] { change(*inspector_); }), 8);
  EXPECT_TRUE(stateOf(*inspector_) == fresh(change));
}

TEST_F(OutOfMemoryTest, LeavesTheSettingsWhereTheirTexturesDoNotFit) {
  EXPECT_GE(failEverywhere([&] { inspector_->shot().setSettings(hungrySettings()); }), 4);
  inspector_->shot().seek(3);
  EXPECT_TRUE(stateOf(*inspector_) == fresh([](Inspector& inspector) {
                inspector.shot().setSettings(hungrySettings());
                inspector.shot().seek(3);
              }));
}

TEST_F(OutOfMemoryTest, LeavesTheFrameWhereTheNextOneDoesNotFit) {
  EXPECT_GE(
      failEverywhere([&] {
        inspector_->views().watch({IntermediateId::resolved, IntermediateId::alpha, IntermediateId::motion});
        inspector_->shot().advance();
      }),
      3);
  EXPECT_TRUE(stateOf(*inspector_) == fresh([](Inspector& inspector) { inspector.shot().advance(); }));
}

TEST_F(OutOfMemoryTest, LeavesEverythingWhereLookingDoesNotFit) {
  EXPECT_GE(failEverywhere([&] { inspector_->views().image(IntermediateId::alpha); }), 1);
  EXPECT_GE(failEverywhere([&] { inspector_->probes().probe(3, 4); }), 1);
  EXPECT_GE(failEverywhere([&] { inspector_->views().picture(IntermediateId::resolved, {}, {}, 200, 100); }),
            1);
}

TEST_F(OutOfMemoryTest, HoldsNoMoreWhilePlayingThanItSaid) {
  Settings settings = hungrySettings();
  const std::vector<IntermediateId> watched{IntermediateId::resolved, IntermediateId::alpha};
  inspector_->shot().setCheckpointBudget(0);
  inspector_->shot().setSettings(settings);
  inspector_->shot().setSize(640, 360);
  inspector_->views().watch(watched);
  inspector_->shot().seek(0);
  const std::size_t need = memoryNeed({settings}, {640, 360}, watched).total();
  std::size_t others = 0; // of the scene, and what has no pixels of the picture
  for (const gl::MemoryUse& use : gl::memoryUse())
    if (use.kind == gl::StorageKind::Buffer || use.label == "texture") others += use.bytes;
  gl::resetMemoryPeak();
  for (int frame = 1; frame < 12; ++frame) inspector_->shot().advance();
  inspector_->shot().seek(4);
  EXPECT_LE(gl::memoryPeak() - others, need);
  EXPECT_GE(gl::memoryPeak() - others, need / 2) << "what is said is no idle number";
}

TEST_F(OutOfMemoryTest, HoldsNoMoreForAReferenceThanItSaid) {
  const std::vector<IntermediateId> rows{IntermediateId::reference, IntermediateId::referenceErrorAbs};
  inspector_->shot().setSize(640, 360);
  const auto look = [&] {
    for (const IntermediateId id : rows) inspector_->views().picture(id, {}, {}, 8, 8);
  };
  inspector_->views().watch({IntermediateId::output}); // which it is compared with
  inspector_->shot().seek(1);
  inspector_->views().picture(IntermediateId::output, {}, {}, 8, 8);
  const std::size_t need = memoryNeed({inspector_->shot().settings()}, {640, 360}, rows).reference;
  gl::resetMemoryPeak();
  const std::size_t before = gl::memoryPeak();
  inspector_->reference().refine(4);
  look();
  EXPECT_LE(gl::memoryPeak() - before, need);
  EXPECT_GE(gl::memoryPeak() - before, need / 2) << "what is said is no idle number";
}

} // namespace
} // namespace taa
