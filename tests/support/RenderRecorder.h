// A render thread on a small picture whose results are taken down.
#pragma once

#include "core/jobs/RenderThread.h"

#include "core/base/ListsOf.h"
#include "core/settings/Parameters.h"
#include "tests/support/GlTest.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <variant>

namespace taa::test::onThread {

inline constexpr int kWidth = 32, kHeight = 18;

/// Takes down all that a render thread says; all<T>() is to be read where it is idle, or under the lock.
struct Recorder : ListsOf<Result> {
  std::mutex mutex;
  std::condition_variable changed;

  /// Calls `act` with each result of this type as well, without the lock, and in place of what was called
  /// before.
  template <class T, class Act>
  void on(Act act) {
    also_ = [act](const Result& result) {
      if (const T* each = std::get_if<T>(&result)) act(*each);
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
  template <class T>
  T last() {
    return read([this] { return all<T>().back(); });
  }
  int frame() {
    return read([this] { return all<Status>().empty() ? -1 : all<Status>().back().info.frame; });
  }
  Listener listener() {
    return [this](Answer answer) {
      if (also_) also_(answer.result);
      const auto add = [this]<class T>(T& result) { all<T>().push_back(std::move(result)); };
      read([&] { std::visit(add, answer.result); });
      changed.notify_all();
    };
  }
  void clear() {
    read([this] { forEachList([](auto& list) { list.clear(); }); });
  }

 private:
  std::function<void(const Result&)> also_;
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
