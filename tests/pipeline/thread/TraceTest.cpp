// Traces of probes on the render thread: what is shown adds to them, the rest is filled in beside it, and
// taa-batch prints the same. And how time goes on in a part of the shot.
#include "core/base/NumberText.h"
#include "core/gl/ContextLock.h"
#include "core/inspect/Inspector.h"
#include "core/io/FrameJson.h"
#include "core/report/TraceText.h"
#include "tests/support/Batch.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"
#include "tests/support/RenderRecorder.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <future>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace taa;
using taa::test::onThread::viewOf;

namespace {

/// Bit for bit: rows that nobody asked for are NaN.
bool isSame(const PixelRecord& a, const PixelRecord& b) {
  return std::memcmp(a.data(), b.data(), sizeof(PixelRecord)) == 0;
}

class TraceTest : public taa::test::onThread::RenderThreadTest {
 protected:
  void SetUp() override {
    RenderThreadTest::SetUp();
    if (!thread) return;
    thread->post(taa::request::SetProbes{{probe}, 0});
    thread->post(taa::request::SetTracing{true});
    thread->waitUntilIdle();
  }
  std::vector<int> frames() {
    return recorder.read([&] {
      std::vector<int> frames;
      for (const TraceDelivery& trace : recorder.all<TraceDelivery>()) frames.push_back(trace.frame);
      return frames;
    });
  }
  ProbeTrace trace() {
    return recorder.read([&] {
      ProbeTrace traced{probe, {}};
      for (const TraceDelivery& each : recorder.all<TraceDelivery>())
        traced.trace.add(each.frame, each.sample);
      return traced;
    });
  }
  const Probe probe{{20, 7}, Follow::Screen, 0, {}};
};

} // namespace

TEST_F(TraceTest, EveryExactFrameOnShowAddsWhatItsProbeSays) {
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(frames(), (std::vector{0, 1, 2}));
  EXPECT_TRUE(isSame(recorder.all<TraceDelivery>().back().sample.record,
                     recorder.all<ProbeResult>().back().around[4]));
  thread->post(taa::request::SetTracing{false});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(frames().size(), 3u) << "nobody looks any more";
}

TEST_F(TraceTest, IsFilledInBesideWhatIsOnShowWithTheSameBits) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Seek{12});
  thread->waitUntilIdle();
  recorder.clear();
  thread->post(taa::request::FillTraces{3, 14});
  thread->waitUntilIdle();
  const std::vector<int> filled = frames();
  EXPECT_EQ(filled, (std::vector{3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14})) << "12 was known";
  EXPECT_TRUE(recorder.all<ViewResult>().empty()) << "what is shown stays";
  EXPECT_EQ(recorder.all<Work>().back().what, "");
  EXPECT_TRUE(std::ranges::any_of(recorder.all<Work>(),
                                  [](const Work& work) { return work.kind == WorkKind::Traces; }));
  const ProbeTrace traced = trace();
  for (const int frame : {3, 8, 14}) {
    thread->post(taa::request::Seek{frame});
    thread->waitUntilIdle();
    EXPECT_EQ(recorder.all<ProbeResult>().back().frame, frame);
    EXPECT_TRUE(isSame(recorder.all<ProbeResult>().back().around[4], traced.trace.at(frame)->record))
        << frame;
  }
  recorder.clear();
  thread->post(taa::request::FillTraces{3, 14});
  thread->waitUntilIdle();
  EXPECT_TRUE(frames().empty()) << "all is known";
}

TEST_F(TraceTest, IsFilledInInIdleTimeWithoutProgressAndStops) {
  const auto waitFor = [&](std::size_t count) {
    for (int turn = 0; turn < 600 && frames().size() < count; ++turn) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      thread->waitUntilIdle(); // which does not wait for it, but delivers
    }
  };
  recorder.clear();
  thread->post(taa::request::TraceInIdleTime{2, 6});
  waitFor(5);
  std::vector<int> filled = frames();
  std::ranges::sort(filled);
  EXPECT_EQ(filled, (std::vector{2, 3, 4, 5, 6}));
  for (const Work& work : recorder.all<Work>())
    EXPECT_NE(work.kind, WorkKind::Traces) << "nobody waits for it";
  recorder.clear();
  thread->post(taa::request::Cancel{});
  thread->post(taa::request::SetSettings{test::otherJitter()});
  thread->waitUntilIdle();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  thread->waitUntilIdle();
  EXPECT_LE(frames().size(), 1u) << "only the frame on show";
}

TEST_F(TraceTest, WhatIsKnownEndsWithTheSettings) {
  thread->post(taa::request::FillTraces{0, 3});
  thread->waitUntilIdle();
  const std::uint64_t before = recorder.all<Status>().back().shotVersion;
  recorder.clear();
  thread->post(taa::request::SetSettings{test::otherJitter()});
  thread->waitUntilIdle();
  EXPECT_GT(recorder.all<Status>().back().shotVersion, before);
  thread->post(taa::request::FillTraces{0, 3});
  thread->waitUntilIdle();
  EXPECT_EQ(frames(), (std::vector{0, 1, 2, 3}));
  for (const TraceDelivery& each : recorder.all<TraceDelivery>())
    EXPECT_EQ(each.shotVersion, recorder.all<Status>().back().shotVersion);
}

// Of a range that ends before the shot begins; a frame before the first one has no history to look for.
TEST_F(TraceTest, NothingIsFilledInWhereNoFrameIs) {
  thread->post(taa::request::Seek{5});
  thread->waitUntilIdle();
  recorder.clear();
  for (const auto& [first, last] : {std::pair(5, -1), std::pair(-7, -3), std::pair(100'000, 200'000)}) {
    thread->post(taa::request::FillTraces{first, last});
    thread->waitUntilIdle();
  }
  EXPECT_TRUE(recorder.all<TraceDelivery>().empty());
}

