// Wishes in, results out: what the window can rely on.
#include "core/RenderThread.h"

#include "core/settings/Parameters.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace {

using taa::IntermediateId;
using taa::RenderThread;
using taa::Settings;
using taa::ViewRequest;

constexpr int kWidth = 32, kHeight = 18;

/// Takes down all that a render thread says.
struct Recorder {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<taa::ViewResult> pictures;
  std::vector<taa::ProbeResult> probes;
  std::vector<taa::Status> statuses;
  std::vector<taa::Work> works;
  std::vector<std::string> errors;
  std::function<void(const taa::Work&)> onWork; ///< also called, without the lock

  template <typename T>
  void add(std::vector<T>& list, T value) {
    {
      const std::lock_guard lock(mutex);
      list.push_back(std::move(value));
    }
    changed.notify_all();
  }
  taa::RenderListener listener() {
    return {.onPicture = [this](taa::ViewResult result) { add(pictures, std::move(result)); },
            .onProbe = [this](taa::ProbeResult result) { add(probes, std::move(result)); },
            .onStatus = [this](taa::Status status) { add(statuses, std::move(status)); },
            .onWork =
                [this](taa::Work work) {
                  if (onWork) onWork(work);
                  add(works, std::move(work));
                },
            .onError = [this](std::string text) { add(errors, std::move(text)); }};
  }
  /// Until `holds` is true of what was said; false after a minute.
  template <typename Condition>
  bool waitFor(Condition holds) {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, std::chrono::minutes(1), holds);
  }
  template <typename Action>
  auto read(Action action) {
    const std::lock_guard lock(mutex);
    return action();
  }
  int frame() {
    return read([&] { return statuses.empty() ? -1 : statuses.back().info.frame; });
  }
  void clear() {
    const std::lock_guard lock(mutex);
    pictures.clear();
    probes.clear();
    statuses.clear();
    works.clear();
    errors.clear();
  }
};

ViewRequest viewOf(IntermediateId id) {
  return {.id = id,
          .style = taa::defaultStyle(taa::intermediate(id)),
          .transform = {},
          .width = kWidth,
          .height = kHeight};
}

Settings otherSettings() {
  Settings settings;
  taa::applyAssignment(settings, "jitter.period=8");
  return settings;
}

class RenderThreadTest : public taa::test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    thread = std::make_unique<RenderThread>(recorder.listener());
    thread->setSize(kWidth, kHeight);
    thread->open("builtin:fan");
    thread->waitUntilIdle();
  }
  void TearDown() override {
    thread.reset();
    GlTest::TearDown();
  }
  Recorder recorder; // outlives the thread
  std::unique_ptr<RenderThread> thread;
};

} // namespace

TEST_F(RenderThreadTest, TellsWhatItHasOpened) {
  const taa::Status status = recorder.read([&] { return recorder.statuses.back(); });
  EXPECT_EQ(status.source, "builtin:fan");
  EXPECT_EQ(status.width, kWidth);
  EXPECT_EQ(status.height, kHeight);
  EXPECT_GT(status.frameCount, 1);
  EXPECT_EQ(status.jitterPeriod, 16);
  EXPECT_NE(std::ranges::find(status.cameras, status.camera), status.cameras.end());
  EXPECT_FALSE(status.driver.renderer.empty());
  EXPECT_TRUE(recorder.errors.empty());
}

TEST_F(RenderThreadTest, DeliversViewsAndWhatChangesInThem) {
  ViewRequest alpha = viewOf(IntermediateId::alpha);
  thread->setViews({viewOf(IntermediateId::resolved), alpha});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.pictures.size(), 2u);
  EXPECT_EQ(recorder.pictures[0].view, 0);
  EXPECT_EQ(recorder.pictures[1].view, 1);
  EXPECT_EQ(recorder.pictures[1].request, alpha);
  EXPECT_EQ(recorder.pictures[1].picture.width, kWidth);
  EXPECT_TRUE(recorder.pictures[1].values.empty());
  recorder.clear();
  thread->setViews({viewOf(IntermediateId::resolved), alpha});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.pictures.empty()) << "nothing has changed";
  alpha.transform.zoom = 2.0f;
  thread->setViews({viewOf(IntermediateId::resolved), alpha});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.pictures.size(), 1u) << "only what has changed";
  EXPECT_EQ(recorder.pictures[0].view, 1);
  recorder.clear();
  thread->step(1);
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.pictures.size(), 2u);
  EXPECT_EQ(recorder.pictures[0].frame, 1);
  recorder.clear();
  thread->seek(1);
  thread->setSettings({});
  thread->setSize(kWidth, kHeight);
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.pictures.empty()) << "it was all so already";
}

