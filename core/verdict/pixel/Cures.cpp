#include "core/verdict/pixel/Cures.h"

#include "core/settings/Parameters.h"

#include <algorithm>
#include <initializer_list>
#include <span>

namespace taa {

namespace {

/// A change that is known to help against some kinds.
struct Cure {
  std::initializer_list<VerdictKind> against;
  void (*apply)(Settings&);
};

using Wrong = VerdictKind;

/// Weight of the current frame, wherever it comes from.
void scaleAlpha(Settings& s, float factor) {
  const auto scale = [factor](float& weight) { weight = std::min(weight * factor, 1.0f); };
  switch (s.weight.source) {
  case AlphaSource::Constant:
  case AlphaSource::Depth:
    return scale(s.weight.alpha);
  case AlphaSource::HistoryLength:
    s.weight.minimum = std::max(s.weight.minimum, 0.03f); // 1/(N+1) gets there
    return scale(s.weight.minimum);
  case AlphaSource::LumaDifference:
  case AlphaSource::Contrast:
  case AlphaSource::LumaDifferenceAsPrinted:
  case AlphaSource::ContrastPerChannel:
  case AlphaSource::Confidence:
  case AlphaSource::LumaDifferenceCompressed:
    scale(s.weight.sourceMax);
    scale(s.weight.sourceMin);
  }
}

/// What is marked follows the current frame.
void followMask(Settings& s, float alpha) {
  if (s.inputs.mask == MaskSource::None) s.inputs.mask = MaskSource::Material;
  s.weight.mask = MaskAlpha::Responsive;
  s.weight.maskAlpha = alpha;
}

void addSharpening(Settings& s, float amount) {
  s.current.sharpen = CurrentSharpen::Laplacian;
  s.current.sharpenAmount = amount;
}

void widenCurrent(Settings& s, float variance) {
  s.current.filter = CurrentFilter::Gaussian;
  s.current.variance = variance;
}

void keepRejected(Settings& s, float alpha) {
  s.validate.action = RejectAction::RaiseAlpha;
  s.validate.softAlpha = alpha;
}

// Likely ones first (manual, techniques; the cures of the sources that each kind is described in).
constexpr Cure kHistoryCures[] = {
    {{Wrong::Ghost}, [](Settings& s) { s.reproject.method = ReprojectMethod::Motion; }},
    {{Wrong::Ghost}, [](Settings& s) { s.inputs.motion = MotionSource::Objects; }},
    {{Wrong::Ghost, Wrong::Lag, Wrong::MaskSmear},
     [](Settings& s) { s.rectify.method = RectifyMethod::ClipToFiltered; }},
    {{Wrong::Ghost}, [](Settings& s) { s.validate.depth = Switch::On; }},
    {{Wrong::Ghost}, [](Settings& s) { s.validate.object = Switch::On; }},
    {{Wrong::Ghost, Wrong::Lag, Wrong::MaskSmear},
     [](Settings& s) { s.neighborhood.box = BoxKind::Intersection; }},
    {{Wrong::Ghost}, [](Settings& s) { s.validate.offScreen = OffScreen::Reject; }},
    {{Wrong::Ghost}, [](Settings& s) { s.validate.action = RejectAction::Restart; }},
    {{Wrong::Ghost}, [](Settings& s) { s.dilate.method = DilateMethod::Closest3x3; }},
    // A pixel beside a rim reads what its neighbor came from.
    {{Wrong::Ghost}, [](Settings& s) { s.dilate.method = DilateMethod::ClosestCross; }},
    {{Wrong::Ghost}, [](Settings& s) { s.dilate.method = DilateMethod::None; }},
    {{Wrong::Ghost, Wrong::Lag, Wrong::MaskSmear},
     [](Settings& s) {
       s.rectify.method = RectifyMethod::ClipToFiltered;
       s.neighborhood.box = BoxKind::Variance;
       s.neighborhood.gamma = 1.0f;
     }},
    {{Wrong::Ghost, Wrong::Lag, Wrong::MaskSmear}, [](Settings& s) { s.neighborhood.gamma *= 0.5f; }},
    {{Wrong::MaskSmear}, [](Settings& s) { followMask(s, 1.0f); }},
    {{Wrong::MaskSmear}, [](Settings& s) { followMask(s, 0.5f); }},
    {{Wrong::Ghost},
     [](Settings& s) {
       s.inputs.mask = MaskSource::AutoReactive;
       s.weight.mask = MaskAlpha::Reactive;
     }},
    {{Wrong::Lag, Wrong::MaskSmear, Wrong::Ghost}, [](Settings& s) { scaleAlpha(s, 2.0f); }},
    {{Wrong::Lag, Wrong::MaskSmear}, [](Settings& s) { scaleAlpha(s, 4.0f); }},
    {{Wrong::Lag}, [](Settings& s) { s.neighborhood.shape = NeighborhoodShape::Cross; }},
};
constexpr Cure kSampleCures[] = {
    {{Wrong::HighlightFlicker}, [](Settings& s) { s.blend.tone = ToneWeight::Luma; }},
    {{Wrong::HighlightFlicker}, [](Settings& s) { s.blend.tone = ToneWeight::None; }},
    {{Wrong::HighlightFlicker}, [](Settings& s) { s.space.tone = ToneSpace::ReinhardLuma; }},
    {{Wrong::HighlightFlicker}, [](Settings& s) { s.current.lumaWeighted = Switch::On; }},
    {{Wrong::Flicker, Wrong::HighlightFlicker, Wrong::Aliasing},
     [](Settings& s) { s.weight.source = AlphaSource::HistoryLength; }},
    {{Wrong::Flicker, Wrong::HighlightFlicker, Wrong::Aliasing, Wrong::DisocclusionRestart},
     [](Settings& s) { s.current.filter = CurrentFilter::Gaussian; }},
    {{Wrong::DisocclusionRestart}, [](Settings& s) { s.blend.restart = Restart::Blurred; }},
    {{Wrong::DisocclusionRestart}, [](Settings& s) { s.current.filter = CurrentFilter::Tent; }},
    {{Wrong::DisocclusionRestart}, [](Settings& s) { widenCurrent(s, 0.44f); }},
    {{Wrong::DisocclusionRestart}, [](Settings& s) { keepRejected(s, 0.5f); }},
    {{Wrong::DisocclusionRestart}, [](Settings& s) { s.validate.depth = Switch::Off; }},
    {{Wrong::DisocclusionRestart}, [](Settings& s) { s.validate.action = RejectAction::Decay; }},
    {{Wrong::Flicker, Wrong::HighlightFlicker}, [](Settings& s) { s.rectify.instability = Switch::On; }},
    {{Wrong::Flicker, Wrong::Blur}, [](Settings& s) { s.rectify.locks = Switch::On; }},
    {{Wrong::Flicker, Wrong::HighlightFlicker}, [](Settings& s) { s.weight.lumaFlicker = Switch::On; }},
    {{Wrong::Flicker, Wrong::HighlightFlicker}, [](Settings& s) { s.weight.nearClamp = Switch::On; }},
    {{Wrong::Flicker, Wrong::HighlightFlicker},
     [](Settings& s) {
       s.rectify.relaxAtRest = Switch::On;
       s.rectify.minStrength = 0.0f;
     }},
    {{Wrong::Flicker, Wrong::HighlightFlicker, Wrong::Aliasing}, [](Settings& s) { scaleAlpha(s, 0.5f); }},
    {{Wrong::Flicker, Wrong::HighlightFlicker, Wrong::Aliasing, Wrong::Blur},
     [](Settings& s) { s.neighborhood.gamma = std::min(2.0f * s.neighborhood.gamma, 4.0f); }},
    {{Wrong::Aliasing, Wrong::Flicker}, [](Settings& s) { s.validate.depth = Switch::Off; }},
    {{Wrong::Aliasing, Wrong::Flicker}, [](Settings& s) { s.validate.object = Switch::Off; }},
    {{Wrong::Aliasing, Wrong::Flicker}, [](Settings& s) { s.validate.flicker = Switch::On; }},
};
constexpr Cure kSharpnessCures[] = {
    {{Wrong::Blur}, [](Settings& s) { s.history.filter = HistoryFilter::CatmullRom9; }},
    {{Wrong::Blur, Wrong::Aliasing}, [](Settings& s) { s.current.filter = CurrentFilter::BlackmanHarris; }},
    {{Wrong::Blur}, [](Settings& s) { addSharpening(s, 0.25f); }},
    {{Wrong::Blur}, [](Settings& s) { addSharpening(s, 1.0f); }},
    {{Wrong::Blur}, [](Settings& s) { s.history.filter = HistoryFilter::Lanczos; }},
    {{Wrong::Blur},
     [](Settings& s) {
       s.history.filter = HistoryFilter::Cubic;
       s.history.sharpness = 0.8f;
     }},
    {{Wrong::Blur}, [](Settings& s) { s.history.dering = Switch::Off; }},
    {{Wrong::Blur, Wrong::Aliasing}, [](Settings& s) { s.current.filter = CurrentFilter::CatmullRom; }},
    {{Wrong::Blur}, [](Settings& s) { scaleAlpha(s, 2.0f); }},
    {{Wrong::Blur}, [](Settings& s) { s.inputs.mipBias -= 1.0f; }},
    {{Wrong::Blur}, [](Settings& s) { s.rectify.method = RectifyMethod::None; }},
};

/// All of them, in the order in which they are tried.
std::vector<const Cure*> allCures() {
  std::vector<const Cure*> all;
  for (const std::span<const Cure> cures :
       {std::span<const Cure>(kHistoryCures), std::span<const Cure>(kSampleCures),
        std::span<const Cure>(kSharpnessCures)})
    for (const Cure& cure : cures) all.push_back(&cure);
  return all;
}

std::vector<Settings> curedOf(const Settings& settings, VerdictKind kind, bool helps) {
  std::vector<Settings> cured;
  for (const Cure* cure : allCures()) {
    const bool isAgainst = std::ranges::find(cure->against, kind) != cure->against.end();
    if (isAgainst != helps) continue;
    cured.push_back(settings);
    cure->apply(cured.back());
  }
  return cured;
}

/// Whether a row belongs to what makes the resolved color of given inputs, and history keeps its format.
bool isOfResolving(const Parameter& row) {
  return (row.effect == Effect::Program || row.effect == Effect::Uniform) && row.stage < Stage::Output;
}

/// Other values that are worth a try: all of a choice or switch, half and twice of a number.
std::vector<double> otherValues(const Parameter& row, double value) {
  constexpr double kShareOfRange = 0.25; // where there is nothing to double
  if (row.kind == ParameterKind::Integer || row.kind == ParameterKind::Number) {
    const double more = value != 0.0 ? 2.0 * value : kShareOfRange * std::min(row.maximum, 1.0);
    return {std::clamp(0.5 * value, row.minimum, row.maximum), std::clamp(more, row.minimum, row.maximum)};
  }
  std::vector<double> values;
  for (double other = row.minimum; other <= row.maximum; ++other) {
    const bool isMisprint = row.kind == ParameterKind::Choice &&
                            row.choices[static_cast<std::size_t>(other)].id.ends_with("AsPrinted");
    if (!isMisprint) values.push_back(other);
  }
  return values;
}

} // namespace

std::vector<Settings> likelyCures(VerdictKind kind, const Settings& settings) {
  return curedOf(settings, kind, true);
}

std::vector<Settings> otherCures(VerdictKind kind, const Settings& settings) {
  std::vector<Settings> cured = curedOf(settings, kind, false);
  for (const Parameter& row : parameters()) {
    if (!isOfResolving(row) || !isRelevant(row, settings)) continue;
    for (const double value : otherValues(row, row.get(settings))) {
      cured.push_back(settings);
      row.set(cured.back(), value);
    }
  }
  return cured;
}

} // namespace taa
