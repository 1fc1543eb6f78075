#include "core/doctor/resolve/ResolveEvidence.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace taa::doctor {

namespace {

/// Pairs with all models, and those afterwards with the likeliest.
constexpr int kPairsOfAll = 2, kPairsOfEach = 8;
/// After so many pairs, of each few frames one is compared.
constexpr int kOneOf = 4;
constexpr std::size_t kPixelsOfAll = 48, kPixelsOfLikely = 160, kPixelsApart = 80;
/// Models of a kind that stay.
constexpr std::size_t kLikelySound = 8, kLikelyOther = 4;
constexpr std::size_t kBestPresets = 2; ///< whose mistakes stay, too
/// Frames from the start of history on that are not compared: N is still small, and differs.
constexpr int kSettlingFrames = 2;
constexpr int kLongHistory = 64;

ResolveKind kindOf(std::size_t model) {
  return resolveModels()[model].kind;
}

} // namespace

void AlphaErrors::add(const ModelDistances& distances, std::size_t count) {
  pixels += count;
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += static_cast<double>(distances[i]);
}

double AlphaErrors::mean(std::size_t alpha) const {
  return pixels == 0 ? std::numeric_limits<double>::infinity() : sums[alpha] / static_cast<double>(pixels);
}

ResolveEvidence::ResolveEvidence() : models_(resolveModels().size()) {}

void ResolveEvidence::add(const DoctorFrame& frame, const DoctorFrame* before) {
  const bool isComparable = before && !frame.output.empty() && !before->output.empty() &&
                            !frame.motionPx.empty() && !frame.color.empty();
  values_.add(frame, frame.startsHistory ? nullptr : before);
  if (frame.jitterPx != glm::vec2(0.0f)) isJittered_ = true;
  if (isComparable) {
    const glm::ivec2 size = frame.sizePx();
    if (frame.output.width != size.x || frame.output.height != size.y) isOtherSize_ = true;
    const ResolveFrames frames{frame, *before, outputTwoBefore_, historyFrames_};
    if (!isOtherSize_ && frame.startsHistory)
      compareCut(frames);
    else if (!isOtherSize_ && historyFrames_ > kSettlingFrames &&
             (pairs_ < kPairsOfEach || frame.frame % kOneOf == 0))
      compare(frames);
  }
  // What is looked at from the middle of a shot on has had its history for long.
  if (!before && !frame.startsHistory) historyFrames_ = kLongHistory;
  historyFrames_ = frame.startsHistory ? 1 : historyFrames_ + 1;
  outputTwoBefore_ = frame.startsHistory ? Image() : std::exchange(outputBefore_, {});
  outputBefore_ = frame.output;
}

bool ResolveEvidence::isWanted(std::size_t model, PixelSet set) const {
  const PixelSet own = setOf(kindOf(model));
  // What tells of pixels apart is looked at once the likely presets are known.
  if (own != PixelSet::Anywhere && pairs_ < kPairsOfAll) return false;
  // The farthest of nine may look like history that is read where the pixel is.
  const bool isEverywhere = kindOf(model) == ResolveKind::Sound || kindOf(model) == ResolveKind::Farthest;
  return models_[model].isTried && (own == set || isEverywhere);
}

void ResolveEvidence::compare(const ResolveFrames& frames) {
  pairFrames_.push_back(frames.now.frame);
  ResolveTwin twin(frames);
  const bool isOfAll = pairs_ < kPairsOfAll;
  for (const PixelSet set : {PixelSet::Anywhere, PixelSet::Silhouettes, PixelSet::Border}) {
    if (isOfAll && set != PixelSet::Anywhere) continue;
    const std::size_t most = set != PixelSet::Anywhere ? kPixelsApart
                             : isOfAll                 ? kPixelsOfAll
                                                       : kPixelsOfLikely;
    const std::vector<glm::ivec2> pixels = resolvePixels(frames, set, most);
    if (pixels.empty()) continue;
    pixels_[static_cast<std::size_t>(set)] += pixels.size();
    for (std::size_t model = 0; model < models_.size(); ++model) {
      if (!isWanted(model, set) || !twin.canTry(resolveModels()[model])) continue;
      const ModelDistances distances = twin.distances(resolveModels()[model], pixels);
      models_[model].sets[static_cast<std::size_t>(set)].add(distances, pixels.size());
      if (setOf(kindOf(model)) == set) models_[model].pairs.emplace_back().add(distances, pixels.size());
    }
  }
  if (++pairs_ == kPairsOfAll) keepLikely();
}

