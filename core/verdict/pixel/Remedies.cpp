#include "core/verdict/pixel/Remedies.h"

#include "core/base/Say.h"
#include "core/explanation/RowFormatter.h"
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
  constexpr double kUnseen = 2.0 / 255.0; // nothing is left to correct
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

/// What frames are averaged by, and the best of that with each single change: without it nothing else helps.
void addAccumulating(RemedyList& list, int round, const RemedyCase& of,
                     const std::vector<TriedRemedy>& tried) {
  if (round == 0) {
    list.add(accumulatingCures(of.settings));
    return;
  }
  if (tried.empty()) return;
  const Settings& best = std::ranges::min_element(tried, isNearer)->remedy.settings;
  if (accumulatesNothing(best)) return;
  list.add(likelyCures(of.kind, best));
  list.add(singleChanges(best));
}

/// What the whole picture is off by, still or not; what was not measured is taken to be as it is.
double pictureHarm(const TriedRemedy& tried, const RemedyCase& of) {
  const std::optional<RemedyMeasure>& picture = tried.picture ? tried.picture : of.picture;
  return picture ? std::hypot(picture->error, picture->flicker) : 0.0;
}

bool costs(const TriedRemedy& tried, const RemedyCase& of) {
  return tried.picture && of.picture && costsPicture(*of.picture, *tried.picture);
}

/// Whether one of them leaves less than half of what is visible: a hundred more would take ten times as long.
bool isEnough(const RemedyCase& of, const std::vector<TriedRemedy>& tried) {
  return std::ranges::any_of(tried, [&](const TriedRemedy& one) {
    return isCorrection(of.before, one.pixel) && harm(one.pixel) < 0.5 * kVisibleError;
  });
}

bool isNamedBy(const RemedyCase& of, const Remedy& remedy) {
  return std::ranges::any_of(remedy.changes, [&](const std::string& change) {
    return std::ranges::find(of.named, change.substr(0, change.find('='))) != of.named.end();
  });
}

bool turnsTaaOn(const TriedRemedy& tried, const RemedyCase& of) {
  return !isTaaOn(of.settings) && tried.remedy.changes.size() == 1 && isTaaOn(tried.remedy.settings);
}

/// Of those that leave about as little as the nearest one, to two steps of 255 or a twentieth of the harm
/// there was, those with the fewest changes, and of these the one with the best picture. `better`: nearest
/// first.
const TriedRemedy& preferred(const std::vector<TriedRemedy>& better, const RemedyCase& of) {
  const double limit = harm(better.front().pixel) + std::max(2.0 / 255.0, 0.05 * harm(of.before));
  const TriedRemedy* best = &better.front();
  for (const TriedRemedy& one : better) {
    if (harm(one.pixel) >= limit) break;
    const std::size_t changes = one.remedy.changes.size(), least = best->remedy.changes.size();
    if (changes < least || (changes == least && pictureHarm(one, of) < pictureHarm(*best, of))) best = &one;
  }
  return *best;
}

/// Chooses from `better`, nearest first.
class RemedyPicks {
 public:
  RemedyPicks(std::vector<TriedRemedy> better, const RemedyCase& of, std::size_t count)
      : better_(std::move(better)), of_(of), count_(count) {}

  /// At most `most` of those.
  template <typename IsWanted>
  void take(IsWanted isWanted, std::size_t most) {
    for (; most > 0 && best_.size() < count_; --most) {
      std::vector<TriedRemedy> wanted;
      std::ranges::copy_if(better_, std::back_inserter(wanted), isWanted);
      if (wanted.empty()) return;
      best_.push_back(preferred(wanted, of_));
      const Remedy& told = best_.back().remedy;
      std::erase_if(better_, [&](const TriedRemedy& one) { return isPartOf(told, one.remedy); });
    }
  }
  std::vector<TriedRemedy>& best() { return best_; }

 private:
  std::vector<TriedRemedy> better_, best_;
  const RemedyCase& of_;
  std::size_t count_;
};

