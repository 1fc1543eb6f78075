// A value that is asked of the render thread: what was asked for until the answer is there, then the answer.
#pragma once

#include "core/requests/RequestKinds.h"

#include <utility>

namespace taa::app {

template <class Value>
class Asked {
 public:
  Asked() = default;
  explicit Asked(Value value) : value_(std::move(value)) {}

  const Value& value() const { return value_; }
  bool waits() const { return waits_; }
  void ask(Value value, RequestId request) {
    value_ = std::move(value);
    request_ = request;
    waits_ = true;
  }
  /// The present value on the render thread, which may be from before it was asked.
  void arrived(const Value& value) {
    if (waits_ && !(value == value_)) return;
    waits_ = false;
    value_ = value;
  }
  /// An answer that this request cannot be met: then the next value that arrives counts. True: it was this
  /// one.
  bool refused(RequestId request) { return waits_ && request == request_ && std::exchange(waits_, false); }
  /// What was asked for before `request` does not count any more.
  void giveUpBefore(RequestId request) {
    if (request_ < request) waits_ = false;
  }
  void giveUp() { waits_ = false; }

 private:
  Value value_{};
  RequestId request_ = 0;
  bool waits_ = false;
};

} // namespace taa::app
