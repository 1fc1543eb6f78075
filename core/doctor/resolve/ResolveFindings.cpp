#include "core/doctor/resolve/ResolveFindings.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/settings/Faults.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// Of pixels that lie apart fewer are enough where a mistake explains them exactly.
constexpr std::size_t kEnoughPixels = 150, kEnoughApart = 60, kEnoughExactApart = 12;
/// A mistake is told where it leaves at most so much of what the best sound model leaves, and so much less.
constexpr double kMistakeShare = 0.5, kMistakeLess = 8e-4;
/// Likewise where hardly anything is left, which rounding alone leaves.
constexpr double kExactShare = 0.1, kExactLess = 1e-4;
constexpr double kPairsWon = 0.8;
/// Of differences: a model fits exactly; it is what the engine does, more or less; it is near enough that
/// what fits better may be named.
constexpr double kExact = 1e-3, kAlike = 6e-3, kNear = 0.012;
constexpr std::size_t kOwnRule = 0;
constexpr std::size_t kNothingNew = 1, kAllNew = kTriedAlphas.size(); ///< indices of α 0 and 1
constexpr double kPer1000 = 1000.0;

const ResolveModel& modelOf(const ResolveFit& fit) {
  return resolveModels()[fit.model];
}

std::string alphaText(std::size_t alpha) {
  if (alpha == kOwnRule) return say<"by its own rule">();
  return shortNumber(static_cast<double>(kTriedAlphas[alpha - 1]));
}

std::string measureText() {
  return say<"difference of color from the output, × 1000">();
}

/// Least errors of all kinds over a set, those of what is given first.
std::vector<Residual> resolveResiduals(const ResolveEvidence& evidence, PixelSet set, ResolveKind told) {
  std::vector<Residual> out;
  for (std::size_t k = 0; k < kResolveKinds; ++k) {
    const auto kind = static_cast<ResolveKind>(k);
    if (kind != ResolveKind::Sound && setOf(kind) != set) continue;
    if (const auto fit = evidence.best(kind, set))
      out.push_back({resolveKindId(kind), resolveKindText(kind), kPer1000 * fit->error,
                     kind == ResolveKind::Sound, kind == told});
  }
  std::ranges::stable_sort(out, {}, &Residual::value);
  return out;
}

/// The share of pairs of frames in which a fit is nearer than another.
double pairsWon(const ResolveEvidence& evidence, const ResolveFit& fit, const ResolveFit& other) {
  const auto& ours = evidence.models()[fit.model].pairs;
  const auto& theirs = evidence.models()[other.model].pairs;
  const std::size_t count = std::min(ours.size(), theirs.size());
  std::size_t won = 0;
  for (std::size_t i = 0; i < count; ++i)
    // Pairs of the end are the same: some models are tried from the third on.
    if (ours[ours.size() - 1 - i].mean(fit.alpha) < theirs[theirs.size() - 1 - i].mean(other.alpha)) ++won;
  return count == 0 ? 0.0 : static_cast<double>(won) / static_cast<double>(count);
}

bool isMuchBetter(double error, double than) {
  return (error <= kMistakeShare * than && than - error >= kMistakeLess) ||
         (error <= kExactShare * than && than - error >= kExactLess);
}

struct ResolveWords {
  std::optional<Fault> fault;
  std::string id, name, symptom, change;
};

