// Requests in, answers out: what the window can rely on.
#include "tests/support/RenderRecorder.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace {

using taa::IntermediateId;
using taa::RenderThread;
using taa::ViewRequest;
using taa::test::otherJitter;
using taa::test::onThread::kHeight;
using taa::test::onThread::kWidth;
using taa::test::onThread::viewOf;

using RenderThreadTest = taa::test::onThread::RenderThreadTest;

} // namespace

TEST_F(RenderThreadTest, TellsWhatItHasOpened) {
  const taa::Status status = recorder.last<taa::Status>();
  EXPECT_EQ(status.source, "builtin:fan");
  EXPECT_EQ(status.width, kWidth);
  EXPECT_EQ(status.height, kHeight);
  EXPECT_GT(status.frameCount, 1);
  EXPECT_EQ(status.jitterPeriod, 16);
  EXPECT_NE(std::ranges::find(status.cameras, status.camera), status.cameras.end());
  EXPECT_FALSE(status.driver.renderer.empty());
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderThreadTest, DeliversViewsAndWhatChangesInThem) {
  ViewRequest alpha = viewOf(IntermediateId::alpha);
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved), alpha}});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 2u);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].view, 0);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[1].view, 1);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[1].request, alpha);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[1].picture.width, kWidth);
  EXPECT_TRUE(recorder.all<taa::ViewResult>()[1].values.empty());
  recorder.clear();
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved), alpha}});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::ViewResult>().empty()) << "nothing has changed";
  alpha.transform.zoom = 2.0f;
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved), alpha}});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 1u) << "only what has changed";
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].view, 1);
  recorder.clear();
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 2u);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].frame, 1);
  recorder.clear();
  thread->post(taa::request::Seek{1});
  thread->post(taa::request::SetSettings{{}});
  thread->post(taa::request::SetSize{kWidth, kHeight});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::ViewResult>().empty()) << "it was all so already";
}

TEST_F(RenderThreadTest, DeliversTheValuesOfVisibleTexels) {
  ViewRequest view = viewOf(IntermediateId::alpha);
  view.withValues = true;
  view.transform = {.origin = {4.5f, 15.0f}, .zoom = 8.0f};
  thread->post(taa::request::SetViews{{view}});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 1u);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].region, (taa::gl::Rect{4, 15, 5, 3}));
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].values.width, 5);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].values.height, 3);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].values.at(0, 0)[0], 1.0f) << "frame 0 has no history";
}

TEST_F(RenderThreadTest, GoesWhereTheLastRequestSays) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->waitUntilIdle();
  recorder.clear();
  for (int frame = 10; frame < 60; ++frame) thread->post(taa::request::Seek{frame});
  thread->post(taa::request::Seek{20});
  for (int count = 0; count < 5; ++count) thread->post(taa::request::Step{1});
  thread->post(taa::request::Step{-2});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 23);
  // Requests that came while it worked may have shown a frame each, but never one for every request.
  EXPECT_LE(recorder.all<taa::ViewResult>().size(), 5u);
  EXPECT_EQ(recorder.all<taa::ViewResult>().back().frame, 23);
  thread->post(taa::request::Seek{100000});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), recorder.all<taa::Status>().back().frameCount - 1);
  thread->post(taa::request::Step{-100000});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 0);
}

TEST_F(RenderThreadTest, ShowsEveryFrameInOrderWhenPlaying) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->waitUntilIdle();
  thread->post(taa::request::SetPlaying{true});
  EXPECT_TRUE(recorder.waitFor([&] { return recorder.all<taa::ViewResult>().size() >= 12; }));
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  for (std::size_t index = 0; index < recorder.all<taa::ViewResult>().size(); ++index) {
    EXPECT_EQ(recorder.all<taa::ViewResult>()[index].frame, static_cast<int>(index));
    EXPECT_TRUE(recorder.all<taa::ViewResult>()[index].exact);
  }
  EXPECT_FALSE(recorder.all<taa::Status>().back().playing);
  EXPECT_EQ(recorder.frame(), recorder.all<taa::ViewResult>().back().frame);
}

TEST_F(RenderThreadTest, PlaysNoFasterThanTheShot) {
  const auto start = std::chrono::steady_clock::now();
  const int first = recorder.frame();
  thread->post(taa::request::SetPlaying{true});
  EXPECT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Status>().back().info.frame >= first + 7; }));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(seconds, 6.0 / recorder.last<taa::Status>().framesPerSecond);
}

TEST_F(RenderThreadTest, StartsAgainAtTheEndOrPausesThere) {
  const int last = recorder.all<taa::Status>().back().frameCount - 1;
  thread->post(taa::request::Seek{last - 2});
  thread->waitUntilIdle();
  recorder.clear();
  thread->post(taa::request::SetPlaying{true});
  EXPECT_TRUE(recorder.waitFor([&] {
    return std::ranges::any_of(recorder.all<taa::Status>(),
                               [](const auto& status) { return status.info.frame == 2; });
  }));
  thread->post(taa::request::SetLooping{false});
  thread->post(taa::request::Seek{last - 2});
  EXPECT_TRUE(recorder.waitFor(
      [&] { return !recorder.all<taa::Status>().empty() && !recorder.all<taa::Status>().back().playing; }));
  EXPECT_EQ(recorder.frame(), last);
  thread->post(taa::request::SetPlaying{true});
  EXPECT_TRUE(recorder.waitFor([&] {
    return recorder.all<taa::Status>().back().playing && recorder.all<taa::Status>().back().info.frame < last;
  }));
}

