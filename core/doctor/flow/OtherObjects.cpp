#include "core/doctor/flow/OtherObjects.h"

#include "core/base/Median.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace taa::doctor {

namespace {

/// Of a region in a pair of frames, px; both without the camera's motion, where that is known.
struct OwnMotion {
  std::optional<glm::dvec2> measured;
  glm::dvec2 given{0.0};
  double distance = 0.0; ///< m; 0: no depth tells
};

/// px: that far a vector of an object may be from that of another one, which lies elsewhere.
double alikePx(const glm::dvec2& motion) {
  constexpr double kLeastPx = 0.75, kShare = 0.15;
  return std::max(kLeastPx, kShare * glm::length(motion));
}

/// Of frames that say whether one vector is another one.
struct Votes {
  std::size_t asked = 0, won = 0;
  double length = 0.0; ///< sum
  std::vector<double> off;

  void add(const glm::dvec2& expected, const glm::dvec2& given) {
    ++asked;
    const double offPx = glm::distance(expected, given);
    if (offPx <= alikePx(given)) ++won;
    off.push_back(offPx);
    length += glm::length(given);
  }
  bool isSo() const {
    constexpr std::size_t kEnough = 3;
    constexpr double kNearlyAll = 0.8, kLongPx = 1.0;
    return won >= kEnough && static_cast<double>(won) >= kNearlyAll * static_cast<double>(asked) &&
           length >= kLongPx * static_cast<double>(asked);
  }
};

class ObjectMotions {
 public:
  explicit ObjectMotions(const FlowSeen& seen) : seen_(seen) {
    for (std::size_t i = 0; i < seen.pairs.size(); ++i) addPair(i);
  }

  bool areCamerasKnown() const { return areCamerasKnown_; }

  /// Whether the motion given of one is what the other one moves by: on the screen, or in the world, where
  /// the same is longer on the screen the nearer it is.
  Votes asMotion(RegionIndex one, RegionIndex other, bool isInWorld) const {
    constexpr double kClearlyOffPx = 1.0;
    Votes out;
    for (const auto& motions : pairs_) {
      const auto own = motions.find(one), others = motions.find(other);
      if (own == motions.end() || others == motions.end() || !others->second.measured) continue;
      const OwnMotion& of = own->second;
      if (of.measured && glm::distance(*of.measured, of.given) < kClearlyOffPx) continue;
      const double theirs = others->second.distance;
      if (isInWorld && !(of.distance > 0.0 && theirs > 0.0)) continue;
      out.add((isInWorld ? theirs / of.distance : 1.0) * *others->second.measured, of.given);
    }
    return out;
  }

  /// Whether the motion given of one leads to where the other one was.
  Votes asPlace(RegionIndex one, RegionIndex other) const {
    Votes out;
    for (std::size_t i = 1; i < seen_.pairs.size(); ++i) {
      const FlowPair &now = seen_.pairs[i], &before = seen_.pairs[i - 1];
      const auto own = now.means.find(one), others = before.means.find(other);
      if (now.frame != before.frame + 1 || own == now.means.end() || others == before.means.end()) continue;
      out.add(own->second.middle - others->second.middle, own->second.given);
    }
    return out;
  }

 private:
  void addPair(std::size_t index) {
    const FlowPair& pair = seen_.pairs[index];
    std::map<RegionIndex, std::pair<std::vector<double>, std::vector<double>>> squares;
    for (const FlowSquare& square : pair.squares) {
      squares[square.region].first.push_back(square.px.x);
      squares[square.region].second.push_back(square.px.y);
    }
    auto& motions = pairs_.emplace_back();
    for (const auto& [region, means] : pair.means) {
      const glm::dvec2 camera = means.camera.value_or(glm::dvec2(0.0));
      OwnMotion& motion = motions[region];
      motion.given = means.given - camera;
      motion.distance = means.distance;
      if (const auto own = squares.find(region); own != squares.end()) {
        motion.measured = glm::dvec2(median(own->second.first), median(own->second.second)) - camera;
        areCamerasKnown_ = areCamerasKnown_ && means.camera.has_value();
      } else if (const auto moved = middleMoved(index, region, means)) {
        motion.measured = *moved - camera;
      }
    }
  }

  /// What the middle of a region moves by that is seen whole.
  std::optional<glm::dvec2> middleMoved(std::size_t index, RegionIndex region,
                                        const RegionMeans& means) const {
    if (index == 0 || !means.isWhole) return {};
    const FlowPair &now = seen_.pairs[index], &before = seen_.pairs[index - 1];
    const auto then = before.means.find(region);
    if (now.frame != before.frame + 1 || then == before.means.end() || !then->second.isWhole) return {};
    return means.middle - then->second.middle;
  }