ResolveWords resolveWordsOf(ResolveKind kind) {
  switch (kind) {
  case ResolveKind::Sound:
    break;
  case ResolveKind::ReadJittered:
    return {Fault::HistoryReadJittered, "", "", "",
            say<"Read history at the pixel's center − motion: neither the last frame's jitter nor this one's "
                "belongs into that place, as history holds what lies at the centers.">()};
  case ResolveKind::NotSwapped:
    return {Fault::HistoryNotSwapped, "", "", "",
            say<"Exchange the two textures of the history after each frame: what is read has to be what the "
                "frame before wrote.">()};
  case ResolveKind::InPlace:
    return {{},
            "historyInPlace",
            say<"History is not reprojected">(),
            say<"Everything that moves smears, though its motion vectors are right.">(),
            say<"Read history at p − motion, in pixels: the resolve does not use the motion vectors, or uses "
                "them in another unit.">()};
  case ResolveKind::Opposite:
    return {{},
            "historyOpposite",
            say<"History is read in the wrong direction">(),
            say<"Ghosts grow with speed, before what moves.">(),
            say<"Subtract motion from the pixel's place where it is current − previous; the resolve adds "
                "it.">()};
  case ResolveKind::BoxOfCorners:
    return {
        Fault::BoxOfCorners, "", "", "",
        say<"Convert all samples to the space of the box, then take their least and greatest: two converted "
            "corners are no box there.">()};
  case ResolveKind::Farthest:
    return {Fault::DilatesFarthest, "", "", "",
            say<"Take the motion of the nearest of the pixels around: of reversed depth that is the "
                "greatest.">()};
  case ResolveKind::OffScreenKept:
    return {Fault::OffScreenClamped, "", "", "",
            say<"Take the current frame alone where history lies beyond the picture.">()};
  }
  return {};
}

Finding resolveFinding(const ResolveWords& words) {
  Finding out = words.fault ? faultFinding(*words.fault) : Finding{};
  if (!words.fault) {
    out.id = words.id;
    out.name = words.name;
    out.symptom = words.symptom;
  }
  out.isWholePicture = true;
  out.change = words.change;
  return out;
}

std::string nearestText(const ResolveFit& fit) {
  const WeightSettings& weight = modelOf(fit).settings.weight;
  const bool isConstant = fit.alpha == kOwnRule && weight.source == AlphaSource::Constant;
  return say<"Nearest is the preset \"%1\" of this program with α %2, to %3 thousandths.">(
      modelOf(fit).preset->id,
      isConstant ? shortNumber(static_cast<double>(weight.alpha)) : alphaText(fit.alpha),
      shortNumber(kPer1000 * fit.error));
}

/// Whether history is read elsewhere than motion leads.
bool isOfReading(ResolveKind kind) {
  return kind == ResolveKind::ReadJittered || kind == ResolveKind::InPlace || kind == ResolveKind::Opposite;
}

/// Where little but silhouettes moves, dilation that picks the farthest reads history as if nothing moved:
/// whether it explains nearly as much of what sound models leave.
bool mayBeFarthest(const ResolveEvidence& evidence, const ResolveFit& mistake) {
  constexpr double kNearlyAsMuch = 0.75;
  const auto sound = evidence.best(ResolveKind::Sound, PixelSet::Anywhere),
             farthest = evidence.best(ResolveKind::Farthest, PixelSet::Anywhere);
  return modelOf(mistake).kind == ResolveKind::InPlace && sound && farthest &&
         sound->error - farthest->error >= kNearlyAsMuch * (sound->error - mistake.error);
}

/// The kind that explains a set much better than any sound model, in nearly all pairs.
std::optional<ResolveFit> mistakeOf(const ResolveEvidence& evidence, PixelSet set) {
  const auto sound = evidence.best(ResolveKind::Sound, set);
  std::optional<ResolveFit> best;
  for (std::size_t k = 0; k < kResolveKinds && sound; ++k) {
    const auto kind = static_cast<ResolveKind>(k);
    if (kind == ResolveKind::Sound || setOf(kind) != set) continue;
    const auto fit = evidence.best(kind, set);
    if (fit && (!best || fit->error < best->error)) best = fit;
  }
  if (!best || best->error > kNear || !isMuchBetter(best->error, sound->error)) return {};
  return best;
}