TEST_F(RenderThreadTest, DeliversTheValuesOfVisibleTexels) {
  ViewRequest view = viewOf(IntermediateId::alpha);
  view.withValues = true;
  view.transform = {.origin = {4.5f, 15.0f}, .zoom = 8.0f};
  thread->setViews({view});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.pictures.size(), 1u);
  EXPECT_EQ(recorder.pictures[0].region, (taa::gl::Rect{4, 15, 5, 3}));
  EXPECT_EQ(recorder.pictures[0].values.width, 5);
  EXPECT_EQ(recorder.pictures[0].values.height, 3);
  EXPECT_EQ(recorder.pictures[0].values.at(0, 0)[0], 1.0f) << "frame 0 has no history";
}

TEST_F(RenderThreadTest, GoesWhereTheLastWishSays) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->waitUntilIdle();
  recorder.clear();
  for (int frame = 10; frame < 60; ++frame) thread->seek(frame);
  thread->seek(20);
  for (int count = 0; count < 5; ++count) thread->step(1);
  thread->step(-2);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 23);
  // Wishes that came while it worked may have shown a frame each, but never one for every wish.
  EXPECT_LE(recorder.pictures.size(), 5u);
  EXPECT_EQ(recorder.pictures.back().frame, 23);
  thread->seek(100000);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), recorder.statuses.back().frameCount - 1);
  thread->step(-100000);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 0);
}

TEST_F(RenderThreadTest, ShowsEveryFrameInOrderWhenPlaying) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->waitUntilIdle();
  thread->setPlaying(true);
  EXPECT_TRUE(recorder.waitFor([&] { return recorder.pictures.size() >= 12; }));
  thread->setPlaying(false);
  thread->waitUntilIdle();
  for (std::size_t index = 0; index < recorder.pictures.size(); ++index) {
    EXPECT_EQ(recorder.pictures[index].frame, static_cast<int>(index));
    EXPECT_TRUE(recorder.pictures[index].exact);
  }
  EXPECT_FALSE(recorder.statuses.back().playing);
  EXPECT_EQ(recorder.frame(), recorder.pictures.back().frame);
}

TEST_F(RenderThreadTest, PlaysNoFasterThanTheShot) {
  const auto start = std::chrono::steady_clock::now();
  const int first = recorder.frame();
  thread->setPlaying(true);
  EXPECT_TRUE(recorder.waitFor([&] { return recorder.statuses.back().info.frame >= first + 7; }));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(seconds, 6.0 / recorder.read([&] { return recorder.statuses.back().framesPerSecond; }));
}

TEST_F(RenderThreadTest, StartsAgainAtTheEndOrPausesThere) {
  const int last = recorder.statuses.back().frameCount - 1;
  thread->seek(last - 2);
  thread->waitUntilIdle();
  recorder.clear();
  thread->setPlaying(true);
  EXPECT_TRUE(recorder.waitFor([&] {
    return std::ranges::any_of(recorder.statuses, [](const auto& status) { return status.info.frame == 2; });
  }));
  thread->setLooping(false);
  thread->seek(last - 2);
  EXPECT_TRUE(
      recorder.waitFor([&] { return !recorder.statuses.empty() && !recorder.statuses.back().playing; }));
  EXPECT_EQ(recorder.frame(), last);
  thread->setPlaying(true);
  EXPECT_TRUE(recorder.waitFor(
      [&] { return recorder.statuses.back().playing && recorder.statuses.back().info.frame < last; }));
}