TEST_F(TraceTest, FillingInIsCancelledAndAnswersRequestsMeanwhile) {
  bool isAsked = false;
  recorder.on<Work>([&](const Work& work) {
    if (work.kind != WorkKind::Traces || work.done < 5 || isAsked) return;
    isAsked = true;
    thread->post(taa::request::Cancel{});
  });
  thread->post(taa::request::FillTraces{0, 100});
  thread->waitUntilIdle();
  EXPECT_TRUE(isAsked);
  EXPECT_LT(frames().size(), 20u);
  isAsked = false;
  recorder.clear();
  recorder.on<Work>([&](const Work& work) {
    if (work.kind != WorkKind::Traces || isAsked) return;
    isAsked = true;
    thread->post(taa::request::Step{1});
  });
  thread->post(taa::request::FillTraces{0, 20});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.frame(), 1);
  std::map<int, int> times;
  for (const int frame : frames()) ++times[frame];
  EXPECT_TRUE(times.contains(20)) << "it goes on afterwards";
}

TEST_F(TraceTest, IsWhatTaaBatchPrints) {
  thread->post(taa::request::FillTraces{2, 9});
  thread->waitUntilIdle();
  ProbeTrace traced = trace();
  ProbeTrace range{probe, {}};
  for (int frame = 2; frame <= 9; ++frame) range.trace.add(frame, *traced.trace.at(frame));
  const std::string here =
      traceCsv({range}, {IntermediateId::alpha, IntermediateId::resolved, IntermediateId::rejectReason}, {});
  const auto printed =
      test::runProcess({test::binary("taa-batch").string(), "trace", "builtin:fan", "--size", "32x18",
                        "--pixel", "20,7", "--frames", "2..9", "--emit", "alpha,resolved,rejectReason"});
  EXPECT_EQ(printed.exitCode, 0) << printed.err;
  EXPECT_EQ(printed.out, here);
  const auto outside = test::runProcess({test::binary("taa-batch").string(), "trace", "builtin:fan", "--size",
                                         "32x18", "--pixel", "32,0", "--frames", "0"});
  EXPECT_EQ(outside.exitCode, 2);
  EXPECT_NE(outside.err.find("outside the picture"), std::string::npos) << outside.err;
}

// What no resolve knows is drawn where it is named.
TEST_F(TraceTest, OfTheReferenceIsWhatThePictureShows) {
  const auto printed = test::batch({"trace", "builtin:fan", "--size", "32x18", "--pixel", "20,7", "--frames",
                                    "3", "--emit", "reference", "--reference-samples", "8"});
  ASSERT_EQ(printed.exitCode, 0) << printed.err;
  const auto of = [] {
    const gl::ContextLock turn;
    Inspector inspector;
    inspector.shot().setSize(32, 18);
    inspector.shot().open("builtin:fan");
    inspector.shot().seek(3);
    inspector.reference().refine(8);
    return inspector.views().image(IntermediateId::reference, 0, gl::Rect{20, 7, 1, 1});
  };
  const Image there = std::async(std::launch::async, of).get();
  std::string line = "1,3,20,7";
  for (int channel = 0; channel < 3; ++channel)
    line += "," + shortestText(there.pixels[static_cast<std::size_t>(channel)]);
  EXPECT_NE(printed.out.find(line), std::string::npos) << printed.out;
  const auto all = test::batch(
      {"trace", "builtin:fan", "--size", "32x18", "--pixel", "20,7", "--frames", "3", "--emit", "all"});
  EXPECT_EQ(all.out.find("reference"), std::string::npos) << "no column that is empty";
}

TEST_F(TraceTest, APartOfTheShotRepeats) {
  thread->post(
      taa::request::SetPlayback{{.framesPerSecond = 1000.0, .speed = 1.0, .range = std::pair(4, 7)}});
  thread->post(taa::request::SetPlaying{true});
  std::vector<int> shown;
  const bool repeats = recorder.waitFor([&] {
    shown.clear();
    for (const Status& status : recorder.all<Status>())
      if (shown.empty() || shown.back() != status.info.frame) shown.push_back(status.info.frame);
    return std::ranges::count(shown, 4) >= 3;
  });
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  ASSERT_TRUE(repeats);
  const auto start = std::ranges::find(shown, 4);
  int expected = 4;
  for (auto frame = start; frame != shown.end(); ++frame) {
    EXPECT_EQ(*frame, expected);
    expected = expected == 7 ? 4 : expected + 1;
  }
  EXPECT_EQ(std::vector(shown.begin(), start), std::vector{0}) << "frames before it lead into it";
  const Status last = recorder.all<Status>().back();
  EXPECT_TRUE(std::ranges::binary_search(last.keptFrames, last.info.frame));
  EXPECT_EQ(last.playback.range, std::pair(4, 7));
}

TEST_F(TraceTest, ThePartIsPlayedOnceWithoutRepeating) {
  thread->post(taa::request::SetLooping{false});
  thread->post(
      taa::request::SetPlayback{{.framesPerSecond = 1000.0, .speed = 1.0, .range = std::pair(0, 3)}});
  thread->post(taa::request::SetPlaying{true});
  ASSERT_TRUE(recorder.waitFor([&] {
    return !recorder.all<Status>().empty() && !recorder.all<Status>().back().playing &&
           recorder.all<Status>().back().info.frame == 3;
  }));
}