void tellMistake(const ResolveEvidence& evidence, const ResolveFit& fit, Diagnosis& out) {
  const ResolveKind kind = modelOf(fit).kind;
  Finding finding = resolveFinding(resolveWordsOf(kind));
  const auto sound = evidence.best(ResolveKind::Sound, setOf(kind));
  finding.reason =
      say<"The output differs by %1 thousandths from what frames and history make if %2, and by "
          "%3 if %4.">(shortNumber(kPer1000 * fit.error), resolveKindText(kind),
                       shortNumber(kPer1000 * sound->error), resolveKindText(ResolveKind::Sound)) +
      " " + nearestText(fit);
  finding.measure = measureText();
  finding.residuals = resolveResiduals(evidence, setOf(kind), kind);
  finding.confidence = fit.error <= kAlike ? Confidence::Sure : Confidence::Likely;
  if (mayBeFarthest(evidence, fit)) {
    finding.confidence = Confidence::Likely;
    finding.alike = {std::string(faultInfo(Fault::DilatesFarthest).id)};
    finding.reason +=
        " " + say<"So little moves but rims that dilation which picks the farthest would look the same.">();
  }
  out.findings.push_back(std::move(finding));
}

/// Least errors of sound models by α.
std::vector<Residual> residualsByAlpha(const ResolveEvidence& evidence, std::size_t told) {
  std::vector<Residual> out;
  for (std::size_t alpha = 0; alpha <= kTriedAlphas.size(); ++alpha)
    if (const auto fit = evidence.bestWith(ResolveKind::Sound, PixelSet::Anywhere, alpha))
      out.push_back({alpha == kOwnRule ? std::string("ownRule") : "alpha:" + alphaText(alpha),
                     "α " + alphaText(alpha), kPer1000 * fit->error, false, alpha == told});
  std::ranges::stable_sort(out, {}, &Residual::value);
  return out;
}

/// The least error of any α that is neither 0 nor 1.
double leastOfOthers(const ResolveEvidence& evidence) {
  double least = 1.0;
  for (std::size_t alpha = 0; alpha <= kTriedAlphas.size(); ++alpha) {
    if (alpha == kNothingNew || alpha == kAllNew) continue;
    if (const auto fit = evidence.bestWith(ResolveKind::Sound, PixelSet::Anywhere, alpha))
      least = std::min(least, fit->error);
  }
  return least;
}

/// The output is that of α 0 or 1 to the last bits, and hardly anything else would be another one.
bool isStuckExactly(double error, double others) {
  constexpr double kExactlyLess = 1e-5;
  return error <= kExactShare * others && others - error >= kExactlyLess;
}

/// What fits best is α 0 or 1, and other weights fit hardly worse.
void tellOpenAlpha(const ResolveFit& sound, double others, Diagnosis& out) {
  out.parts.leaveOpen(
      {say<"The weight of the current frame">(),
       say<"the output fits α %1 best, to %2 thousandths, and another one hardly worse, to %3">(
           alphaText(sound.alpha), shortNumber(kPer1000 * sound.error), shortNumber(kPer1000 * others)),
       say<"Capture a scene in which history is kept: still, with fine detail.">(),
       {sound.alpha == kAllNew ? Fault::AlphaOne : Fault::AlphaZero}});
}

/// Whether α is stuck at 0 or 1, and the finding of it. `mistake`: what leaves least of what is no weight.
bool tellStuckAlpha(const ResolveEvidence& evidence, const std::optional<ResolveFit>& mistake,
                    Diagnosis& out) {
  const double others = leastOfOthers(evidence);
  for (const std::size_t alpha : {kAllNew, kNothingNew}) {
    const auto fit = evidence.bestWith(ResolveKind::Sound, PixelSet::Anywhere, alpha);
    if (!fit || fit->error > kAlike) continue;
    if (!isMuchBetter(fit->error, others) && !isStuckExactly(fit->error, others)) continue;
    if (mistake && isMuchBetter(mistake->error, fit->error)) continue;
    if (alpha == kAllNew && !evidence.isJittered()) {
      out.notes.push_back(
          say<"The output is the frame itself: nothing accumulates, and nothing is jittered.">());
      return true;
    }
    Finding finding = resolveFinding(
        {alpha == kAllNew ? Fault::AlphaOne : Fault::AlphaZero, "", "", "",
         alpha == kAllNew
             ? say<"Mix a part of the history in: the weight of the current frame is 1 everywhere. Without "
                   "that, "
                   "turn the jitter off.">()
             : say<"Mix a part of the current frame in: its weight is 0 wherever history is kept.">()});
    finding.reason = say<"The output differs by %1 thousandths from what a weight of the current frame of %2 "
                         "makes, and by %3 from the nearest that any other makes.">(
        shortNumber(kPer1000 * fit->error), alphaText(alpha), shortNumber(kPer1000 * others));
    finding.measure = measureText();
    finding.residuals = residualsByAlpha(evidence, alpha);
    out.findings.push_back(std::move(finding));
    return true;
  }
  return false;
}

