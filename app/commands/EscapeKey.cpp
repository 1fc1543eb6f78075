#include "app/commands/EscapeKey.h"

#include "app/commands/Flight.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/widgets/Drags.h"
#include "app/widgets/SearchField.h"

#include <QApplication>

#include <utility>

namespace taa::app {

namespace {

/// A key that was to stop some work may come when it has just ended.
constexpr qint64 kLateMs = 400;

} // namespace

std::optional<EscapeTarget> escapeTarget(const EscapeState& state) {
  constexpr std::pair<EscapeTarget, bool EscapeState::*> kOrder[] = {
      {EscapeTarget::Drag, &EscapeState::isDragging},
      {EscapeTarget::SearchText, &EscapeState::hasSearchText},
      {EscapeTarget::SearchField, &EscapeState::isInSearch},
      {EscapeTarget::Work, &EscapeState::isWorking},
      {EscapeTarget::Flight, &EscapeState::isFlying},
      {EscapeTarget::Comparison, &EscapeState::isComparing},
      {EscapeTarget::Probe, &EscapeState::hasProbe}};
  for (const auto& [target, isThere] : kOrder)
    if (state.*isThere) return target;
  return {};
}

EscapeKey::EscapeKey(Session& session, ViewArea& views, Flight& flight, QObject* parent)
    : QObject(parent), session_(session), views_(views), flight_(flight), drags_(new Drags(this)) {
  connect(&session_, &Session::workChanged, this, [this, wasWorking = false]() mutable {
    const bool isWorking = !session_.work().what.empty();
    if (std::exchange(wasWorking, isWorking) && !isWorking) workEnded_.start();
  });
}

EscapeState EscapeKey::state() const {
  const auto* search = qobject_cast<const SearchField*>(QApplication::focusWidget());
  const bool justWorked = workEnded_.isValid() && workEnded_.elapsed() < kLateMs;
  return {.isDragging = drags_->isRunning(),
          .hasSearchText = search && !search->text().isEmpty(),
          .isInSearch = search != nullptr,
          .isWorking = justWorked || !session_.work().what.empty() || session_.status().goal,
          .isFlying = flight_.isOn(),
          .isComparing = static_cast<bool>(views_.active()->comparison()),
          .hasProbe = session_.probes().active() >= 0};
}

void EscapeKey::press() {
  const std::optional<EscapeTarget> target = escapeTarget(state());
  if (!target) return;
  switch (*target) {
  case EscapeTarget::Drag:
    drags_->cancel();
    session_.undoStack().abandonGesture();
    return;
  case EscapeTarget::SearchText:
    static_cast<SearchField*>(QApplication::focusWidget())->clear();
    return;
  case EscapeTarget::SearchField:
    views_.active()->viewport()->setFocus();
    return;
  case EscapeTarget::Work:
    session_.post(request::Cancel{});
    return;
  case EscapeTarget::Flight:
    flight_.setOn(false);
    return;
  case EscapeTarget::Comparison:
    views_.active()->setComparison({});
    return;
  case EscapeTarget::Probe:
    session_.probes().setPixel({});
    return;
  }
}

} // namespace taa::app
