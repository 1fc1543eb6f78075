// Passes are timed while somebody asks for it, and only then.
#include "core/gl/PassTimer.h"

#include "core/gl/RenderPass.h"
#include "core/measure/Profiler.h"
#include "tests/support/GlTest.h"

#include <chrono>
#include <ratio>
#include <string>
#include <vector>

using taa::gl::PassGroup;
using taa::gl::PassTimer;
using taa::gl::TimingMethod;

namespace {

class PassTimerTest : public taa::test::GlTest, public testing::WithParamInterface<TimingMethod> {
 protected:
  void SetUp() override {
    GlTest::SetUp(); // only now there is a context
    if (IsSkipped() || HasFatalFailure()) return;
    target = {{.width = 256, .height = 256}, taa::gl::Format::RGBA16F, "target"};
    program = {taa::gl::ShaderSource("include/fullscreen.vert"), taa::gl::ShaderSource("bench/copy.frag"),
               "copy"};
  }
  void TearDown() override {
    program = {};
    target = {};
    GlTest::TearDown();
  }
  void draw(const char* label) {
    const taa::gl::Framebuffer framebuffer({{&target}}, nullptr, "target");
    taa::gl::RenderPass pass(framebuffer, {}, label);
    pass.program(program);
    pass.drawFullscreen();
  }

  taa::gl::Texture target;
  taa::gl::Program program;
};
INSTANTIATE_TEST_SUITE_P(Method, PassTimerTest, testing::Values(TimingMethod::Queries, TimingMethod::Finish),
                         [](const auto& method) {
                           return method.param == TimingMethod::Queries ? "Queries" : "Finish";
                         });

std::vector<std::string> names(const std::vector<taa::gl::PassTime>& times) {
  std::vector<std::string> result;
  for (const auto& time : times) result.push_back(time.group + "/" + time.pass);
  return result;
}

} // namespace

TEST_P(PassTimerTest, GivesEachPassSinceTheFrameBegan) {
  draw("before");
  PassTimer timer(GetParam());
  draw("earlier frame");
  PassTimer::startFrame();
  draw("one");
  {
    const PassGroup group("outer");
    draw("two");
    {
      const PassGroup inner("inner");
      draw("three");
    }
    draw("four");
  }
  draw("five");
  const auto times = timer.take();
  EXPECT_EQ(names(times),
            (std::vector<std::string>{"/one", "outer/two", "inner/three", "outer/four", "/five"}));
  for (const auto& time : times) {
    EXPECT_GE(time.milliseconds, 0.0);
    EXPECT_LT(time.milliseconds, 60000.0);
  }
  EXPECT_TRUE(timer.take().empty());
  EXPECT_EQ(timer.framesStarted(), 1);
}

TEST_P(PassTimerTest, MeasuresWhatAPassDoesNotWhatComesBetween) {
  PassTimer timer(GetParam());
  draw("small");
  double sum = 0.0;
  const auto start = std::chrono::steady_clock::now();
  for (int pass = 0; pass < 20; ++pass) draw("large");
  taa::gl::finish();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  for (const auto& time : timer.take())
    if (time.pass == "large") sum += time.milliseconds;
  if (GetParam() == TimingMethod::Finish) {
    EXPECT_GT(sum, 0.0);
  }
  EXPECT_LE(sum, wall.count());
}

TEST_P(PassTimerTest, TheLatestTimesAndTheOneBeforeGoesOnAfterIt) {
  PassTimer outer(GetParam());
  {
    PassTimer inner(GetParam());
    draw("inner");
    EXPECT_EQ(names(inner.take()), std::vector<std::string>{"/inner"});
  }
  draw("outer");
  EXPECT_EQ(names(outer.take()), std::vector<std::string>{"/outer"});
}

TEST(ProfilerTest, AddsUpPassesOfAKindAndWhatIsLeftOfTheFrame) {
  const std::vector<taa::gl::PassTime> times{{"GBufferPass", "", 3.0},
                                             {"TaaPass", "", 4.0},
                                             {"TaaPass", "", 5.0},
                                             {"Visualizer", "Views", 7.0},
                                             {"Another", "", 1.0}};
  const std::vector<taa::PassCost> costs = taa::addedUp(times, 20.0);
  ASSERT_EQ(costs.size(), 5u);
  EXPECT_EQ(costs[0].name, "G-buffer");
  EXPECT_EQ(costs[1].name, "Resolve");
  EXPECT_EQ(costs[1].milliseconds, 9.0);
  EXPECT_EQ(costs[1].runs, 2);
  EXPECT_EQ(costs[2].name, "Views");
  EXPECT_EQ(costs[3].name, "Another");
  EXPECT_EQ(costs[4].name, "Between the passes");
  EXPECT_EQ(costs[4].milliseconds, 20.0 - 13.0);
  EXPECT_EQ(costs[4].runs, 0);
}
