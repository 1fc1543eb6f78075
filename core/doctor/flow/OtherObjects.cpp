#include "core/doctor/flow/OtherObjects.h"

#include "core/base/Median.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

namespace taa::doctor {

namespace {

/// Middle values of a region's squares in a pair of frames, px.
struct RegionPair {
  glm::dvec2 measured{0.0}, given{0.0};
  glm::dvec2 camera{0.0}; ///< 0: it is not known

  double offPx() const { return glm::distance(measured, given); }
};

using RegionPairs = std::map<int, RegionPair>; ///< by frame

glm::dvec2 middleOf(const std::vector<const FlowSquare*>& squares,
                    const std::function<glm::dvec2(const FlowSquare&)>& value) {
  std::vector<double> x, y;
  for (const FlowSquare* square : squares) {
    const glm::dvec2 one = value(*square);
    x.push_back(one.x);
    y.push_back(one.y);
  }
  return {median(std::move(x)), median(std::move(y))};
}

std::map<const Region*, RegionPairs> byRegion(const FlowSeen& seen) {
  std::map<const Region*, RegionPairs> out;
  for (const FlowPair& pair : seen.pairs) {
    std::map<RegionIndex, std::vector<const FlowSquare*>> squares;
    for (const FlowSquare& square : pair.squares) squares[square.region].push_back(&square);
    for (const auto& [region, own] : squares) {
      const bool isCameraKnown =
          std::ranges::all_of(own, [](const FlowSquare* square) { return square->camera.has_value(); });
      RegionPair& one = out[&seen.regions[static_cast<std::size_t>(region)]][pair.frame];
      one.measured = middleOf(own, [](const FlowSquare& square) { return square.px; });
      one.given = middleOf(own, [](const FlowSquare& square) { return square.given; });
      if (isCameraKnown) one.camera = middleOf(own, [](const FlowSquare& square) { return *square.camera; });
    }
  }
  return out;
}

/// px: that far a vector of an object may be from that of another one, which lies elsewhere.
double tolerancePx(const glm::dvec2& motion) {
  constexpr double kLeastPx = 0.5, kShare = 0.15;
  return std::max(kLeastPx, kShare * glm::length(motion));
}

/// Of frames that say whether it is so; `offPx` to what would be there.
struct Votes {
  std::size_t asked = 0, won = 0;
  double length = 0.0; ///< sum
  std::vector<double> off;

  void add(const glm::dvec2& expected, const glm::dvec2& given) {
    ++asked;
    const double offPx = glm::distance(expected, given);
    if (offPx <= tolerancePx(given)) ++won;
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

/// Whether the own motion given of one is what pictures show of the other one.
Votes asMotion(const RegionPairs& one, const RegionPairs& other) {
  constexpr double kClearlyOffPx = 1.0;
  Votes out;
  for (const auto& [frame, pair] : one) {
    const auto at = other.find(frame);
    if (at == other.end() || pair.offPx() < kClearlyOffPx) continue;
    out.add(at->second.measured - at->second.camera, pair.given - pair.camera);
  }
  return out;
}

/// Whether the motion given of one leads to where the other one was.
Votes asPlace(const Region& one, const RegionPairs& pairs, const Region& other, const FlowSeen& seen) {
  Votes out;
  const auto index = [&](const Region& region) {
    return static_cast<RegionIndex>(&region - seen.regions.data());
  };
  for (std::size_t i = 1; i < seen.pairs.size(); ++i) {
    const FlowPair &now = seen.pairs[i], &before = seen.pairs[i - 1];
    const auto pair = pairs.find(now.frame);
    const auto own = now.middles.find(index(one)), others = before.middles.find(index(other));
    if (now.frame != before.frame + 1 || pair == pairs.end() || own == now.middles.end() ||
        others == before.middles.end())
      continue;
    out.add(own->second - others->second, pair->second.given);
  }
  return out;
}

bool areCamerasKnown(const FlowSeen& seen) {
  return std::ranges::all_of(seen.pairs, [](const FlowPair& pair) {
    return std::ranges::all_of(pair.squares,
                               [](const FlowSquare& square) { return square.camera.has_value(); });
  });
}

} // namespace

std::vector<OfOtherObject> ofOtherObjects(const std::vector<Refuted>& refuted, const FlowSeen& seen) {
  const std::map<const Region*, RegionPairs> pairs = byRegion(seen);
  std::vector<OfOtherObject> out;
  for (const Refuted& one : refuted) {
    const auto own = pairs.find(one.region);
    if (!one.region || one.region->objectId == 0 || own == pairs.end()) continue;
    std::optional<OfOtherObject> best;
    for (const Region& other : seen.regions) {
      if (&other == one.region || other.objectId == 0) continue;
      const auto others = pairs.find(&other);
      const auto keep = [&](Votes votes, OtherObjectKind kind) {
        if (!votes.isSo()) return;
        const double px = median(std::move(votes.off));
        if (!best || px < best->px) best = {one.region, &other, kind, votes.won, votes.asked, px};
      };
      // Without cameras the motion of what rests is that of nothing else.
      const bool isOwnMotion =
          areCamerasKnown(seen) || std::ranges::count(refuted, &other, &Refuted::region) > 0;
      if (others != pairs.end() && isOwnMotion)
        keep(asMotion(own->second, others->second), OtherObjectKind::Motion);
      keep(asPlace(*one.region, own->second, other, seen), OtherObjectKind::Place);
    }
    if (best) out.push_back(*best);
  }
  return out;
}

} // namespace taa::doctor