TEST_F(RenderThreadTest, PlaysOnAfterNewSettingsAndIsExactWhenPaused) {
  thread->post(taa::request::Seek{3});
  thread->post(taa::request::SetPlaying{true});
  thread->waitUntilIdle();
  recorder.clear();
  thread->post(taa::request::SetSettings{otherJitter()});
  EXPECT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Status>().size() > 5; }));
  EXPECT_FALSE(recorder.read([&] { return recorder.all<taa::Status>()[4].exact; }));
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::Status>().back().exact);
}

TEST_F(RenderThreadTest, AnswersViewsAndProbesWhileItReplays) {
  bool isAsked = false;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (isAsked || work.done < 2) return;
    isAsked = true;
    thread->post(taa::request::SetViews{{viewOf(IntermediateId::motion)}});
    thread->post(taa::request::SetProbes{.all = {{.pixel = {3, 3}}}});
  });
  thread->post(taa::request::Seek{40});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 2u);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].frame, 0) << "the frame that was on show";
  EXPECT_EQ(recorder.all<taa::ViewResult>()[1].frame, 40);
  ASSERT_EQ(recorder.all<taa::ProbeResult>().size(), 2u);
  EXPECT_EQ(recorder.all<taa::ProbeResult>()[1].frame, 40);
}

TEST_F(RenderThreadTest, TellsErrorsAndKeepsWhatItShows) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Seek{2});
  thread->waitUntilIdle();
  recorder.clear();
  thread->post(taa::request::Open{"no/such/file.glb"});
  thread->post(taa::request::SetCamera{"sideways"});
  thread->post(taa::request::SetSize{1, 1});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::Failure>().size(), 3u);
  EXPECT_NE(recorder.all<taa::Failure>()[0].sentence.find("file.glb"), std::string::npos)
      << recorder.all<taa::Failure>()[0].sentence;
  EXPECT_TRUE(recorder.all<taa::ViewResult>().empty());
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 3);
  EXPECT_EQ(recorder.all<taa::Status>().back().source, "builtin:fan");
}

TEST_F(RenderThreadTest, KeepsProbingTheSamePixel) {
  thread->post(taa::request::SetProbes{.all = {{.pixel = {5, 6}}}});
  thread->waitUntilIdle();
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::ProbeResult>().size(), 3u);
  for (int frame = 0; frame < 3; ++frame) {
    const taa::ProbeResult& probe = recorder.all<taa::ProbeResult>()[static_cast<std::size_t>(frame)];
    EXPECT_EQ(probe.frame, frame);
    EXPECT_EQ(probe.x, 5);
    EXPECT_EQ(probe.around.size(), 9u);
  }
  thread->post(taa::request::SetProbes{});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::ProbeResult>().size(), 3u) << "taken back";
  thread->post(taa::request::SetProbes{.all = {{.pixel = {kWidth, 0}}}});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::ProbeResult>().size(), 3u) << "outside the picture";
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

// Who hears that shaders were read anew may look at once: the picture on show is not theirs yet.
TEST_F(RenderThreadTest, TellsThatThePictureIsNotExactBeforeNewShadersAreInUse) {
  std::vector<bool> wereExact;
  recorder.on<taa::ShadersRead>([&](const taa::ShadersRead& read) {
    recorder.read([&] {
      wereExact.push_back(recorder.all<taa::Status>().back().exact);
      return wereExact.size();
    });
    EXPECT_EQ(read.error, "");
  });
  thread = std::make_unique<RenderThread>(recorder.listener());
  thread->post(taa::request::SetSize{kWidth, kHeight});
  thread->post(taa::request::Open{"builtin:fan"});
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Seek{4});
  thread->waitUntilIdle();
  ASSERT_TRUE(recorder.all<taa::Status>().back().exact);
  thread->post(taa::request::ReloadShaders{});
  thread->waitUntilIdle();
  EXPECT_EQ(wereExact, std::vector<bool>{false});
  EXPECT_TRUE(recorder.all<taa::Status>().back().exact) << "replayed with them";
}

TEST_F(RenderThreadTest, EndsAtOnceInTheMiddleOfWork) {
  bool isWorking = false;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    const std::lock_guard lock(recorder.mutex);
    isWorking = isWorking || work.done > 1;
  });
  thread->post(taa::request::Seek{239});
  EXPECT_TRUE(recorder.waitFor([&] { return isWorking; }));
  thread.reset();
  EXPECT_LT(recorder.all<taa::Work>().back().done, 200) << "it did not go on to the end";
}

TEST_F(RenderThreadTest, EndsAtOnceBeforeItHasBegun) {
  for (int count = 0; count < 3; ++count) {
    RenderThread brief(taa::Listener{});
    brief.post(taa::request::Open{"builtin:fence"});
  }
}