TEST_F(RenderThreadTest, AnswersNewSettingsAtOnceAndThenExactly) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->seek(8);
  thread->waitUntilIdle();
  recorder.clear();
  thread->setSettings(otherSettings());
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.pictures.size(), 2u);
  EXPECT_FALSE(recorder.pictures[0].exact);
  EXPECT_TRUE(recorder.pictures[1].exact);
  EXPECT_EQ(recorder.statuses.back().settings, otherSettings());
  EXPECT_EQ(recorder.statuses.back().jitterPeriod, 8);
  EXPECT_TRUE(recorder.statuses.back().exact);
  const taa::Picture refined = recorder.pictures[1].picture;
  thread.reset();
  taa::Inspector inspector;
  inspector.setSize(kWidth, kHeight);
  inspector.setSettings(otherSettings());
  inspector.open("builtin:fan");
  inspector.seek(8);
  const ViewRequest view = viewOf(IntermediateId::resolved);
  EXPECT_EQ(refined.rgba,
            inspector.picture(view.id, view.style, view.transform, view.width, view.height).rgba);
}

TEST_F(RenderThreadTest, PlaysOnAfterNewSettingsAndIsExactWhenPaused) {
  thread->seek(3);
  thread->setPlaying(true);
  thread->waitUntilIdle();
  recorder.clear();
  thread->setSettings(otherSettings());
  EXPECT_TRUE(recorder.waitFor([&] { return recorder.statuses.size() > 5; }));
  EXPECT_FALSE(recorder.read([&] { return recorder.statuses[4].exact; }));
  thread->setPlaying(false);
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.statuses.back().exact);
}

TEST_F(RenderThreadTest, AnswersViewsAndProbesWhileItReplays) {
  bool isAsked = false;
  recorder.onWork = [&](const taa::Work& work) {
    if (isAsked || work.done < 2) return;
    isAsked = true;
    thread->setViews({viewOf(IntermediateId::motion)});
    thread->probe(glm::ivec2(3, 3));
  };
  thread->seek(40);
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.pictures.size(), 2u);
  EXPECT_EQ(recorder.pictures[0].frame, 0) << "the frame that was on show";
  EXPECT_EQ(recorder.pictures[1].frame, 40);
  ASSERT_EQ(recorder.probes.size(), 2u);
  EXPECT_EQ(recorder.probes[1].frame, 40);
}

TEST_F(RenderThreadTest, StopsLongWorkWhenToldTo) {
  bool isAsked = false;
  recorder.onWork = [&](const taa::Work& work) {
    if (isAsked || work.done < 2) return;
    isAsked = true;
    thread->cancel();
  };
  thread->seek(100);
  thread->waitUntilIdle();
  EXPECT_TRUE(isAsked);
  EXPECT_EQ(recorder.frame(), 0);
  EXPECT_TRUE(recorder.works.back().what.empty()) << "nothing is under way";
  EXPECT_TRUE(recorder.errors.empty());
  thread->step(1);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 1);
}

TEST_F(RenderThreadTest, StopsRefiningWhenToldToAndKeepsTheBadge) {
  thread->seek(30);
  thread->waitUntilIdle();
  bool isAsked = false;
  recorder.onWork = [&](const taa::Work& work) {
    if (isAsked || work.done < 2) return;
    isAsked = true;
    thread->cancel();
  };
  thread->setSettings(otherSettings());
  thread->waitUntilIdle();
  EXPECT_TRUE(isAsked);
  EXPECT_FALSE(recorder.statuses.back().exact);
  EXPECT_EQ(recorder.frame(), 30);
}

TEST_F(RenderThreadTest, LeavesASeekThatANewerOneMakesUseless) {
  bool isAsked = false;
  int furthest = 0;
  recorder.onWork = [&](const taa::Work& work) {
    furthest = std::max(furthest, work.done);
    if (isAsked || work.done < 3) return;
    isAsked = true;
    thread->seek(2);
  };
  thread->seek(200);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 2);
  EXPECT_EQ(furthest, 3);
}