/// What the verdict names is told though something else helps more, or it does not help.
void addNamed(std::vector<TriedRemedy>& best, const std::vector<TriedRemedy>& tried, const RemedyCase& of,
              std::size_t count) {
  for (TriedRemedy& one : best) one.isNamed = isNamedBy(of, one.remedy);
  std::vector<TriedRemedy> named;
  std::ranges::copy_if(tried, std::back_inserter(named),
                       [&](const TriedRemedy& one) { return isNamedBy(of, one.remedy); });
  if (named.empty() || count == 0 || std::ranges::any_of(best, &TriedRemedy::isNamed)) return;
  std::ranges::stable_sort(named, isNearer);
  TriedRemedy told = preferred(named, of);
  told.isNamed = true;
  if (best.size() == count) best.pop_back();
  const bool isLast = costs(told, of) || !isCorrection(of.before, told.pixel);
  const auto costing = [&](const TriedRemedy& one) { return costs(one, of); };
  best.insert(isLast ? best.end() : std::ranges::find_if(best, costing), std::move(told));
}

} // namespace

double psnrOf(const RemedyMeasure& picture) {
  return -20.0 * std::log10(picture.error);
}

bool costsPicture(const RemedyMeasure& before, const RemedyMeasure& after) {
  constexpr double kLeastFlicker = 0.05 / 255.0;
  const bool isFartherOff = psnrOf(after) < psnrOf(before) - kPictureCost;
  return isFartherOff ||
         after.flicker > std::max((1.0 + kFlickerCost) * before.flicker, before.flicker + kLeastFlicker);
}

bool isCorrection(const RemedyMeasure& before, const RemedyMeasure& after) {
  constexpr double kClearly = 0.9; // of what was there before
  return harm(after) < kClearly * harm(before) && after.latest < before.latest;
}

std::string remedyNote(const TriedRemedy& tried, const RemedyMeasure& pixel,
                       const std::optional<RemedyMeasure>& picture) {
  std::string note;
  const auto add = [&note](const std::string& sentence) { note += (note.empty() ? "" : " ") + sentence; };
  const bool isCorrected = isCorrection(pixel, tried.pixel);
  if (tried.isNamed)
    add(isCorrected ? say<"The verdict names this setting.">()
                    : say<"The verdict names this setting; changing it does not mend the pixel.">());
  if (!picture || !tried.picture || !costsPicture(*picture, *tried.picture)) return note;
  const double lost = psnrOf(*picture) - psnrOf(*tried.picture);
  if (lost > kPictureCost) add(say<"It costs the picture %1 dB of PSNR.">(numberText(lost, 2)));
  if (const double rise = tried.picture->flicker / picture->flicker - 1.0; rise > kFlickerCost)
    add(say<"The picture flickers more: by %1.">(explanation::percentText(rise)));
  return note;
}

std::vector<Remedy> remedyRound(int round, const RemedyCase& of, const std::vector<TriedRemedy>& tried) {
  RemedyList list(of, tried);
  if (of.kind == VerdictKind::None) return {};
  if (round == 0) addWithoutFaults(list, of.settings);
  if (round > 1) {
    addTogether(list, of, tried);
  } else if (accumulatesNothing(of.settings)) {
    addAccumulating(list, round, of, tried);
  } else if (round == 0) {
    list.add(singleChanges(of.named, of.settings));
    list.add(likelyCures(of.kind, of.settings));
  } else if (!isEnough(of, tried)) {
    list.add(singleChanges(of.settings));
    const auto corrects = [&](const TriedRemedy& one) { return isCorrection(of.before, one.pixel); };
    if (std::ranges::none_of(tried, corrects)) list.add(otherCures(of.kind, of.settings));
  }
  return list.take();
}

std::vector<TriedRemedy> bestRemedies(const std::vector<TriedRemedy>& tried, const RemedyCase& of,
                                      std::size_t count) {
  std::vector<TriedRemedy> better;
  std::ranges::copy_if(tried, std::back_inserter(better),
                       [&](const TriedRemedy& one) { return isCorrection(of.before, one.pixel); });
  std::ranges::stable_sort(better, isNearer);
  RemedyPicks picks(std::move(better), of, count);
  const auto isCheap = [&](const TriedRemedy& one) { return !costs(one, of); };
  // A fault that was injected is the cause, whatever else hides it, and so is TAA that is off.
  picks.take([](const TriedRemedy& one) { return takesFaultsOut(one.remedy); }, 1);
  picks.take([&](const TriedRemedy& one) { return turnsTaaOn(one, of) && isCheap(one); }, 1);
  picks.take(isCheap, count);
  picks.take([](const TriedRemedy&) { return true; }, count);
  addNamed(picks.best(), tried, of, count);
  return std::move(picks.best());
}

} // namespace taa
