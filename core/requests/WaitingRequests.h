// What work under way may ask of the requests that wait, without holding up whoever posts them.
#pragma once

#include "core/requests/Requests.h"

#include <atomic>
#include <variant>

namespace taa {

/// Written by whoever posts and takes, read by the work.
class WaitingRequests {
 public:
  bool any() const { return bits_ != 0; }
  bool endReplay() const { return (bits_ & kEndsReplay) != 0; }
  bool cancel() const { return (bits_ & kCancels) != 0; }
  bool settings() const { return (bits_ & kSettings) != 0; }
  bool stopOpening() const { return (bits_ & (kCancels | kOpens)) != 0; }

  void add(const Request& request) {
    unsigned bits = kAny;
    if (ruleOf(request).endsReplay) bits |= kEndsReplay;
    if (std::holds_alternative<request::Cancel>(request)) bits |= kCancels;
    if (std::holds_alternative<request::Open>(request)) bits |= kOpens;
    if (std::holds_alternative<request::SetSettings>(request)) bits |= kSettings;
    bits_ |= bits;
  }
  void clear() { bits_ = 0; }
  /// The thread ends: everything stops.
  void end() { bits_ = ~0u; }

 private:
  static constexpr unsigned kAny = 1, kEndsReplay = 2, kCancels = 4, kOpens = 8, kSettings = 16;
  std::atomic<unsigned> bits_ = 0;
};

} // namespace taa
