#include "app/window/EscapeKey.h"

#include <utility>

namespace taa::app {

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

} // namespace taa::app