void ResolveEvidence::compareCut(const ResolveFrames& frames) {
  ResolveTwin twin(frames);
  const std::vector<glm::ivec2> pixels = resolvePixels(frames, PixelSet::Anywhere, kPixelsOfLikely);
  for (std::size_t model = 0; model < models_.size() && !pixels.empty(); ++model)
    if (kindOf(model) == ResolveKind::Sound && models_[model].isTried)
      models_[model].cuts.add(twin.distances(resolveModels()[model], pixels), pixels.size());
}

/// Of each kind those that explain the first pairs best, and those of the best sound presets, as a mistake
/// may begin later; of kinds that show at few pixels, those of the sound presets that stay.
void ResolveEvidence::keepLikely() {
  const auto leastError = [&](std::size_t model) {
    const AlphaErrors& errors = models_[model].sets[static_cast<std::size_t>(PixelSet::Anywhere)];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t alpha = 0; alpha < errors.sums.size(); ++alpha)
      least = std::min(least, errors.mean(alpha));
    return least;
  };
  std::vector<const Preset*> best; // sound ones are asked first
  for (std::size_t k = 0; k < kResolveKinds; ++k) {
    const auto kind = static_cast<ResolveKind>(k);
    std::vector<std::size_t> ofKind;
    for (std::size_t model = 0; model < models_.size(); ++model)
      if (kindOf(model) == kind) ofKind.push_back(model);
    if (setOf(kind) == PixelSet::Anywhere) {
      std::ranges::stable_sort(ofKind, {}, leastError);
      if (kind == ResolveKind::Sound)
        for (std::size_t i = 0; i < kBestPresets; ++i) best.push_back(resolveModels()[ofKind[i]].preset);
      const std::size_t kept = kind == ResolveKind::Sound ? kLikelySound : kLikelyOther;
      for (std::size_t i = kept; i < ofKind.size(); ++i)
        models_[ofKind[i]].isTried =
            kind != ResolveKind::Sound && std::ranges::count(best, resolveModels()[ofKind[i]].preset) > 0;
      continue;
    }
    for (const std::size_t model : ofKind)
      models_[model].isTried = std::ranges::any_of(resolveModels(), [&](const ResolveModel& other) {
        const auto index = static_cast<std::size_t>(&other - resolveModels().data());
        return other.kind == ResolveKind::Sound && models_[index].isTried &&
               other.preset == resolveModels()[model].preset;
      });
  }
}

std::optional<ResolveFit> ResolveEvidence::bestWith(ResolveKind kind, PixelSet set, std::size_t alpha) const {
  std::optional<ResolveFit> out;
  for (std::size_t model = 0; model < models_.size(); ++model) {
    const AlphaErrors& errors = models_[model].sets[static_cast<std::size_t>(set)];
    if (kindOf(model) != kind || !models_[model].isTried || errors.pixels == 0) continue;
    if (!out || errors.mean(alpha) < out->error) out = ResolveFit{model, alpha, errors.mean(alpha)};
  }
  return out;
}

std::optional<ResolveFit> ResolveEvidence::best(ResolveKind kind, PixelSet set) const {
  std::optional<ResolveFit> out;
  for (std::size_t alpha = 0; alpha < std::tuple_size_v<ModelDistances>; ++alpha) {
    const auto fit = bestWith(kind, set, alpha);
    if (fit && (!out || fit->error < out->error)) out = fit;
  }
  return out;
}

} // namespace taa::doctor