bool seesCuts(const ResolveEvidence& evidence) {
  return std::ranges::any_of(evidence.models(), [](const ModelEvidence& model) {
    return model.isTried && model.cuts.pixels >= kEnoughApart;
  });
}

/// Whether histories go on where the frames say that they start anew, by the models that fit elsewhere.
void tellCuts(const ResolveEvidence& evidence, const ResolveFit& sound, Diagnosis& out) {
  if (!seesCuts(evidence)) {
    out.parts.leaveOpen({say<"The resolve at cuts">(),
                         say<"none of these frames states that history starts anew">(),
                         say<"Capture a cut and some frames before and after it.">(),
                         {Fault::NoResetAtCut}});
    return;
  }
  const AlphaErrors* nearest = nullptr;
  std::size_t alpha = kOwnRule;
  double reset = 1.0;
  for (const ModelEvidence& model : evidence.models()) {
    if (model.cuts.pixels < kEnoughApart || !model.isTried) continue;
    reset = std::min(reset, model.cuts.mean(kAllNew));
    for (const std::size_t tried : {kOwnRule, sound.alpha}) {
      if (tried == kAllNew || (nearest && model.cuts.mean(tried) >= nearest->mean(alpha))) continue;
      nearest = &model.cuts;
      alpha = tried;
    }
  }
  if (!nearest || nearest->mean(alpha) > kNear || !isMuchBetter(nearest->mean(alpha), reset)) return;
  Finding finding = resolveFinding({Fault::NoResetAtCut, "", "", "",
                                    say<"Take the current frame alone in the first frame after a cut: pass "
                                        "the flag that resets history.">()});
  finding.reason = say<"Where frames say that history starts anew the output differs by %1 thousandths from "
                       "what goes on with the old one, and by %2 from the current frame.">(
      shortNumber(kPer1000 * nearest->mean(alpha)), shortNumber(kPer1000 * reset));
  finding.measure = measureText();
  finding.residuals = {{"goesOn", say<"history goes on">(), kPer1000 * nearest->mean(alpha), false, true},
                       {"reset", say<"history starts anew">(), kPer1000 * reset, true, false}};
  out.findings.push_back(std::move(finding));
}

void tellValues(const OutputValues& values, Diagnosis& out) {
  if (values.keepsNan()) {
    Finding finding = resolveFinding(
        {Fault::NanKept, "", "", "",
         say<"Replace what is no number, both in the current frame and in the history that is read, and find "
             "what makes it: it came up first in frame %1.">(out.frameNames.of(values.firstFrame))});
    finding.reason = say<"In %1 of %2 frames pixels of the output are no number though the frame's colors "
                         "around them are; in frame %3 there are %4, one of them at (%5, %6).">(
        values.spoiledFrames, values.frames, out.frameNames.of(values.mostFrame), values.most,
        values.mostPixel.x, values.mostPixel.y);
    out.findings.push_back(std::move(finding));
  }
  if (!values.isOfFewBits()) return;
  Finding finding = resolveFinding(
      {Fault::LowPrecision, "", "", "",
       say<"Keep history in 16 bits a channel: in 8 bits a part of a step that is to be added is lost each "
           "frame.">()});
  finding.reason =
      say<"All of %1 values of the output are whole numbers of 1/255, and %2 of %3 values of the "
          "frames' colors are.">(values.values, values.colorInSteps, values.colorValues);
  if (values.resting > 0)
    finding.reason +=
        " " + say<"Of %1 values at rest that the frame wants otherwise by one to three steps %2 "
                  "stay as they are.">(values.resting, values.stuck);
  finding.confidence =
      values.resting > 0 && values.stuck * 2 > values.resting ? Confidence::Sure : Confidence::Likely;
  out.findings.push_back(std::move(finding));
}

