// Long ways through time and settings that change meanwhile: what is shown until they are done, and what ends
// them.
#include "tests/support/RenderRecorder.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace {

using taa::IntermediateId;
using taa::RenderThread;
using taa::Settings;
using taa::ViewRequest;
using taa::test::otherJitter;
using taa::test::onThread::kHeight;
using taa::test::onThread::kWidth;
using taa::test::onThread::viewOf;

class RenderThreadTimeTest : public taa::test::onThread::RenderThreadTest {};

} // namespace

TEST_F(RenderThreadTimeTest, AnswersNewSettingsAtOnceAndThenExactly) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Seek{8});
  thread->waitUntilIdle();
  recorder.clear();
  thread->post(taa::request::SetSettings{otherJitter()});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 2u);
  EXPECT_FALSE(recorder.all<taa::ViewResult>()[0].exact);
  EXPECT_TRUE(recorder.all<taa::ViewResult>()[1].exact);
  EXPECT_EQ(recorder.all<taa::Status>().back().settings, otherJitter());
  EXPECT_EQ(recorder.all<taa::Status>().back().jitterPeriod, 8);
  EXPECT_TRUE(recorder.all<taa::Status>().back().exact);
  const taa::Picture refined = recorder.all<taa::ViewResult>()[1].picture;
  thread.reset();
  taa::Inspector inspector;
  inspector.shot().setSize(kWidth, kHeight);
  inspector.shot().setSettings(otherJitter());
  inspector.shot().open("builtin:fan");
  inspector.shot().seek(8);
  const ViewRequest view = viewOf(IntermediateId::resolved);
  EXPECT_EQ(refined.rgba,
            inspector.views().picture(view.id, view.style, view.transform, view.width, view.height).rgba);
}

TEST_F(RenderThreadTimeTest, StopsLongWorkWhenToldTo) {
  bool isAsked = false;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (isAsked || work.done < 2) return;
    isAsked = true;
    thread->post(taa::request::Cancel{});
  });
  thread->post(taa::request::Seek{100});
  thread->waitUntilIdle();
  EXPECT_TRUE(isAsked);
  EXPECT_EQ(recorder.frame(), 0);
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty()) << "nothing is under way";
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 1);
}

TEST_F(RenderThreadTimeTest, StopsRefiningWhenToldToAndKeepsTheBadge) {
  thread->post(taa::request::Seek{30});
  thread->waitUntilIdle();
  bool isAsked = false;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (isAsked || work.done < 2) return;
    isAsked = true;
    thread->post(taa::request::Cancel{});
  });
  thread->post(taa::request::SetSettings{otherJitter()});
  thread->waitUntilIdle();
  EXPECT_TRUE(isAsked);
  EXPECT_FALSE(recorder.all<taa::Status>().back().exact);
  EXPECT_EQ(recorder.frame(), 30);
}

TEST_F(RenderThreadTimeTest, LeavesASeekThatANewerOneMakesUseless) {
  bool isAsked = false;
  int furthest = 0;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    furthest = std::max(furthest, work.done);
    if (isAsked || work.done < 3) return;
    isAsked = true;
    thread->post(taa::request::Seek{2});
  });
  thread->post(taa::request::Seek{200});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 2);
  EXPECT_EQ(furthest, 3);
}

TEST_F(RenderThreadTimeTest, ShowsTheNearestCachedFrameBeforeTheRequestedOne) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Seek{60});
  thread->waitUntilIdle();
  thread->post(taa::request::Seek{2});
  thread->waitUntilIdle();
  recorder.clear();
  bool isMixed = false;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (work.what.empty() || work.done < 1) return;
    isMixed = isMixed || recorder.read([&] { return recorder.all<taa::Status>().back().goal != 75; });
  });
  thread->post(taa::request::Seek{75});
  thread->waitUntilIdle();
  EXPECT_FALSE(isMixed);
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 2u);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].frame, 61) << "one frame from what is kept";
  EXPECT_TRUE(recorder.all<taa::ViewResult>()[0].exact);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[1].frame, 75);
  EXPECT_EQ(recorder.all<taa::Status>().back().info.frame, 75);
  EXPECT_EQ(recorder.all<taa::Status>().back().goal, std::nullopt);
  bool isTold = false;
  for (const taa::Status& status : recorder.all<taa::Status>()) {
    isTold = isTold || status.info.frame == 61;
    EXPECT_TRUE(status.info.frame != 61 || status.goal == 75);
  }
  EXPECT_TRUE(isTold);
  EXPECT_NE(recorder.all<taa::ViewResult>()[0].picture.rgba, recorder.all<taa::ViewResult>()[1].picture.rgba);
}

