#include "core/doctor/flow/Refuted.h"

#include <algorithm>
#include <map>
#include <set>

namespace taa::doctor {

namespace {

/// Of a region: where pictures say so little, that may be what shines, or a shadow, on something plain.
constexpr double kLeastSaid = 0.3;
constexpr std::size_t kEnoughSquaresOfPair = 3, kEnoughRefutedPairs = 2;
/// One pair alone has to say more.
constexpr std::size_t kEnoughSquaresOfOnePair = 12;

struct PairOfRegion {
  int frame = 0;
  std::vector<const FlowSquare*> squares;
  std::size_t refuting = 0;
};

std::map<RegionIndex, std::vector<PairOfRegion>> byRegion(const FlowSeen& seen, double tolerancePx) {
  std::map<RegionIndex, std::vector<PairOfRegion>> out;
  for (const FlowPair& pair : seen.pairs) {
    std::map<RegionIndex, PairOfRegion> ofPair;
    for (const FlowSquare& square : pair.squares) {
      if (pair.said.at(square.region) < kLeastSaid) continue;
      PairOfRegion& part = ofPair[square.region];
      part.frame = pair.frame;
      part.squares.push_back(&square);
      if (square.refutesGiven(tolerancePx)) ++part.refuting;
    }
    for (auto& [region, part] : ofPair) out[region].push_back(std::move(part));
  }
  return out;
}

} // namespace

std::vector<Refuted> refutedRegions(const FlowSeen& seen, double tolerancePx) {
  std::vector<Refuted> out;
  for (const auto& [region, pairs] : byRegion(seen, tolerancePx)) {
    Refuted refuted{&seen.regions[static_cast<std::size_t>(region)], {}, {}, {}, {}};
    std::size_t refuting = 0;
    for (const PairOfRegion& pair : pairs) {
      refuted.ofAll.insert(refuted.ofAll.end(), pair.squares.begin(), pair.squares.end());
      if (pair.squares.size() < kEnoughSquaresOfPair) continue;
      refuted.asked.push_back(pair.frame);
      if (static_cast<double>(pair.refuting) < kMostSquares * static_cast<double>(pair.squares.size()))
        continue;
      refuted.frames.push_back(pair.frame);
      refuting += pair.refuting;
      refuted.squares.insert(refuted.squares.end(), pair.squares.begin(), pair.squares.end());
    }
    const bool isEnough = refuted.frames.size() >= kEnoughRefutedPairs ? refuting >= kEnoughRefutingSquares
                                                                       : refuting >= kEnoughSquaresOfOnePair;
    if (isEnough) out.push_back(std::move(refuted));
  }
  return out;
}

Refuted wholePicture(const FlowSeen& seen) {
  Refuted out;
  for (const FlowPair& pair : seen.pairs) {
    if (pair.squares.empty()) continue;
    out.frames.push_back(pair.frame);
    for (const FlowSquare& square : pair.squares) out.squares.push_back(&square);
  }
  out.asked = out.frames;
  out.ofAll = out.squares;
  return out;
}

Refuted wholeFrames(const FlowSeen& seen, double tolerancePx) {
  constexpr std::size_t kEnoughOfFrame = 24;
  constexpr double kNearlyAll = 0.8;
  Refuted out;
  for (const FlowPair& pair : seen.pairs) {
    if (pair.squares.size() < kEnoughOfFrame) continue;
    out.asked.push_back(pair.frame);
    const auto off = std::ranges::count_if(pair.squares, [&](const FlowSquare& square) {
      return square.offPx() > std::max(tolerancePx, kChanceErrors * square.errorPx);
    });
    if (static_cast<double>(off) < kNearlyAll * static_cast<double>(pair.squares.size())) continue;
    out.frames.push_back(pair.frame);
    for (const FlowSquare& square : pair.squares) out.squares.push_back(&square);
  }
  out.ofAll = out.squares;
  if (2 * out.frames.size() > out.asked.size()) return {};
  return out;
}

int frameOf(const FlowSquare& square, const FlowSeen& seen) {
  const auto pair = std::ranges::find_if(seen.pairs, [&](const FlowPair& one) {
    const FlowSquare* first = one.squares.data();
    return &square >= first && &square < first + one.squares.size();
  });
  return pair == seen.pairs.end() ? 0 : pair->frame;
}

std::vector<const FlowSquare*> squaresOf(const std::vector<Refuted>& refuted) {
  std::vector<const FlowSquare*> out;
  for (const Refuted& one : refuted) out.insert(out.end(), one.squares.begin(), one.squares.end());
  return out;
}

std::pair<std::vector<int>, std::vector<int>> framesOf(const std::vector<Refuted>& refuted) {
  std::set<int> frames, asked;
  for (const Refuted& one : refuted) {
    frames.insert(one.frames.begin(), one.frames.end());
    asked.insert(one.asked.begin(), one.asked.end());
  }
  return {{frames.begin(), frames.end()}, {asked.begin(), asked.end()}};
}

} // namespace taa::doctor
