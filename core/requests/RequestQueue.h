// Requests that are asked for and not yet taken up: what a newer one makes void is dropped, the rest keeps
// its order.
#pragma once

#include "core/requests/Requests.h"

#include <optional>
#include <vector>

namespace taa {

struct PostedRequest {
  RequestId id = 0;
  Request request;
};

class RequestQueue {
 public:
  void post(PostedRequest posted);
  bool isEmpty() const { return waiting_.empty(); }
  const std::vector<PostedRequest>& waiting() const { return waiting_; }

  /// Takes out the source that is to be opened; nothing: there is none.
  std::optional<request::Open> takeSource();
  /// What was asked of the scene before that source is void where it could be opened. Where it was refused it
  /// counts, unless something newer makes it void.
  void settleSource(bool isOpened);
  /// Takes out the requests of a turn, in the order in which they were asked for.
  std::vector<PostedRequest> take(Turn turn);

 private:
  std::size_t firstOfScene(const RequestRule& rule) const;
  std::vector<PostedRequest> waiting_; // rising by their ids
  RequestId source_ = 0;               // that was taken out
};

} // namespace taa