TEST_F(RenderThreadTimeTest, ShowsFramesThatAreKeptWithoutAnotherBefore) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Seek{60});
  thread->waitUntilIdle();
  recorder.clear();
  thread->post(taa::request::Seek{20});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 1u);
  EXPECT_EQ(recorder.all<taa::ViewResult>()[0].frame, 20);
  for (const taa::Status& status : recorder.all<taa::Status>()) EXPECT_EQ(status.goal, std::nullopt);
}

TEST_F(RenderThreadTimeTest, RefinesWhereTheScrubbingEnds) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->waitUntilIdle();
  thread->post(taa::request::SetCheckpointBudget{20 * kWidth * kHeight * 16});
  thread->post(taa::request::Seek{239});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::Status>().back().checkpointBudget, std::size_t{20 * kWidth * kHeight * 16});
  recorder.clear();
  int next = 230;
  // As a mouse that is dragged while it replays: each time the first frame of the way is done.
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (work.done != 1 || next < 70) return;
    thread->post(taa::request::Seek{next});
    next -= 31;
  });
  thread->post(taa::request::Seek{235 - 31});
  thread->waitUntilIdle();
  EXPECT_LT(next, 70);
  EXPECT_EQ(recorder.frame(), next + 31);
  EXPECT_EQ(recorder.all<taa::ViewResult>().back().frame, next + 31);
  EXPECT_TRUE(recorder.all<taa::ViewResult>().back().exact);
  EXPECT_GT(recorder.all<taa::ViewResult>().size(), 2u) << "frames near the mouse on the way";
  EXPECT_EQ(recorder.all<taa::Status>().back().goal, std::nullopt);
}

TEST_F(RenderThreadTimeTest, TakesBackTheGoalWhenToldToStop) {
  bool isAsked = false;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (std::exchange(isAsked, isAsked || work.done >= 2) || !isAsked) return;
    thread->post(taa::request::Cancel{});
  });
  thread->post(taa::request::Seek{100});
  thread->waitUntilIdle();
  EXPECT_TRUE(isAsked);
  const auto told = [](const taa::Status& status) { return status.goal == 100; };
  EXPECT_TRUE(std::ranges::any_of(recorder.all<taa::Status>(), told));
  EXPECT_EQ(recorder.all<taa::Status>().back().goal, std::nullopt);
  EXPECT_EQ(recorder.frame(), 0);
}

TEST_F(RenderThreadTimeTest, StartsAgainWhenSettingsChangeWhileItReplays) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Seek{200});
  thread->waitUntilIdle();
  recorder.clear();
  Settings third = otherJitter();
  taa::applyAssignment(third, "rectify.method=clamp");
  bool isAsked = false;
  int furthest = 0;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (!isAsked) furthest = std::max(furthest, work.done);
    if (isAsked || work.done < 20) return;
    isAsked = true;
    thread->post(taa::request::SetSettings{third});
  });
  thread->post(taa::request::SetSettings{otherJitter()});
  thread->waitUntilIdle();
  EXPECT_EQ(furthest, 20);
  const auto isWholeWay = [](const taa::Work& work) { return work.done == 200 && work.total == 201; };
  EXPECT_EQ(std::ranges::count_if(recorder.all<taa::Work>(), isWholeWay), 1) << "once, with progress";
  EXPECT_EQ(recorder.all<taa::Work>().front().what, "Replaying with the new settings");
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 3u) << "at once, at once again, exactly";
  for (std::size_t index = 0; index < 3; ++index) {
    EXPECT_EQ(recorder.all<taa::ViewResult>()[index].frame, 200);
    EXPECT_EQ(recorder.all<taa::ViewResult>()[index].exact, index == 2);
  }
  EXPECT_EQ(recorder.all<taa::Status>().back().settings, third);
  EXPECT_TRUE(recorder.all<taa::Status>().back().exact);
}

TEST_F(RenderThreadTimeTest, SaysThatAPictureIsNotExactBeforeItCanBeSeen) {
  // Statuses and pictures in the order they came, as a window without any patience would show them.
  std::optional<taa::Status> status;
  int seen = 0;
  const auto listener = [&](const taa::Answer& answer) {
    if (const auto* next = std::get_if<taa::Status>(&answer.result)) status = *next;
    const auto* result = std::get_if<taa::ViewResult>(&answer.result);
    if (!result) return;
    ++seen;
    ASSERT_TRUE(status);
    EXPECT_TRUE(result->exact || !status->exact);
    EXPECT_TRUE(result->frame == status->info.frame || !status->goal || status->goal == result->frame);
  };
  thread = std::make_unique<RenderThread>(listener);
  thread->post(taa::request::SetSize{kWidth, kHeight});
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Open{"builtin:fan"});
  for (const int frame : {60, 2, 75, 200}) {
    thread->post(taa::request::Seek{frame});
    thread->waitUntilIdle();
    thread->post(taa::request::SetSettings{frame % 4 == 0 ? otherJitter() : Settings()});
    thread->waitUntilIdle();
  }
  EXPECT_GE(seen, 9);
}