TEST_F(RenderThreadTest, ShowsTheNearestFrameAtHandBeforeTheWishedOne) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->seek(60);
  thread->waitUntilIdle();
  thread->seek(2);
  thread->waitUntilIdle();
  recorder.clear();
  bool isMixed = false;
  recorder.onWork = [&](const taa::Work& work) {
    if (work.what.empty() || work.done < 1) return;
    isMixed = isMixed || recorder.read([&] { return recorder.statuses.back().goal != 75; });
  };
  thread->seek(75);
  thread->waitUntilIdle();
  EXPECT_FALSE(isMixed);
  ASSERT_EQ(recorder.pictures.size(), 2u);
  EXPECT_EQ(recorder.pictures[0].frame, 61) << "one frame from what is kept";
  EXPECT_TRUE(recorder.pictures[0].exact);
  EXPECT_EQ(recorder.pictures[1].frame, 75);
  EXPECT_EQ(recorder.statuses.back().info.frame, 75);
  EXPECT_EQ(recorder.statuses.back().goal, std::nullopt);
  bool isTold = false;
  for (const taa::Status& status : recorder.statuses) {
    isTold = isTold || status.info.frame == 61;
    EXPECT_TRUE(status.info.frame != 61 || status.goal == 75);
  }
  EXPECT_TRUE(isTold);
  EXPECT_NE(recorder.pictures[0].picture.rgba, recorder.pictures[1].picture.rgba);
}

TEST_F(RenderThreadTest, ShowsFramesThatAreKeptWithoutAnotherBefore) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->seek(60);
  thread->waitUntilIdle();
  recorder.clear();
  thread->seek(20);
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.pictures.size(), 1u);
  EXPECT_EQ(recorder.pictures[0].frame, 20);
  for (const taa::Status& status : recorder.statuses) EXPECT_EQ(status.goal, std::nullopt);
}

TEST_F(RenderThreadTest, RefinesWhereTheScrubbingEnds) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->waitUntilIdle();
  thread->setCheckpointBudget(20 * kWidth * kHeight * 16);
  thread->seek(239);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.statuses.back().checkpointBudget, std::size_t{20 * kWidth * kHeight * 16});
  recorder.clear();
  int next = 230;
  // As a mouse that is dragged while it replays: each time the first frame of the way is done.
  recorder.onWork = [&](const taa::Work& work) {
    if (work.done != 1 || next < 70) return;
    thread->seek(next);
    next -= 31;
  };
  thread->seek(235 - 31);
  thread->waitUntilIdle();
  EXPECT_LT(next, 70);
  EXPECT_EQ(recorder.frame(), next + 31);
  EXPECT_EQ(recorder.pictures.back().frame, next + 31);
  EXPECT_TRUE(recorder.pictures.back().exact);
  EXPECT_GT(recorder.pictures.size(), 2u) << "frames near the mouse on the way";
  EXPECT_EQ(recorder.statuses.back().goal, std::nullopt);
}

TEST_F(RenderThreadTest, TakesBackTheGoalWhenToldToStop) {
  bool isAsked = false;
  recorder.onWork = [&](const taa::Work& work) {
    if (std::exchange(isAsked, isAsked || work.done >= 2) || !isAsked) return;
    thread->cancel();
  };
  thread->seek(100);
  thread->waitUntilIdle();
  EXPECT_TRUE(isAsked);
  const auto told = [](const taa::Status& status) { return status.goal == 100; };
  EXPECT_TRUE(std::ranges::any_of(recorder.statuses, told));
  EXPECT_EQ(recorder.statuses.back().goal, std::nullopt);
  EXPECT_EQ(recorder.frame(), 0);
}