/// Those of the resolve; `values`: also those that values show by themselves.
std::vector<Fault> resolveFaults(bool values) {
  std::vector<Fault> out;
  for (const FaultInfo& info : faultTable())
    if (info.part == FaultPart::Resolve &&
        (values || (info.fault != Fault::NanKept && info.fault != Fault::LowPrecision)))
      out.push_back(info.fault);
  return out;
}

void leaveUndecided(std::string reason, std::string capture, Diagnosis& out, bool hasOutput = true) {
  out.parts.leaveOpen(
      {say<"The resolve">(), std::move(reason), std::move(capture), resolveFaults(!hasOutput)});
}

/// Mean distance over the pairs from one on, by its number in pairFrames(); infinite where the model was not
/// tried in all of them. Some are tried from the third pair on: the last pairs are the same.
double errorFrom(const ResolveEvidence& evidence, const ResolveFit& fit, std::size_t pair) {
  const std::vector<AlphaErrors>& pairs = evidence.models()[fit.model].pairs;
  const std::size_t asked = evidence.pairFrames().size() - pair;
  if (asked == 0 || pairs.size() < asked) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (std::size_t i = pairs.size() - asked; i < pairs.size(); ++i) sum += pairs[i].mean(fit.alpha);
  return sum / static_cast<double>(asked);
}

/// The first pair in which a sound fit that is exact before ceases to be, for good.
std::optional<std::size_t> turnOf(const ResolveEvidence& evidence, const ResolveFit& fit) {
  constexpr std::size_t kEnoughBefore = 4, kEnoughAfter = 3;
  constexpr double kClearlyOff = 2.0 * kExact;
  const std::vector<AlphaErrors>& pairs = evidence.models()[fit.model].pairs;
  if (pairs.size() != evidence.pairFrames().size()) return {};
  const auto isOff = [&](const AlphaErrors& pair) { return pair.mean(fit.alpha) > kExact; };
  const auto first = std::ranges::find_if(pairs, isOff);
  const auto turn = static_cast<std::size_t>(first - pairs.begin()), after = pairs.size() - turn;
  if (turn < kEnoughBefore || after < kEnoughAfter || errorFrom(evidence, fit, turn) < kClearlyOff) return {};
  const auto off = std::ranges::count_if(first, pairs.end(), isOff);
  return static_cast<double>(off) >= kPairsWon * static_cast<double>(after) ? std::optional(turn)
                                                                            : std::nullopt;
}

/// Every model that is looked at everywhere with every α, sound or not.
std::vector<ResolveFit> fitsEverywhere(bool isSound) {
  std::vector<ResolveFit> out;
  for (std::size_t model = 0; model < resolveModels().size(); ++model) {
    const ResolveKind kind = resolveModels()[model].kind;
    if ((kind == ResolveKind::Sound) != isSound || setOf(kind) != PixelSet::Anywhere) continue;
    for (std::size_t alpha = 0; alpha <= kTriedAlphas.size(); ++alpha) out.push_back({model, alpha, 0.0});
  }
  return out;
}

/// Of these the one that leaves least from a pair on; infinite: none was tried there.
ResolveFit bestFrom(const ResolveEvidence& evidence, std::size_t pair, bool isSound) {
  ResolveFit best{0, 0, std::numeric_limits<double>::infinity()};
  for (ResolveFit fit : fitsEverywhere(isSound)) {
    fit.error = errorFrom(evidence, fit, pair);
    if (fit.error < best.error) best = fit;
  }
  return best;
}

