#include "core/doctor/source/StatedMotion.h"

#include "core/base/Say.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/source/OtherConventions.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace taa::doctor {

namespace {

using capture::Conventions;
using capture::FramePair;
using capture::FrameSamples;

constexpr int kPairs = 3;
constexpr std::size_t kPlacesOfPair = 2500;
/// Pixels that the camera moves: fewer say nothing.
constexpr std::size_t kEnoughMoved = 200;
constexpr double kMovedShare = 0.1;
/// Of these: what is stated is right; one thing, or two things, stated otherwise explain them, and so many
/// more than what is stated. Of hundreds of pairs of things one fits a half of the pixels by chance.
constexpr double kRightShare = 0.9, kExplainedShare = 0.6, kExplainedByTwo = 0.85, kMoreShare = 0.15;
/// What explains so much less explains as much.
constexpr double kSameShare = 0.03;

/// A part of a pair's pixels, without its pictures.
FramePair thinned(const FramePair& pair) {
  FramePair out;
  out.index = pair.index;
  const std::size_t step = std::max<std::size_t>(1, pair.places.size() / kPlacesOfPair);
  const std::size_t count = (pair.places.size() + step - 1) / step;
  out.motion = Image(static_cast<int>(count), 1, pair.motion.channels);
  out.depth = Image(static_cast<int>(count), 1, pair.depth.channels);
  for (std::size_t i = 0; i < count; ++i) {
    out.places.push_back(pair.places[i * step]);
    const int from = static_cast<int>(i * step), to = static_cast<int>(i);
    std::copy_n(pair.motion.at(from, 0), pair.motion.channels, out.motion.at(to, 0));
    std::copy_n(pair.depth.at(from, 0), pair.depth.channels, out.depth.at(to, 0));
  }
  return out;
}

/// Pixels that the camera moves, and those of them whose motion is the camera's.
struct Fit {
  std::size_t places = 0, moved = 0, fits = 0;

  bool isEnough() const {
    return moved >= kEnoughMoved && static_cast<double>(moved) >= kMovedShare * static_cast<double>(places);
  }
  double share() const { return isEnough() ? static_cast<double>(fits) / static_cast<double>(moved) : 0.0; }
};

class MotionFits {
 public:
  MotionFits(const std::filesystem::path& folder, const capture::Manifest& manifest, int pairs)
      : samples_(folder, manifest, pairs, {}) {
    for (const FramePair& pair : samples_.pairs())
      if (!pair.motion.empty() && !pair.depth.empty()) pairs_.push_back(thinned(pair));
  }

  float lowestDepth() const {
    float lowest = 0.0f;
    for (const FramePair& pair : pairs_)
      for (const float depth : pair.depth.pixels) lowest = std::min(lowest, depth);
    return lowest;
  }
  Fit of(const Conventions& conventions) {
    Fit out;
    for (const FramePair& pair : pairs_)
      if (const auto motion = samples_.motionOf(pair, {conventions}, true))
        add(*motion, conventions.motion, out);
    return out;
  }

 private:
  static void add(const capture::PairMotion& motion, const capture::MotionConventions& stated, Fit& out) {
    constexpr float kMovedPx = 0.5f, kSamePx = 0.05f, kSameShareOfLength = 1.0f / 512.0f;
    // Where the camera's motion is added, what rests has none: motion of too small a unit is nearly none.
    constexpr float kNothingPx = 5e-4f;
    const auto isKnown = [](const glm::vec2& px) { return std::isfinite(px.x) && std::isfinite(px.y); };
    if (motion.camera.empty() || std::ranges::none_of(motion.stored, isKnown)) return;
    for (std::size_t i = 0; i < motion.camera.size(); ++i) {
      const glm::vec2& camera = motion.camera[i];
      const float length = glm::length(camera);
      // Where nothing is drawn it may be the camera's because that is stated.
      const bool isNothing = !motion.depth.empty() && motion.depth[i] == 0.0f;
      if (isNothing && stated.whereNothing) continue;
      ++out.places;
      if (!(length >= kMovedPx) || !(length < kNoPreviousPosition)) continue;
      ++out.moved;
      const float sameAsPx = stated.includesCamera ? kSamePx + kSameShareOfLength * length : kNothingPx;
      // Written so that NaN fails it.
      if (glm::distance(motion.stored[i], camera) <= sameAsPx) ++out.fits;
    }
  }