  const FlowSeen& seen_;
  std::vector<std::map<RegionIndex, OwnMotion>> pairs_;
  bool areCamerasKnown_ = true;
};

/// Centroids of the objects of a frame that no border cuts.
std::map<RegionIndex, glm::dvec2> wholeObjects(const FlowPair& pair, const FlowSeen& seen) {
  std::map<RegionIndex, glm::dvec2> out;
  for (const auto& [region, means] : pair.means)
    if (means.isWhole && seen.regions[static_cast<std::size_t>(region)].objectId != 0)
      out[region] = means.middle;
  return out;
}

/// The object that was at a place, and how far from it: clearly nearer than any other one. The middle of what
/// is seen of an object in its own place and in another one's is not the same point of it.
std::optional<std::pair<RegionIndex, double>> objectAt(const glm::dvec2& place,
                                                       const std::map<RegionIndex, glm::dvec2>& objects) {
  constexpr double kClearlyNearer = 0.3;
  std::optional<std::pair<RegionIndex, double>> nearest;
  double next = std::numeric_limits<double>::infinity();
  for (const auto& [region, middle] : objects) {
    const double px = glm::distance(place, middle);
    if (nearest && px >= nearest->second) {
      next = std::min(next, px);
      continue;
    }
    if (nearest) next = nearest->second;
    nearest = {region, px};
  }
  return nearest && nearest->second <= kClearlyNearer * next ? nearest : std::nullopt;
}

} // namespace

std::vector<SlippedFrame> slippedFrames(const FlowSeen& seen) {
  constexpr std::size_t kEnough = 3;
  constexpr double kNearlyAll = 0.8, kWrongPx = 2.0;
  std::vector<SlippedFrame> out;
  for (std::size_t i = 1; i < seen.pairs.size(); ++i) {
    const FlowPair &now = seen.pairs[i], &before = seen.pairs[i - 1];
    if (now.frame != before.frame + 1) continue;
    const std::map<RegionIndex, glm::dvec2> objects = wholeObjects(now, seen),
                                            were = wholeObjects(before, seen);
    SlippedFrame slipped;
    slipped.frame = now.frame;
    std::vector<double> off;
    for (const auto& [region, middle] : objects) {
      const auto own = were.find(region);
      const glm::dvec2 given = now.means.at(region).given, from = middle - given;
      if (own == were.end() || glm::distance(from, own->second) < kWrongPx + alikePx(given)) continue;
      slipped.regions.push_back(&seen.regions[static_cast<std::size_t>(region)]);
      const auto other = objectAt(from, were);
      if (!other || other->first == region) continue;
      slipped.example = slipped.regions.back();
      slipped.other = &seen.regions[static_cast<std::size_t>(other->first)];
      off.push_back(other->second);
    }
    slipped.told = off.size();
    if (slipped.told < kEnough ||
        static_cast<double>(slipped.told) < kNearlyAll * static_cast<double>(slipped.regions.size()))
      continue;
    slipped.px = median(std::move(off));
    out.push_back(std::move(slipped));
  }
  return out;
}

std::vector<OfOtherObject> ofOtherObjects(const std::vector<Refuted>& refuted, const FlowSeen& seen) {
  const ObjectMotions motions(seen);
  std::map<RegionIndex, OfOtherObject> best;
  const auto keep = [&](RegionIndex one, RegionIndex other, Votes votes, OtherObjectKind kind) {
    if (!votes.isSo()) return;
    const double px = median(std::move(votes.off));
    const auto known = best.find(one);
    if (known != best.end() && known->second.px <= px) return;
    best[one] = {&seen.regions[static_cast<std::size_t>(one)],
                 &seen.regions[static_cast<std::size_t>(other)],
                 kind,
                 votes.won,
                 votes.asked,
                 px};
  };
  for (const Refuted& each : refuted) {
    if (!each.region || each.region->objectId == 0) continue;
    const auto one = static_cast<RegionIndex>(each.region - seen.regions.data());
    for (RegionIndex other = 0; other < std::ssize(seen.regions); ++other) {
      const Region& region = seen.regions[static_cast<std::size_t>(other)];
      if (other == one || region.objectId == 0) continue;
      // Without cameras the motion of what rests is that of nothing else.
      const bool isWrong = std::ranges::count(refuted, &region, &Refuted::region) > 0;
      for (const bool isInWorld : {false, true}) {
        if (motions.areCamerasKnown() || isWrong)
          keep(one, other, motions.asMotion(one, other, isInWorld), OtherObjectKind::Motion);
        keep(other, one, motions.asMotion(other, one, isInWorld), OtherObjectKind::Motion);
      }
      keep(one, other, motions.asPlace(one, other), OtherObjectKind::Place);
    }
  }
  std::vector<OfOtherObject> out;
  for (const auto& [region, found] : best) out.push_back(found);
  const bool isAnyRefuted = std::ranges::any_of(out, [&](const OfOtherObject& one) {
    return std::ranges::count(refuted, one.region, &Refuted::region) > 0;
  });
  return isAnyRefuted ? out : std::vector<OfOtherObject>();
}

} // namespace taa::doctor