/// A mistake that begins in a frame.
Finding mistakeFrom(const ResolveFit& mistake, double soundError, const std::string& first,
                    const std::string& last) {
  const ResolveKind kind = modelOf(mistake).kind;
  Finding out = resolveFinding(resolveWordsOf(kind));
  out.reason =
      say<"From frame %1 on the output differs by %2 thousandths from what frames and history make if %3, "
          "and by %4 if %5; up to frame %6 it is made as it should be.">(
          first, shortNumber(kPer1000 * mistake.error), resolveKindText(kind),
          shortNumber(kPer1000 * soundError), resolveKindText(ResolveKind::Sound), last);
  out.measure = measureText();
  out.residuals = {{resolveKindId(kind), resolveKindText(kind), kPer1000 * mistake.error, false, true},
                   {resolveKindId(ResolveKind::Sound), resolveKindText(ResolveKind::Sound),
                    kPer1000 * soundError, true, false}};
  out.confidence = mistake.error <= kExact ? Confidence::Sure : Confidence::Likely;
  return out;
}

/// An output that is right up to a frame, by the sound fit that is so the longest. False: there is none.
bool tellTurn(const ResolveEvidence& evidence, Diagnosis& out) {
  std::optional<std::size_t> turn;
  for (const ResolveFit& fit : fitsEverywhere(true)) turn = std::max(turn, turnOf(evidence, fit));
  if (!turn) return false;
  const std::string last = out.frameNames.of(evidence.pairFrames()[*turn - 1]);
  const std::string first = out.frameNames.of(evidence.pairFrames()[*turn]);
  const ResolveFit sound = bestFrom(evidence, *turn, true), mistake = bestFrom(evidence, *turn, false);
  if (isMuchBetter(mistake.error, sound.error)) {
    out.findings.push_back(mistakeFrom(mistake, sound.error, first, last));
    return true;
  }
  Undecided open{
      say<"The resolve">(),
      say<"up to frame %1 the output is made of frames and history as it should be, and from frame %2 "
          "on it is %3 thousandths from whatever else was tried">(
          last, first, shortNumber(kPer1000 * std::min(sound.error, mistake.error))),
      say<"Look at what changes in the resolve, or in what it reads, in that frame.">(),
      resolveFaults(false)};
  // Another α from a frame on is no mistake.
  open.isMisfit = sound.error > kExact;
  if (!open.isMisfit)
    open.reason = say<"the output is made of frames and history as it should be, from frame %1 on with other "
                      "settings than up to frame %2">(first, last);
  out.parts.leaveOpen(std::move(open));
  return true;
}

/// What fits, if all is as it should be, or why nothing is said.
void tellNearest(const ResolveFit& sound, Diagnosis& out) {
  if (sound.error <= kExact)
    out.parts.addRight(say<"The resolve">(),
                       say<"The output is made of frames and history as it should be.">() + " " +
                           nearestText(sound));
  else
    leaveUndecided(
        say<"no resolve that is known here makes this output, to a thousandth: the nearest, preset \"%1\", is "
            "%2 thousandths off">(modelOf(sound).preset->id, shortNumber(kPer1000 * sound.error)),
        say<"Capture the output before it is tone-mapped, sharpened or drawn over.">(), out);
}

/// Whether what is sound explains a set clearly better than each mistake that shows there.
bool isSoundAt(const ResolveEvidence& evidence, PixelSet set) {
  const auto sound = evidence.best(ResolveKind::Sound, set);
  for (std::size_t k = 0; k < kResolveKinds && sound; ++k) {
    const auto kind = static_cast<ResolveKind>(k);
    if (kind == ResolveKind::Sound || setOf(kind) != set) continue;
    const auto mistake = evidence.best(kind, set);
    if (mistake && mistake->error - sound->error < kExactLess) return false;
  }
  return sound.has_value();
}

