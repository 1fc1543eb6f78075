// Times of passes, by queries or by the wall clock.
#include "core/gl/PassTimer.h"

#include <epoxy/gl.h>

#include <utility>

namespace taa::gl {

thread_local PassTimer* PassTimer::current_ = nullptr;

TimingMethod timingMethodFor(const Driver& driver) {
  return driver.isSoftware ? TimingMethod::Finish : TimingMethod::Queries;
}

PassTimer::PassTimer(TimingMethod method) : outer_(std::exchange(current_, this)), method_(method) {}

PassTimer::~PassTimer() {
  current_ = outer_;
  recycle();
  glDeleteQueries(static_cast<GLsizei>(free_.size()), free_.data());
}

void PassTimer::recycle() {
  if (method_ == TimingMethod::Queries)
    for (const Sample& sample : samples_) free_.insert(free_.end(), {sample.first, sample.last});
  samples_.clear();
}

void PassTimer::startFrame() {
  if (!current_) return;
  current_->recycle();
  ++current_->frames_;
}

unsigned PassTimer::query() {
  GLuint id = 0;
  if (free_.empty()) {
    glCreateQueries(GL_TIMESTAMP, 1, &id);
  } else {
    id = free_.back();
    free_.pop_back();
  }
  glQueryCounter(id, GL_TIMESTAMP);
  return id;
}

void PassTimer::begin(const std::string& pass) {
  PassTimer* timer = current_;
  if (!timer) return;
  timer->samples_.push_back({{pass, std::string(timer->group_)}});
  if (timer->method_ == TimingMethod::Queries) {
    timer->samples_.back().first = timer->query();
    return;
  }
  glFinish(); // what came before is not this pass's
  timer->start_ = Clock::now();
}

void PassTimer::end() {
  PassTimer* timer = current_;
  if (!timer || timer->samples_.empty()) return; // it came in the middle of a pass
  Sample& sample = timer->samples_.back();
  if (timer->method_ == TimingMethod::Queries) {
    sample.last = timer->query();
    return;
  }
  glFinish();
  sample.time.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - timer->start_).count();
}

std::vector<PassTime> PassTimer::take() {
  std::vector<PassTime> times;
  times.reserve(samples_.size());
  for (Sample& sample : samples_) {
    if (method_ == TimingMethod::Queries) {
      GLuint64 first = 0, last = 0; // ns
      glGetQueryObjectui64v(sample.first, GL_QUERY_RESULT, &first);
      glGetQueryObjectui64v(sample.last, GL_QUERY_RESULT, &last);
      sample.time.milliseconds = static_cast<double>(last - first) * 1e-6;
    }
    times.push_back(std::move(sample.time));
  }
  recycle();
  return times;
}

PassGroup::PassGroup(std::string_view name)
    : timer_(PassTimer::current_), outer_(timer_ ? std::exchange(timer_->group_, name) : name) {}

PassGroup::~PassGroup() {
  if (timer_ && timer_ == PassTimer::current_) timer_->group_ = outer_;
}

} // namespace taa::gl
