// A value that has been sent to the render thread: what was sent until it has arrived there, then what is
// there.
#pragma once

#include "core/requests/RequestKinds.h"

#include <utility>

namespace taa::app {

template <class Value>
class Pending {
 public:
  Pending() = default;
  explicit Pending(Value value) : value_(std::move(value)) {}

  const Value& value() const { return value_; }
  bool waits() const { return waits_; }
  void sent(Value value, RequestId request) {
    value_ = std::move(value);
    request_ = request;
    waits_ = true;
  }
  /// The present value on the render thread, and the latest request of its kind that was taken up before: a
  /// value that was sent twice with another one between is not taken for the second when the first of them
  /// arrives.
  void arrived(const Value& value, RequestId takenUp) {
    if (waits_ && takenUp < request_) return;
    waits_ = false;
    value_ = value;
  }
  /// The render thread cannot meet this request: then the next value that arrives counts. True: it was this
  /// one's.
  bool refused(RequestId request) { return waits_ && request == request_ && std::exchange(waits_, false); }
  /// What was sent before `request` does not count any more.
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
