#include "app/session/ProbeList.h"

#include <algorithm>
#include <utility>

namespace taa::app {

namespace {

bool isSameProbe(const Probe& a, const Probe& b) {
  return a.pixel == b.pixel && a.follow == b.follow && (a.follow == Follow::Screen || a.frame == b.frame);
}

} // namespace

const ProbeResult* ProbeList::result(int probe) const {
  if (probe < 0 || probe >= count()) return nullptr;
  const std::optional<ProbeResult>& result = results_[static_cast<std::size_t>(probe)];
  return result ? &*result : nullptr;
}

bool ProbeList::hasOwnResult(int probe) const {
  const ProbeResult* last = result(probe);
  return last && isSameProbe(last->probe, probes_[static_cast<std::size_t>(probe)]);
}

glm::ivec2 ProbeList::pixel(int probe) const {
  const Probe& own = probes_.at(static_cast<std::size_t>(probe));
  const ProbeResult* last = result(probe);
  const bool hasMoved = own.follow == Follow::Surface && last && isSameProbe(last->probe, own);
  return hasMoved ? last->spot.pixel : own.pixel;
}

std::vector<ProbeMark> ProbeList::marks() const {
  std::vector<ProbeMark> marks;
  for (int probe = 0; probe < count(); ++probe) {
    const Probe& own = probes_[static_cast<std::size_t>(probe)];
    const ProbeResult* last = result(probe);
    ProbeMark mark{probe + 1, pixel(probe), ProbeState::Seen, probe == active_,
                   own.follow == Follow::Surface};
    if (last && isSameProbe(last->probe, own)) mark.state = last->spot.state;
    if (mark.state == ProbeState::Seen || mark.state == ProbeState::Hidden) marks.push_back(mark);
  }
  std::ranges::stable_partition(marks, [](const ProbeMark& mark) { return !mark.isActive; });
  return marks;
}

bool ProbeList::add(const Probe& probe) {
  for (int known = 0; known < count(); ++known)
    if (isSameProbe(probes_[static_cast<std::size_t>(known)], probe)) return setActive(known);
  if (count() >= kMaxProbes) return false;
  probes_.push_back(probe);
  results_.emplace_back();
  active_ = count() - 1;
  return true;
}

bool ProbeList::remove(int probe) {
  if (probe < 0 || probe >= count()) return false;
  probes_.erase(probes_.begin() + probe);
  results_.erase(results_.begin() + probe);
  if (active_ > probe || active_ == count()) --active_;
  return true;
}

bool ProbeList::clear() {
  if (probes_.empty()) return false;
  *this = {};
  return true;
}

bool ProbeList::setActive(int probe) {
  if (probe < 0 || probe >= count() || probe == active_) return false;
  active_ = probe;
  return true;
}

bool ProbeList::replace(int probe, const Probe& by) {
  Probe& own = probes_.at(static_cast<std::size_t>(probe));
  if (own == by) return false;
  own = by;
  return true;
}

bool ProbeList::set(const std::vector<Probe>& probes, int active) {
  ProbeList next;
  for (const Probe& probe : probes) next.add(probe);
  for (std::size_t probe = 0; probe < next.probes_.size(); ++probe)
    for (std::size_t known = 0; known < probes_.size(); ++known)
      if (isSameProbe(next.probes_[probe], probes_[known])) next.results_[probe] = results_[known];
  next.active_ = std::clamp(active, std::min(0, next.count() - 1), next.count() - 1);
  if (next.probes_ == probes_ && next.active_ == active_) return false;
  *this = std::move(next);
  return true;
}

bool ProbeList::forgetSurfaces() {
  bool changed = false;
  for (int probe = 0; probe < count(); ++probe) {
    Probe& own = probes_[static_cast<std::size_t>(probe)];
    if (own.follow != Follow::Surface) continue;
    own = {.pixel = pixel(probe)};
    changed = true;
  }
  return changed;
}

bool ProbeList::take(ProbeResult&& result) {
  for (std::size_t probe = 0; probe < probes_.size(); ++probe) {
    if (!isSameProbe(probes_[probe], result.probe)) continue;
    probes_[probe].anchor = result.probe.anchor;
    results_[probe] = std::move(result);
    return true;
  }
  return false;
}

} // namespace taa::app