TEST_F(RenderThreadTest, StartsAgainWhenSettingsChangeWhileItReplays) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->seek(200);
  thread->waitUntilIdle();
  recorder.clear();
  Settings third = otherSettings();
  taa::applyAssignment(third, "rectify.method=clamp");
  bool isAsked = false;
  int furthest = 0;
  recorder.onWork = [&](const taa::Work& work) {
    if (!isAsked) furthest = std::max(furthest, work.done);
    if (isAsked || work.done < 20) return;
    isAsked = true;
    thread->setSettings(third);
  };
  thread->setSettings(otherSettings());
  thread->waitUntilIdle();
  EXPECT_EQ(furthest, 20);
  const auto isWholeWay = [](const taa::Work& work) { return work.done == 200 && work.total == 201; };
  EXPECT_EQ(std::ranges::count_if(recorder.works, isWholeWay), 1) << "once, with progress";
  EXPECT_EQ(recorder.works.front().what, "Replaying with the new settings");
  ASSERT_EQ(recorder.pictures.size(), 3u) << "at once, at once again, exactly";
  for (std::size_t index = 0; index < 3; ++index) {
    EXPECT_EQ(recorder.pictures[index].frame, 200);
    EXPECT_EQ(recorder.pictures[index].exact, index == 2);
  }
  EXPECT_EQ(recorder.statuses.back().settings, third);
  EXPECT_TRUE(recorder.statuses.back().exact);
}

TEST_F(RenderThreadTest, SaysThatAPictureIsNotExactBeforeItCanBeSeen) {
  // Statuses and pictures in the order they came, as a window without any patience would show them.
  std::optional<taa::Status> status;
  int seen = 0;
  taa::RenderListener listener;
  listener.onStatus = [&](taa::Status next) { status = std::move(next); };
  listener.onPicture = [&](taa::ViewResult result) {
    ++seen;
    ASSERT_TRUE(status);
    EXPECT_TRUE(result.exact || !status->exact);
    EXPECT_TRUE(result.frame == status->info.frame || !status->goal || status->goal == result.frame);
  };
  thread = std::make_unique<RenderThread>(listener);
  thread->setSize(kWidth, kHeight);
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->open("builtin:fan");
  for (const int frame : {60, 2, 75, 200}) {
    thread->seek(frame);
    thread->waitUntilIdle();
    thread->setSettings(frame % 4 == 0 ? otherSettings() : Settings());
    thread->waitUntilIdle();
  }
  EXPECT_GE(seen, 9);
}

TEST_F(RenderThreadTest, TellsErrorsAndKeepsWhatItShows) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->seek(2);
  thread->waitUntilIdle();
  recorder.clear();
  thread->open("no/such/file.glb");
  thread->setCamera("sideways");
  thread->setSize(1, 1);
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.errors.size(), 3u);
  EXPECT_NE(recorder.errors[0].find("file.glb"), std::string::npos) << recorder.errors[0];
  EXPECT_TRUE(recorder.pictures.empty());
  thread->step(1);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 3);
  EXPECT_EQ(recorder.statuses.back().source, "builtin:fan");
}

TEST_F(RenderThreadTest, KeepsProbingTheSamePixel) {
  thread->probe(glm::ivec2(5, 6));
  thread->waitUntilIdle();
  thread->step(1);
  thread->waitUntilIdle();
  thread->step(1);
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.probes.size(), 3u);
  for (int frame = 0; frame < 3; ++frame) {
    const taa::ProbeResult& probe = recorder.probes[static_cast<std::size_t>(frame)];
    EXPECT_EQ(probe.frame, frame);
    EXPECT_EQ(probe.x, 5);
    EXPECT_EQ(probe.around.size(), 9u);
  }
  thread->probe({});
  thread->step(1);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.probes.size(), 3u) << "taken back";
  thread->probe(glm::ivec2(kWidth, 0));
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.probes.size(), 3u) << "outside the picture";
  EXPECT_TRUE(recorder.errors.empty());
}

TEST_F(RenderThreadTest, EndsAtOnceInTheMiddleOfWork) {
  bool isWorking = false;
  recorder.onWork = [&](const taa::Work& work) {
    const std::lock_guard lock(recorder.mutex);
    isWorking = isWorking || work.done > 1;
  };
  thread->seek(239);
  EXPECT_TRUE(recorder.waitFor([&] { return isWorking; }));
  thread.reset();
  EXPECT_LT(recorder.works.back().done, 200) << "it did not go on to the end";
}

TEST_F(RenderThreadTest, EndsAtOnceBeforeItHasBegun) {
  for (int count = 0; count < 3; ++count) {
    RenderThread brief(taa::RenderListener{});
    brief.open("builtin:fence");
  }
}
