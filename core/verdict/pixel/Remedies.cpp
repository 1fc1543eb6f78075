#include "core/verdict/pixel/Remedies.h"

#include "core/settings/Parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace taa {

namespace {

/// A change that is known to help against some kinds.
struct Cure {
  std::initializer_list<VerdictKind> against;
  void (*apply)(Settings&);
};

using Wrong = VerdictKind;

// Likely ones first (manual, techniques; the cures of the sources that each kind is described in).
const std::array<Cure, 29>& cures() {
  static const std::array<Cure, 29> kCures{{
      {{Wrong::Ghost}, [](Settings& s) { s.reproject.method = ReprojectMethod::Motion; }},
      {{Wrong::Ghost, Wrong::Lag}, [](Settings& s) { s.rectify.method = RectifyMethod::ClipToFiltered; }},
      {{Wrong::Ghost}, [](Settings& s) { s.validate.depth = Switch::On; }},
      {{Wrong::Ghost}, [](Settings& s) { s.validate.object = Switch::On; }},
      {{Wrong::Ghost, Wrong::Lag}, [](Settings& s) { s.neighborhood.box = BoxKind::Intersection; }},
      {{Wrong::Ghost}, [](Settings& s) { s.validate.offScreen = OffScreen::Reject; }},
      {{Wrong::Ghost}, [](Settings& s) { s.validate.action = RejectAction::Restart; }},
      {{Wrong::Ghost}, [](Settings& s) { s.dilate.method = DilateMethod::Closest3x3; }},
      {{Wrong::Ghost, Wrong::Lag, Wrong::MaskSmear},
       [](Settings& s) {
         s.rectify.method = RectifyMethod::ClipToFiltered;
         s.neighborhood.box = BoxKind::Variance;
         s.neighborhood.gamma = 1.0f;
       }},
      {{Wrong::MaskSmear}, [](Settings& s) { s.weight.mask = MaskAlpha::Responsive; }},
      {{Wrong::MaskSmear}, [](Settings& s) { s.weight.mask = MaskAlpha::Reactive; }},
      {{Wrong::HighlightFlicker}, [](Settings& s) { s.blend.tone = ToneWeight::Luma; }},
      {{Wrong::HighlightFlicker}, [](Settings& s) { s.space.tone = ToneSpace::ReinhardLuma; }},
      {{Wrong::HighlightFlicker}, [](Settings& s) { s.current.lumaWeighted = Switch::On; }},
      {{Wrong::Flicker, Wrong::HighlightFlicker, Wrong::Aliasing},
       [](Settings& s) { s.weight.source = AlphaSource::HistoryLength; }},
      {{Wrong::Flicker, Wrong::HighlightFlicker, Wrong::Aliasing, Wrong::DisocclusionRestart},
       [](Settings& s) { s.current.filter = CurrentFilter::Gaussian; }},
      {{Wrong::DisocclusionRestart}, [](Settings& s) { s.blend.restart = Restart::Blurred; }},
      {{Wrong::DisocclusionRestart}, [](Settings& s) { s.current.filter = CurrentFilter::Tent; }},
      {{Wrong::Flicker, Wrong::HighlightFlicker}, [](Settings& s) { s.rectify.instability = Switch::On; }},
      {{Wrong::Flicker, Wrong::Blur}, [](Settings& s) { s.rectify.locks = Switch::On; }},
      {{Wrong::Flicker, Wrong::HighlightFlicker}, [](Settings& s) { s.weight.lumaFlicker = Switch::On; }},
      {{Wrong::Flicker, Wrong::HighlightFlicker}, [](Settings& s) { s.weight.nearClamp = Switch::On; }},
      {{Wrong::Flicker, Wrong::HighlightFlicker, Wrong::Aliasing},
       [](Settings& s) {
         s.weight.minimum *= 0.5f;
         s.weight.alpha *= 0.5f;
       }},
      {{Wrong::Flicker, Wrong::HighlightFlicker, Wrong::Aliasing, Wrong::Blur},
       [](Settings& s) { s.neighborhood.gamma = std::min(2.0f * s.neighborhood.gamma, 4.0f); }},
      {{Wrong::Aliasing, Wrong::Flicker}, [](Settings& s) { s.validate.depth = Switch::Off; }},
      {{Wrong::Aliasing, Wrong::Flicker}, [](Settings& s) { s.validate.object = Switch::Off; }},
      {{Wrong::Aliasing, Wrong::Flicker}, [](Settings& s) { s.validate.flicker = Switch::On; }},
      {{Wrong::Blur}, [](Settings& s) { s.history.filter = HistoryFilter::CatmullRom9; }},
      {{Wrong::Blur}, [](Settings& s) { s.current.filter = CurrentFilter::BlackmanHarris; }},
  }};
  return kCures;
}

void addRemedy(std::vector<Remedy>& remedies, const Settings& changed, const Settings& settings) {
  constexpr std::size_t kMaxChanges = 3;
  Remedy remedy{differences(changed, settings), changed};
  const bool isOne = !remedy.changes.empty() && remedy.changes.size() <= kMaxChanges;
  const bool isKnown =
      std::ranges::any_of(remedies, [&](const Remedy& known) { return known.changes == remedy.changes; });
  if (isOne && !isKnown && sameInputs(changed, settings)) remedies.push_back(std::move(remedy));
}

bool helpsAgainst(const Cure& cure, VerdictKind kind) {
  return std::ranges::find(cure.against, kind) != cure.against.end();
}

/// Error and flicker as one number: what a viewer is off by, still or not.
double harm(const RemedyMeasure& measure) {
  return std::hypot(measure.error, measure.flicker);
}

bool isPartOf(const Remedy& part, const Remedy& whole) {
  return std::ranges::all_of(part.changes, [&](const std::string& change) {
    return std::ranges::find(whole.changes, change) != whole.changes.end();
  });
}

} // namespace

std::vector<Remedy> remediesFor(const PixelVerdict& verdict, const Settings& settings) {
  std::vector<Remedy> remedies;
  if (verdict.kind == VerdictKind::None || !isTaaOn(settings)) return remedies;
  for (const Cure& cure : cures()) {
    if (!helpsAgainst(cure, verdict.kind)) continue;
    Settings changed = settings;
    cure.apply(changed);
    addRemedy(remedies, changed, settings);
  }
  // The first two together: what neither does alone.
  if (remedies.size() >= 2) {
    Settings both = remedies[0].settings;
    for (const std::string& change : remedies[1].changes) applyAssignment(both, change);
    addRemedy(remedies, both, settings);
  }
  return remedies;
}

std::vector<TriedRemedy> bestRemedies(const std::vector<TriedRemedy>& tried, const RemedyMeasure& before,
                                      std::size_t count) {
  constexpr double kClearly = 0.9; // of what was there before
  std::vector<TriedRemedy> better;
  for (const TriedRemedy& one : tried)
    if (harm(one.pixel) < kClearly * harm(before)) better.push_back(one);
  std::ranges::stable_sort(better, {}, [](const TriedRemedy& one) { return harm(one.pixel); });
  std::vector<TriedRemedy> best;
  for (const TriedRemedy& one : better) {
    if (best.size() == count) break;
    const bool isTold =
        std::ranges::any_of(best, [&](const TriedRemedy& told) { return isPartOf(told.remedy, one.remedy); });
    if (!isTold) best.push_back(one);
  }
  return best;
}

} // namespace taa
