#include "app/session/VerdictChoices.h"

#include "app/session/Outbox.h"
#include "app/session/PresetChoices.h"
#include "app/session/ProbeChoices.h"
#include "core/settings/Parameters.h"

#include <utility>

namespace taa::app {

void VerdictChoices::setOn(bool on) {
  if (on == isOn_) return;
  const bool wasWanted = isWanted();
  isOn_ = on;
  send(wasWanted);
  Q_EMIT changed();
}

void VerdictChoices::setShown(bool shown) {
  const bool wasWanted = isWanted();
  isShown_ = shown;
  send(wasWanted);
}

void VerdictChoices::send(bool wasWanted) {
  if (wasWanted != isWanted()) outbox_.post(request::SetVerdicts{isWanted()});
}

const VerdictDelivery* VerdictChoices::verdict() const {
  const ProbeResult* probe = probes_.active() < 0 ? nullptr : probes_.result();
  if (!isOn_ || !latest_ || !probe || !probe->exact || status_.playing) return nullptr;
  if (!(presets_.settings() == status_.settings)) return nullptr; // they were changed just now
  const bool isOfIt = latest_->frame == probe->frame && latest_->pixel == glm::ivec2(probe->x, probe->y) &&
                      latest_->shotVersion == status_.shotVersion;
  return isOfIt ? &*latest_ : nullptr;
}

bool VerdictChoices::isComplete() const {
  if (!isWanted() || !probes_.pixel()) return true;
  const ProbeResult* probe = probes_.result();
  if (probe && probe->around.empty()) return true; // there is nothing to see
  const VerdictDelivery* now = verdict();
  if (!now) return false;
  if (now->remedies && (now->remedies->best.empty() || now->remedies->picture)) return true;
  return !now->whyNot.empty() || now->answer->verdict.kind == VerdictKind::None;
}

const std::vector<TriedRemedy>& VerdictChoices::remedies() const {
  static const std::vector<TriedRemedy> kNone;
  const VerdictDelivery* now = verdict();
  return now && now->remedies ? now->remedies->best : kNone;
}

void VerdictChoices::apply(std::size_t remedy) {
  presets_.assign(remedies().at(remedy).remedy.changes);
}

void VerdictChoices::arrived(VerdictDelivery&& verdict) {
  latest_ = std::move(verdict);
  Q_EMIT changed();
}

} // namespace taa::app
