#include "core/verdict/pixel/Cures.h"

#include "core/settings/Parameters.h"
#include "core/taa/twin/HistoryStages.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <span>
#include <string_view>

namespace taa {

namespace {

/// A change that is known to help against some kinds.
struct Cure {
  std::initializer_list<VerdictKind> against;
  void (*apply)(Settings&);
};

using Wrong = VerdictKind;

/// The settings that bound α, by where it comes from.
struct AlphaBounds {
  float *least, *most;
  std::string_view path; ///< of the one that says how much the current frame counts
};

AlphaBounds alphaBounds(WeightSettings& weight) {
  switch (weight.source) {
  case AlphaSource::Constant:
  case AlphaSource::Depth:
    return {&weight.alpha, &weight.alpha, "weight.alpha"};
  case AlphaSource::HistoryLength:
    return {&weight.minimum, &weight.minimum, "weight.minimum"};
  case AlphaSource::LumaDifference:
  case AlphaSource::Contrast:
  case AlphaSource::LumaDifferenceAsPrinted:
  case AlphaSource::ContrastPerChannel:
  case AlphaSource::Confidence:
  case AlphaSource::LumaDifferenceCompressed:
    break;
  }
  return {&weight.sourceMin, &weight.sourceMax, "weight.sourceMax"};
}

void scaleAlpha(Settings& s, float factor) {
  if (s.weight.source == AlphaSource::HistoryLength)
    s.weight.minimum = std::max(s.weight.minimum, 0.03f); // 1/(N+1) gets there
  const AlphaBounds bounds = alphaBounds(s.weight);
  *bounds.most = std::min(*bounds.most * factor, 1.0f);
  if (bounds.least != bounds.most) *bounds.least = std::min(*bounds.least * factor, 1.0f);
}

/// A recursive average of so many frames that noise of samples cannot be seen.
void averageFrames(Settings& s) {
  s.weight.source = AlphaSource::HistoryLength;
  s.weight.minimum = std::min(s.weight.minimum, 0.1f);
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
    // A pixel beside a silhouette reads what its neighbor came from.
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
  if (row.kind == ParameterKind::Toggle) return {0.0, 1.0};
  std::vector<double> values;
  for (std::size_t choice = 0; choice < row.choices.size(); ++choice)
    if (!row.choices[choice].id.ends_with("AsPrinted")) values.push_back(static_cast<double>(choice));
  return values;
}

void addValues(const Parameter& row, const Settings& settings, std::vector<Settings>& changed) {
  for (const double value : otherValues(row, row.get(settings))) {
    changed.push_back(settings);
    row.set(changed.back(), value);
  }
}

/// Where no single test is named.
constexpr std::string_view kTests[] = {
    "validate.depth", "validate.object",    "validate.class",   "validate.normal", "validate.velocity",
    "validate.speed", "validate.offScreen", "validate.flicker", "validate.action", "validate.depthTolerance"};

/// The test that a reject reason is of; empty: that of none, as history that starts.
std::string_view testOf(twin::RejectReason reason) {
  switch (reason) {
  case twin::RejectReason::OffScreen:
    return "validate.offScreen";
  case twin::RejectReason::Depth:
    return "validate.depth";
  case twin::RejectReason::Speed:
    return "validate.speed";
  case twin::RejectReason::Object:
    return "validate.object";
  case twin::RejectReason::Class:
    return "validate.class";
  case twin::RejectReason::Normal:
    return "validate.normal";
  case twin::RejectReason::Velocity:
    return "validate.velocity";
  case twin::RejectReason::Kept:
  case twin::RejectReason::NoHistory:
  case twin::RejectReason::NoPrevious:
    break;
  }
  return {};
}

/// The test that rejected history first, as the rows of the verdict have it.
std::vector<std::string_view> namedTests(const PixelVerdict& verdict) {
  std::vector<std::string_view> named;
  for (const VerdictRow& row : verdict.rows) {
    if (row.id != IntermediateId::rejectReason) continue;
    const std::string_view test = testOf(static_cast<twin::RejectReason>(static_cast<int>(row.value)));
    if (!test.empty()) named.push_back(test);
  }
  if (named.empty()) named.assign(std::begin(kTests), std::end(kTests));
  return named;
}

std::vector<std::string_view> namedInputs(const PixelVerdict& verdict) {
  switch (verdict.kind) {
  case VerdictKind::MaskSmear:
    return {"inputs.mask"};
  case VerdictKind::Ghost:
  case VerdictKind::Lag:
    return {"inputs.motion"};
  default:
    return {"inputs.mipBias", "inputs.unjitterTextures", "inputs.renderScale"};
  }
}

/// The setting that α comes from.
std::string_view weightPath(WeightSettings weight) {
  return alphaBounds(weight).path;
}

} // namespace

std::vector<std::string_view> namedSettings(const PixelVerdict& verdict, const Settings& settings) {
  if (verdict.kind == VerdictKind::None) return {};
  if (!isTaaOn(settings)) return {"taa.enabled"};
  if (accumulatesNothing(settings)) return {weightPath(settings.weight), "weight.source"};
  switch (verdict.stage) {
  case Stage::Jitter:
    return {"jitter.sequence", "jitter.scale"};
  case Stage::Inputs:
    return namedInputs(verdict);
  case Stage::DilateMotion:
    return {"dilate.method"};
  case Stage::Reproject:
    return {"reproject.method"};
  case Stage::SampleHistory:
    return {"history.filter"};
  case Stage::FilterCurrent:
    return {"current.filter"};
  case Stage::Neighborhood:
    return {"neighborhood.box", "neighborhood.shape", "neighborhood.gamma"};
  case Stage::ValidateHistory:
    return namedTests(verdict);
  case Stage::RectifyHistory:
    return {"rectify.method", "neighborhood.box", "neighborhood.gamma"};
  case Stage::Blend:
    return {"blend.tone"};
  case Stage::BlendWeight:
    if (verdict.kind == VerdictKind::MaskSmear) return {"weight.mask", "weight.maskAlpha"};
    return {weightPath(settings.weight), "weight.source"};
  case Stage::Output:
  case Stage::Reference:
  case Stage::Faults:
    break;
  }
  return {};
}

bool accumulatesNothing(const Settings& settings) {
  if (!isTaaOn(settings)) return true;
  WeightSettings weight = settings.weight;
  return weight.source != AlphaSource::Depth && *alphaBounds(weight).least >= 1.0f;
}

std::vector<Settings> accumulatingCures(const Settings& settings) {
  if (!accumulatesNothing(settings)) return {};
  std::vector<Settings> cures;
  const auto add = [&](auto change) {
    Settings& cure = cures.emplace_back(settings);
    cure.jitter.taa = Switch::On;
    change(cure);
  };
  if (!isTaaOn(settings)) {
    add([](Settings&) {});
    return cures;
  }
  for (const float alpha : {0.1f, 0.05f, 0.2f})
    add([alpha](Settings& s) {
      s.weight.source = AlphaSource::Constant;
      s.weight.alpha = alpha;
    });
  add(averageFrames);
  // What reads history in place averages another surface wherever something moves.
  for (const Settings& still : std::vector<Settings>(cures)) {
    if (still.reproject.method == ReprojectMethod::Motion) break;
    cures.push_back(still);
    cures.back().reproject.method = ReprojectMethod::Motion;
  }
  return cures;
}

std::vector<Settings> likelyCures(VerdictKind kind, const Settings& settings) {
  return curedOf(settings, kind, true);
}

std::vector<Settings> otherCures(VerdictKind kind, const Settings& settings) {
  return curedOf(settings, kind, false);
}

std::vector<Settings> singleChanges(const std::vector<std::string_view>& paths, const Settings& settings) {
  std::vector<Settings> changed;
  for (const std::string_view path : paths) addValues(parameter(path), settings, changed);
  return changed;
}

std::vector<Settings> singleChanges(const Settings& settings) {
  std::vector<Settings> changed;
  for (const Parameter& row : parameters())
    if (isOfResolving(row) && isRelevant(row, settings)) addValues(row, settings, changed);
  return changed;
}

} // namespace taa
