#include "core/verdict/pixel/Remedies.h"

#include "core/settings/Parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace taa {

namespace {

/// A change that is known to help against some kinds.
struct Cure {
  std::initializer_list<VerdictKind> against;
  void (*apply)(Settings&);
};

using Kind = VerdictKind;

// Likely ones first (manual, techniques; the cures of the sources that each kind is described in).
const std::array<Cure, 29>& cures() {
  static const std::array<Cure, 29> kCures{{
      {{Kind::Ghost}, [](Settings& s) { s.reproject.method = ReprojectMethod::Motion; }},
      {{Kind::Ghost, Kind::Lag}, [](Settings& s) { s.rectify.method = RectifyMethod::ClipToFiltered; }},
      {{Kind::Ghost}, [](Settings& s) { s.validate.depth = Switch::On; }},
      {{Kind::Ghost}, [](Settings& s) { s.validate.object = Switch::On; }},
      {{Kind::Ghost, Kind::Lag}, [](Settings& s) { s.neighborhood.box = BoxKind::Intersection; }},
      {{Kind::Ghost}, [](Settings& s) { s.validate.offScreen = OffScreen::Reject; }},
      {{Kind::Ghost}, [](Settings& s) { s.validate.action = RejectAction::Restart; }},
      {{Kind::Ghost}, [](Settings& s) { s.dilate.method = DilateMethod::Closest3x3; }},
      {{Kind::Ghost, Kind::Lag, Kind::MaskSmear},
       [](Settings& s) {
         s.rectify.method = RectifyMethod::ClipToFiltered;
         s.neighborhood.box = BoxKind::Variance;
         s.neighborhood.gamma = 1.0f;
       }},
      {{Kind::MaskSmear}, [](Settings& s) { s.weight.mask = MaskAlpha::Responsive; }},
      {{Kind::MaskSmear}, [](Settings& s) { s.weight.mask = MaskAlpha::Reactive; }},
      {{Kind::HighlightFlicker}, [](Settings& s) { s.blend.tone = ToneWeight::Luma; }},
      {{Kind::HighlightFlicker}, [](Settings& s) { s.space.tone = ToneSpace::ReinhardLuma; }},
      {{Kind::HighlightFlicker}, [](Settings& s) { s.current.lumaWeighted = Switch::On; }},
      {{Kind::Flicker, Kind::HighlightFlicker, Kind::Aliasing},
       [](Settings& s) { s.weight.source = AlphaSource::HistoryLength; }},
      {{Kind::Flicker, Kind::HighlightFlicker, Kind::Aliasing, Kind::DisocclusionRestart},
       [](Settings& s) { s.current.filter = CurrentFilter::Gaussian; }},
      {{Kind::DisocclusionRestart}, [](Settings& s) { s.blend.restart = Restart::Blurred; }},
      {{Kind::DisocclusionRestart}, [](Settings& s) { s.current.filter = CurrentFilter::Tent; }},
      {{Kind::Flicker, Kind::HighlightFlicker}, [](Settings& s) { s.rectify.instability = Switch::On; }},
      {{Kind::Flicker, Kind::Blur}, [](Settings& s) { s.rectify.locks = Switch::On; }},
      {{Kind::Flicker, Kind::HighlightFlicker}, [](Settings& s) { s.weight.lumaFlicker = Switch::On; }},
      {{Kind::Flicker, Kind::HighlightFlicker}, [](Settings& s) { s.weight.nearClamp = Switch::On; }},
      {{Kind::Flicker, Kind::HighlightFlicker, Kind::Aliasing},
       [](Settings& s) {
         s.weight.minimum *= 0.5f;
         s.weight.alpha *= 0.5f;
       }},
      {{Kind::Flicker, Kind::HighlightFlicker, Kind::Aliasing, Kind::Blur},
       [](Settings& s) { s.neighborhood.gamma = std::min(2.0f * s.neighborhood.gamma, 4.0f); }},
      {{Kind::Aliasing, Kind::Flicker}, [](Settings& s) { s.validate.depth = Switch::Off; }},
      {{Kind::Aliasing, Kind::Flicker}, [](Settings& s) { s.validate.object = Switch::Off; }},
      {{Kind::Aliasing, Kind::Flicker}, [](Settings& s) { s.validate.flicker = Switch::On; }},
      {{Kind::Blur}, [](Settings& s) { s.history.filter = HistoryFilter::CatmullRom9; }},
      {{Kind::Blur}, [](Settings& s) { s.current.filter = CurrentFilter::BlackmanHarris; }},
  }};
  return kCures;
}

void addRemedy(std::vector<Remedy>& remedies, const Settings& changed, const Settings& settings) {
  constexpr std::size_t kMostChanges = 3;
  Remedy remedy{differences(changed, settings), changed};
  const bool isOne = !remedy.changes.empty() && remedy.changes.size() <= kMostChanges;
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
