// A render thread on a small picture whose results are taken down.
#pragma once

#include "core/RenderThread.h"

#include "core/settings/Parameters.h"
#include "tests/support/GlTest.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace taa::test::onThread {

inline constexpr int kWidth = 32, kHeight = 18;

/// Takes down all that a render thread says.
struct Recorder {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<ViewResult> pictures;
  std::vector<ProbeResult> probes;
  std::vector<Status> statuses;
  std::vector<Work> works;
  std::vector<std::string> errors;
  std::vector<Failure> failures; ///< the same, with what they answer
  std::vector<FrameProfile> profiles;
  std::vector<StageCosts> costs;
  std::vector<Thumbnail> thumbnails;
  std::vector<FrameFigures> figures;
  std::vector<TraceDelivery> traces;
  std::function<void(const Work&)> onWork; ///< also called, without the lock

  template <typename T>
  void add(std::vector<T>& list, T value) {
    {
      const std::lock_guard lock(mutex);
      list.push_back(std::move(value));
    }
    changed.notify_all();
  }
  RenderListener listener() {
    return {.onPicture = [this](ViewResult result) { add(pictures, std::move(result)); },
            .onProbe = [this](ProbeResult result) { add(probes, std::move(result)); },
            .onStatus = [this](Status status) { add(statuses, std::move(status)); },
            .onWork =
                [this](Work work) {
                  if (onWork) onWork(work);
                  add(works, std::move(work));
                },
            .onError =
                [this](Failure failure) {
                  {
                    const std::lock_guard lock(mutex);
                    failures.push_back(failure);
                  }
                  add(errors, std::move(failure.sentence));
                },
            .onProfile = [this](FrameProfile profile) { add(profiles, std::move(profile)); },
            .onStageCosts = [this](StageCosts cost) { add(costs, std::move(cost)); },
            .onThumbnail = [this](Thumbnail thumbnail) { add(thumbnails, std::move(thumbnail)); },
            .onFigures = [this](FrameFigures result) { add(figures, result); },
            .onTrace = [this](TraceDelivery trace) { add(traces, std::move(trace)); }};
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
    traces.clear();
    errors.clear();
    failures.clear();
    figures.clear();
  }
};

inline ViewRequest viewOf(IntermediateId id) {
  return {
      .id = id, .style = defaultStyle(intermediate(id)), .transform = {}, .width = kWidth, .height = kHeight};
}

class RenderThreadTest : public GlTest {
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

} // namespace taa::test::onThread