  FrameSamples samples_;
  std::vector<FramePair> pairs_;
};

/// Nothing, one or two things that are stated otherwise.
using Changes = std::vector<const Otherwise*>;

/// Whether what is stated beside rows from the other end could stand for a part of them, or for nothing.
bool hidesRows(StatedGroup group) {
  return group == StatedGroup::MotionAxes || group == StatedGroup::ClipAxis ||
         group == StatedGroup::JitterSign || group == StatedGroup::JitterFrame;
}

std::vector<Changes> changesOf(const std::vector<Otherwise>& others) {
  std::vector<Changes> out;
  for (const Otherwise& one : others)
    if (!one.isOfSeveral) out.push_back({&one});
  for (const Otherwise& one : others)
    for (const Otherwise& two : others) {
      if (!(one.group < two.group) || (two.isOfSeveral && hidesRows(one.group))) continue;
      const bool addsCamera = one.addsCamera || two.addsCamera;
      if (!addsCamera || two.group == StatedGroup::MotionJitter) out.push_back({&one, &two});
    }
  return out;
}

Conventions changed(Conventions conventions, const Changes& changes) {
  for (const Otherwise* change : changes) change->state(conventions);
  return conventions;
}

/// What explains most by the fewest changes; nothing where that is what is stated, or several do.
std::optional<Changes> bestChanges(MotionFits& fits, const Conventions& stated,
                                   const std::vector<Otherwise>& others) {
  std::vector<std::pair<double, Changes>> tried;
  const double least = std::max(kExplainedShare, fits.of(stated).share() + kMoreShare);
  const auto leastOf = [least](const Changes& changes) {
    return changes.size() > 1 ? std::max(least, kExplainedByTwo) : least;
  };
  // What makes most pixels rest explains the few that are left by chance.
  const std::size_t leastMoved = fits.of(stated).moved / 2;
  double best = least;
  for (Changes& changes : changesOf(others)) {
    const Fit fit = fits.of(changed(stated, changes));
    const double share = fit.moved >= leastMoved ? fit.share() : 0.0;
    if (share < leastOf(changes)) continue;
    best = std::max(best, share);
    tried.emplace_back(share, std::move(changes));
  }
  std::optional<Changes> out;
  bool isSeveral = false;
  for (const auto& [share, changes] : tried) {
    if (share < best - kSameShare) continue;
    if (!out || changes.size() < out->size()) {
      out = changes;
      isSeveral = false;
    } else if (changes.size() == out->size()) {
      isSeveral = true;
    }
  }
  if (isSeveral) return {};
  return out;
}

Finding toldFinding(const Otherwise& told, const Changes& changes, double shareStated, double share) {
  Finding out = told.finding;
  out.isWholePicture = true;
  const auto percent = [](double of) { return std::lround(100.0 * of); };
  const bool isAlone = changes.size() == 1;
  const Finding& other = changes[changes.front() == &told ? changes.size() - 1 : 0]->finding;
  out.reason =
      isAlone ? say<"The motion stored is what depth and matrices make it at %1 % of the pixels that the "
                    "camera moves if this is stated otherwise, and at %2 % as it is stated.">(
                    percent(share), percent(shareStated))
              : say<"The motion stored is what depth and matrices make it at %1 % of the pixels that the "
                    "camera moves if two things are stated otherwise, this and “%3”, and at %2 % as it is "
                    "stated.">(percent(share), percent(shareStated), other.name);
  out.measure = say<"pixels whose motion is not what depth and matrices make it, %">();
  out.residuals = {{"otherwise", say<"stated otherwise">(), 100.0 * (1.0 - share), false, true},
                   {"asStated", say<"as stated">(), 100.0 * (1.0 - shareStated), true, false}};
  return out;
}

} // namespace

std::vector<Finding> correctMotion(const std::filesystem::path& folder, capture::Manifest& manifest) {
  const Conventions& stated = manifest.conventions;
  const Fit ofOne = MotionFits(folder, manifest, 1).of(stated);
  if (ofOne.places == 0 || ofOne.share() >= kRightShare) return {};
  MotionFits fits(folder, manifest, kPairs);
  const std::vector<Otherwise> others = othersThan(manifest, fits.lowestDepth());
  const auto changes = bestChanges(fits, stated, others);
  if (!changes || (changes->size() == 1 && !changes->front()->isToldAlone)) return {};
  const Conventions right = changed(stated, *changes);
  const double shareStated = fits.of(stated).share(), share = fits.of(right).share();
  std::vector<Finding> out;
  for (const Otherwise* change : *changes) out.push_back(toldFinding(*change, *changes, shareStated, share));
  manifest.conventions = right;
  if (changes->back()->isOfSeveral) turnRows(manifest.conventions);
  return out;
}

} // namespace taa::doctor
