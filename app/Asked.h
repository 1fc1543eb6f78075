// A value that is asked of the render thread: what was asked for until the answer is there, then the answer.
#pragma once

#include <utility>

namespace taa::app {

template <class Value>
class Asked {
 public:
  const Value& value() const { return value_; }
  void ask(Value value) {
    value_ = std::move(value);
    waits_ = true;
  }
  /// The present value on the render thread, which may be from before it was asked.
  void arrived(const Value& value) {
    if (waits_ && !(value == value_)) return;
    waits_ = false;
    value_ = value;
  }
  /// What was asked for will not come: the next one that arrives counts.
  void giveUp() { waits_ = false; }

 private:
  Value value_{};
  bool waits_ = false;
};

} // namespace taa::app
