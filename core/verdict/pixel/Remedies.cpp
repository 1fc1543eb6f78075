#include "core/verdict/pixel/Remedies.h"

#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"
#include "core/verdict/pixel/Cures.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace taa {

namespace {

/// As one number what a viewer is off by, still or not: the frame itself counts as much as the last four.
double harm(const RemedyMeasure& measure) {
  return std::hypot(std::sqrt(0.5) * measure.error, std::sqrt(0.5) * measure.latest, measure.errorChange);
}

bool isPartOf(const Remedy& part, const Remedy& whole) {
  return std::ranges::all_of(part.changes, [&](const std::string& change) {
    return std::ranges::find(whole.changes, change) != whole.changes.end();
  });
}

/// `changed` without changes that have no effect.
Settings effective(Settings changed, const Settings& settings) {
  for (const Parameter& row : parameters())
    if (row.get(changed) != row.get(settings) && !isRelevant(row, changed))
      row.set(changed, row.get(settings));
  return changed;
}

/// What a round tries.
class RemedyList {
 public:
  RemedyList(const RemedyCase& of, const std::vector<TriedRemedy>& tried) : of_(of), tried_(tried) {}

  bool add(const Settings& wanted) {
    constexpr std::size_t kMaxChanges = 3;
    const Settings changed = effective(wanted, of_.settings);
    Remedy remedy{differences(changed, of_.settings), changed};
    if (remedy.changes.empty() || remedy.changes.size() > kMaxChanges || isKnown(remedy)) return false;
    if (!of_.drawsInputs && drawsOthers(changed)) return false;
    remedies_.push_back(std::move(remedy));
    return true;
  }
  void add(const std::vector<Settings>& all) {
    for (const Settings& one : all) add(one);
  }
  std::vector<Remedy> take() { return std::move(remedies_); }

 private:
  /// A capture's faults come on its way in, and can be left out like those of a scene.
  bool drawsOthers(Settings changed) const {
    changed.fault = of_.settings.fault;
    return !sameInputs(changed, of_.settings);
  }

  bool isKnown(const Remedy& remedy) const {
    const auto isSame = [&](const Remedy& known) { return known.changes == remedy.changes; };
    return std::ranges::any_of(remedies_, isSame) ||
           std::ranges::any_of(tried_, isSame, &TriedRemedy::remedy);
  }

  const RemedyCase& of_;
  const std::vector<TriedRemedy>& tried_;
  std::vector<Remedy> remedies_;
};

/// What was injected is taken out, each row of it and all at once.
void addWithoutFaults(RemedyList& list, const Settings& settings) {
  Settings without = settings;
  clearFaults(without);
  list.add(without);
  for (const std::string& fault : injectedFaults(settings)) {
    const Parameter& row = parameter(fault.substr(0, fault.find('=')));
    Settings one = settings;
    row.set(one, row.defaultValue());
    list.add(one);
  }
}

bool takesFaultsOut(const Remedy& remedy) {
  return std::ranges::all_of(remedy.changes, isOfFaults);
}

bool isNearer(const TriedRemedy& a, const TriedRemedy& b) {
  return harm(a.pixel) < harm(b.pixel);
}

/// The best one together with each of some that help by themselves.
void addTogether(RemedyList& list, const RemedyCase& of, const std::vector<TriedRemedy>& tried) {
  constexpr int kPartners = 5;
  constexpr double kUnseen = 2.0 / 255.0; // nothing is left to mend
  std::vector<TriedRemedy> helpful;
  std::ranges::copy_if(tried, std::back_inserter(helpful),
                       [&](const TriedRemedy& one) { return harm(one.pixel) < harm(of.before); });
  std::ranges::stable_sort(helpful, isNearer);
  if (helpful.empty() || harm(helpful.front().pixel) <= kUnseen) return;
  int partners = 0;
  for (const TriedRemedy& partner : helpful) {
    if (partners == kPartners) break;
    Settings both = helpful.front().remedy.settings;
    for (const std::string& change : partner.remedy.changes) applyAssignment(both, change);
    if (list.add(both)) ++partners;
  }
}

/// What the whole picture is off by, still or not; nothing is known of it: 0.
double pictureHarm(const TriedRemedy& tried) {
  return tried.picture ? std::hypot(tried.picture->error, tried.picture->flicker) : 0.0;
}

/// The one that costs the picture least of those that lie next to the nearest one: by less than a step of
/// 255, or than a tenth of the harm there was. Of those that cost it the same, to a fiftieth of a step, the
/// simplest. `better`: nearest first.
const TriedRemedy& cheapestOfBest(const std::vector<TriedRemedy>& better, const RemedyMeasure& before) {
  constexpr double kSameCost = 0.02 / 255.0;
  const double limit = harm(better.front().pixel) + std::min(1.0 / 255.0, 0.1 * harm(before));
  const auto end = std::find_if(better.begin() + 1, better.end(),
                                [&](const TriedRemedy& one) { return harm(one.pixel) >= limit; });
  double least = pictureHarm(better.front());
  for (auto one = better.begin(); one != end; ++one) least = std::min(least, pictureHarm(*one));
  const TriedRemedy* simplest = nullptr;
  for (auto one = better.begin(); one != end; ++one)
    if (pictureHarm(*one) <= least + kSameCost &&
        (!simplest || one->remedy.changes.size() < simplest->remedy.changes.size()))
      simplest = &*one;
  return *simplest;
}

} // namespace

std::vector<Remedy> remedyRound(int round, const RemedyCase& of, const std::vector<TriedRemedy>& tried) {
  RemedyList list(of, tried);
  if (of.kind == VerdictKind::None || !isTaaOn(of.settings)) return {};
  if (round == 0) {
    addWithoutFaults(list, of.settings);
    list.add(likelyCures(of.kind, of.settings));
  } else if (round > 1) {
    addTogether(list, of, tried);
  } else if (bestRemedies(tried, of.before, 1).empty()) {
    list.add(otherCures(of.kind, of.settings));
  }
  return list.take();
}

std::vector<TriedRemedy> bestRemedies(const std::vector<TriedRemedy>& tried, const RemedyMeasure& before,
                                      std::size_t count) {
  constexpr double kClearly = 0.9; // of what was there before
  std::vector<TriedRemedy> better;
  std::ranges::copy_if(tried, std::back_inserter(better), [&](const TriedRemedy& one) {
    return harm(one.pixel) < kClearly * harm(before) && one.pixel.latest < before.latest;
  });
  std::ranges::stable_sort(better, isNearer);
  std::vector<TriedRemedy> best;
  const auto tell = [&](const TriedRemedy& told) {
    best.push_back(told);
    std::erase_if(better, [&](const TriedRemedy& one) { return isPartOf(best.back().remedy, one.remedy); });
  };
  // A fault that was injected is the cause, whatever else hides it.
  const auto cause = std::ranges::find_if(better, takesFaultsOut, &TriedRemedy::remedy);
  if (cause != better.end()) tell(*cause);
  while (best.size() < count && !better.empty()) tell(cheapestOfBest(better, before));
  return best;
}

} // namespace taa