/// Mistakes at pixels that lie apart; rests on models that fit all others.
void tellApart(const ResolveEvidence& evidence, Diagnosis& out) {
  // Nothing: there are too few of them. False: a mistake makes as good as the same there.
  const auto told = [&](PixelSet set) -> std::optional<bool> {
    const auto fit = mistakeOf(evidence, set);
    const bool isExact = fit && fit->error <= kExactLess;
    if (evidence.pixels(set) < (isExact ? kEnoughExactApart : kEnoughApart)) return {};
    if (!fit) return isSoundAt(evidence, set);
    tellMistake(evidence, *fit, out);
    return true;
  };
  if (const std::optional<bool> isTold = told(PixelSet::Silhouettes); !isTold.value_or(false))
    out.parts.leaveOpen({say<"Dilation">(),
                         isTold ? say<"at rims the motion of the farthest makes as good as the same">()
                                : say<"too few rims move otherwise than what is behind them">(),
                         say<"Let something move before a background that rests.">(),
                         {Fault::DilatesFarthest}});
  if (const std::optional<bool> isTold = told(PixelSet::Border); !isTold.value_or(false))
    out.parts.leaveOpen({say<"History beyond the picture">(),
                         isTold ? say<"what comes in from its border looks as good as the same there">()
                                : say<"too little comes in from its border">(),
                         say<"Let the camera turn by some pixels a frame.">(),
                         {Fault::OffScreenClamped}});
}

} // namespace

void tellResolve(const ResolveEvidence& evidence, bool areInputsRight, Diagnosis& out) {
  if (!evidence.hasOutput()) {
    leaveUndecided(say<"there is no output of the engine">(),
                   say<"Capture what the engine's TAA makes of each frame, too.">(), out, false);
    return;
  }
  const std::size_t before = out.findings.size();
  tellValues(evidence.values(), out);
  if (evidence.isOtherSize()) {
    leaveUndecided(say<"the output is larger than what is drawn">(),
                   say<"Capture a few frames at a render scale of 1.">(), out);
    return;
  }
  const auto sound = evidence.best(ResolveKind::Sound, PixelSet::Anywhere);
  if (!sound || evidence.pixels(PixelSet::Anywhere) < kEnoughPixels) {
    leaveUndecided(say<"too few pairs of frames have detail and go on from each other">(),
                   say<"Capture 12 frames or more of a detailed scene in motion.">(), out);
    return;
  }
  const auto mistake = mistakeOf(evidence, PixelSet::Anywhere);
  const double least = mistake ? mistake->error : sound->error;
  if (!areInputsRight && least > kExact) {
    leaveUndecided(say<"the frames that it is made of are wrong">(), say<"Mend these first.">(), out);
    return;
  }
  // Motion that is stated otherwise than it is used looks like history that is read elsewhere.
  if (!areInputsRight && mistake && isOfReading(modelOf(*mistake).kind)) {
    leaveUndecided(say<"it is made as if %1, which what is wrong with its frames may be as well">(
                       resolveKindText(modelOf(*mistake).kind)),
                   say<"Mend these first.">(), out);
    return;
  }
  if (tellStuckAlpha(evidence, mistake, out)) return;
  if (!mistake && sound->error > kExact && tellTurn(evidence, out)) return;
  const bool isMistaken = mistake && pairsWon(evidence, *mistake, *sound) >= kPairsWon;
  if (isMistaken)
    tellMistake(evidence, *mistake, out);
  else if (sound->error <= kAlike)
    tellApart(evidence, out);
  tellCuts(evidence, *sound, out);
  // Nothing is as it should be beside a finding of the resolve.
  const bool isFound = out.findings.size() > before;
  if (isMistaken || (isFound && sound->error <= kAlike)) return;
  const bool isStuck = sound->alpha == kNothingNew || (sound->alpha == kAllNew && evidence.isJittered());
  if (isStuck && sound->error <= kAlike)
    tellOpenAlpha(*sound, leastOfOthers(evidence), out);
  else
    tellNearest(*sound, out);
}

} // namespace taa::doctor
