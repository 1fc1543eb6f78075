#include "core/requests/RequestQueue.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

namespace taa {

namespace {

template <typename Old, typename... Overridden>
constexpr bool isAmong(const std::tuple<Overridden...>*) {
  return (std::is_same_v<Old, Overridden> || ...);
}

template <typename New, typename Old>
constexpr bool overrides() {
  if constexpr (std::is_same_v<New, Old>)
    return !New::kRule.addsUp;
  else if constexpr (requires { typename New::Overrides; })
    return isAmong<Old>(static_cast<typename New::Overrides*>(nullptr));
  else
    return false;
}

bool makesVoid(const Request& newer, const Request& older) {
  return std::visit([]<typename New, typename Old>(const New&, const Old&) { return overrides<New, Old>(); },
                    newer, older);
}

bool isSource(const PostedRequest& posted) {
  return std::holds_alternative<request::Open>(posted.request);
}

bool isOfScene(const PostedRequest& posted) {
  return ruleOf(posted.request).isOfScene;
}

} // namespace

// What is asked of the scene that is to be opened leaves alone what was asked of the one that is open.
std::size_t RequestQueue::firstOfScene(const RequestRule& rule) const {
  if (!rule.isOfScene && rule.kind != RequestKind::Source) return 0;
  const auto source = std::ranges::find_if(waiting_, isSource);
  return source == waiting_.end() ? 0 : static_cast<std::size_t>(source - waiting_.begin());
}

void RequestQueue::post(PostedRequest posted) {
  const std::size_t first = firstOfScene(ruleOf(posted.request));
  const auto from = waiting_.begin() + static_cast<std::ptrdiff_t>(first);
  // Another source in place of one that is never opened: what was asked of that is void as well.
  const bool isAnother = isSource(posted) && std::any_of(from, waiting_.end(), isSource);
  waiting_.erase(std::remove_if(from, waiting_.end(),
                                [&](const PostedRequest& older) {
                                  return makesVoid(posted.request, older.request) ||
                                         (isAnother && isOfScene(older));
                                }),
                 waiting_.end());
  waiting_.push_back(std::move(posted));
}

std::optional<request::Open> RequestQueue::takeSource() {
  const auto found = std::ranges::find_if(waiting_, isSource);
  if (found == waiting_.end()) return {};
  source_ = found->id;
  request::Open open = std::get<request::Open>(std::move(found->request));
  waiting_.erase(found);
  return open;
}

void RequestQueue::settleSource(bool isOpened) {
  if (isOpened)
    std::erase_if(waiting_,
                  [&](const PostedRequest& older) { return isOfScene(older) && older.id < source_; });
  else
    for (PostedRequest& each : std::exchange(waiting_, {})) post(std::move(each));
}

std::vector<PostedRequest> RequestQueue::take(Turn turn) {
  const auto rest = std::stable_partition(waiting_.begin(), waiting_.end(), [&](const PostedRequest& posted) {
    return ruleOf(posted.request).turn != turn;
  });
  std::vector<PostedRequest> taken(std::make_move_iterator(rest), std::make_move_iterator(waiting_.end()));
  waiting_.erase(rest, waiting_.end());
  return taken;
}

} // namespace taa
