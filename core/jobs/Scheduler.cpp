#include "core/jobs/Scheduler.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace taa {

namespace {

template <typename Part, typename Asked>
constexpr bool kHears = requires(Part& part, const Asked& asked) {
  part.take(asked);
};

template <typename Part, typename Asked>
void tellPart(Part& part, const Asked& asked) {
  if constexpr (kHears<Part, Asked>) part.take(asked);
}

} // namespace

Scheduler::Scheduler(const Listener& listener, const WaitingRequests& waiting, JobContext::ClockNow now)
    : jobContext_(listener, waiting, std::move(now)) {}

void Scheduler::takeUp(RequestQueue requests) {
  for (const PostedRequest& posted : requests.waiting())
    jobContext_.noteTaken(ruleOf(posted.request).kind, posted.id);
  for (const Turn turn : kTurns) takeTurn(requests, turn);
  for (Job* job : jobs()) job->settle();
}

// A source decides what becomes of the requests for the scene; poses and recordings are dealt with together.
void Scheduler::takeTurn(RequestQueue& requests, Turn turn) {
  if (turn == Turn::Source) {
    if (const auto open = requests.takeSource()) requests.settleSource(changes_.open(*open));
    return;
  }
  for (const PostedRequest& posted : requests.take(turn))
    std::visit(
        [this]<typename Asked>(const Asked& asked) {
          std::apply(
              [&](auto&... part) {
                static_assert(std::is_same_v<Asked, request::Open> ||
                                  (kHears<std::remove_reference_t<decltype(part)>, Asked> || ...),
                              "nobody hears this request");
                (tellPart(part, asked), ...);
              },
              parts());
        },
        posted.request);
  if (turn == Turn::Flight) flight_.settle();
}

Scheduler::Agenda Scheduler::agenda() {
  Agenda agenda;
  for (Job* job : jobs()) {
    if (job->isDue()) {
      if (!agenda.next) agenda.next = job;
      if (job->isAwaited()) {
        agenda.isAwaited = true;
        return agenda;
      }
    } else if (const auto at = job->wakesAt()) {
      agenda.wakesAt = std::min(agenda.wakesAt.value_or(*at), *at);
    }
  }
  return agenda;
}

void Scheduler::deliver() {
  status_.deliverBefore();
  shaders_.deliver();
  if (jobContext_.isOpen()) {
    views_.deliver();
    probes_.deliver();
    metrics_.deliver();
    objects_.deliver();
    worst_.deliver();
    costing_.deliver();
  }
  status_.deliver();
}

} // namespace taa
