// A render thread on a small picture whose results are taken down.
#pragma once

#include "core/jobs/RenderThread.h"

#include "core/settings/Parameters.h"
#include "tests/support/GlTest.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <variant>
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
  std::vector<FrameMetrics> metrics;
  std::vector<TraceDelivery> traces;
  std::vector<ObjectArea> areas;
  std::vector<WorstDelivery> worst;
  std::vector<LineageDelivery> lineages;
  std::vector<ExportResult> exports;
  std::vector<VerdictDelivery> verdicts;
  // Also called, without the lock
  std::function<void(const ViewResult&)> onPicture;
  std::function<void(const Work&)> onWork;
  std::function<void(const ShadersRead&)> onShaders;

  template <typename T>
  void add(std::vector<T>& list, T value) {
    {
      const std::lock_guard lock(mutex);
      list.push_back(std::move(value));
    }
    changed.notify_all();
  }
  void take(ViewResult result) {
    if (onPicture) onPicture(result);
    add(pictures, std::move(result));
  }
  void take(ProbeResult result) { add(probes, std::move(result)); }
  void take(Status status) { add(statuses, std::move(status)); }
  void take(Work work) {
    if (onWork) onWork(work);
    add(works, std::move(work));
  }
  void take(Failure failure) {
    {
      const std::lock_guard lock(mutex);
      failures.push_back(failure);
    }
    add(errors, std::move(failure.sentence));
  }
  void take(FrameProfile profile) { add(profiles, std::move(profile)); }
  void take(StageCosts cost) { add(costs, std::move(cost)); }
  void take(Thumbnail thumbnail) { add(thumbnails, std::move(thumbnail)); }
  void take(FrameMetrics result) { add(metrics, std::move(result)); }
  void take(TraceDelivery trace) { add(traces, std::move(trace)); }
  void take(ObjectArea area) { add(areas, std::move(area)); }
  void take(WorstDelivery found) { add(worst, found); }
  void take(LineageDelivery lineage) { add(lineages, std::move(lineage)); }
  void take(ShadersRead read) {
    if (onShaders) onShaders(read);
  }
  void take(ExportResult result) { add(exports, std::move(result)); }
  void take(VerdictDelivery verdict) { add(verdicts, std::move(verdict)); }
  void take(StageShares) {}
  Listener listener() {
    return [this](Answer answer) {
      std::visit([this](auto& result) { take(std::move(result)); }, answer.result);
    };
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
    metrics.clear();
    verdicts.clear();
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
    thread->post(request::SetSize{kWidth, kHeight});
    thread->post(request::Open{"builtin:fan"});
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
