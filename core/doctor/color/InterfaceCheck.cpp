#include "core/doctor/color/InterfaceCheck.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/Outline.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

constexpr int kEnoughTilePairs = 4;
constexpr double kNearlyAllTilePairs = 0.9, kMostTilePairs = 0.8;
/// What motion leaves of edges that rest on the screen: times what is left in place, and luma in the mean.
constexpr double kMovingFactor = 3.0, kMovingLuma = 0.004;
/// Between pixels edges are read less well: what is left but for jitter, as a share of all else.
constexpr double kJitteredShare = 0.8;
/// Of a group; and the share of its edges that may be silhouettes of what is behind it. A ball that a camera
/// goes around looks the same from all sides: its silhouette and its shading rest, and its surface moves.
constexpr double kClearlyJittered = 0.67, kEdgesAtSilhouettes = 0.3;
constexpr std::size_t kLeastFixed = 4, kLeastJittered = 12; ///< squares of a group
/// px a frame in the mean: the world moves.
constexpr double kWorldMovesPx = 0.5;
/// Of the edges that rest on the screen where the world rests, too: so many others have to shift with the
/// jitter.
constexpr double kShiftingShare = 0.3;
constexpr double kRestsPx = 0.05;
/// Or jitter as stated leaves so much less in so many squares, and not in far fewer than those in which none
/// does; where it is the other way, and by so much, pictures have none.
constexpr double kSeenShare = 0.8;
constexpr std::size_t kEnoughSeen = 12, kSeenFactor = 2, kUnseenFactor = 4;
/// Of what the motion given leaves as stated: so much remains without jitter.
constexpr double kMovingWithoutJitter = 0.5;
constexpr int kEnoughKnown = 12; ///< squares
/// A group of so much of one region, which it covers so much of, is that object or the sky.
constexpr double kOfOneRegion = 0.7, kMostOfRegion = 0.5;
constexpr std::size_t kEnoughFitting = 4; ///< squares of a region whose motion is right
constexpr double kOpenShare = 0.5; ///< of squares with edges: so many have to move for a jittered one to show

enum class TileKind : std::uint8_t { Other, Fixed, Jittered };

glm::ivec2 tileAt(const ScreenTiles& tiles, int index) {
  return {index % tiles.counts.x, index / tiles.counts.x};
}

glm::ivec4 boxOf(const ScreenTiles& tiles, int index) {
  const glm::ivec2 first = kTilePx * tileAt(tiles, index);
  return {first, glm::min(first + kTilePx, tiles.sizePx)};
}

/// Calls `tell` with the index of each pixel of a square.
template <typename Tell>
void forPixelsOf(const ScreenTiles& tiles, int index, Tell tell) {
  const glm::ivec4 box = boxOf(tiles, index);
  for (int y = box.y; y < box.w; ++y)
    for (int x = box.x; x < box.z; ++x) tell(static_cast<std::size_t>(y) * tiles.sizePx.x + x);
}

bool isFixed(const ScreenTile& tile) {
  return tile.pairs >= kEnoughTilePairs && tile.fixed >= kNearlyAllTilePairs * tile.pairs &&
         tile.sums.moving() >= kMovingFactor * tile.sums.inPlace &&
         tile.sums.moving() >= kMovingLuma * static_cast<double>(tile.sums.pixels);
}

/// `isGivenRight`: the motion given is known to be right, whatever depth and matrices make of it.
bool isJittered(const ScreenTile& tile, bool isGivenRight) {
  const int won = isGivenRight ? tile.jittered : tile.jitteredOfAll;
  const double moving = isGivenRight ? tile.sums.asGiven : tile.sums.moving();
  return tile.pairs >= kEnoughTilePairs && won >= kMostTilePairs * tile.pairs &&
         tile.sums.jittered <= kJitteredShare * std::min(tile.sums.inPlace, moving);
}

/// The region of the middle of a square.
RegionIndex regionOf(const ScreenTiles& tiles, int index) {
  const glm::ivec4 box = boxOf(tiles, index);
  return tiles.labels[static_cast<std::size_t>((box.y + box.w) / 2) * tiles.sizePx.x + (box.x + box.z) / 2];
}

/// Regions whose motion as given fits in most squares that move and do not rest on the screen.
std::set<RegionIndex> rightRegions(const ScreenTiles& tiles) {
  std::map<RegionIndex, std::pair<std::size_t, std::size_t>> counts; // that move; that fit
  for (int i = 0; i < static_cast<int>(tiles.tiles.size()); ++i) {
    const ScreenTile& tile = tiles.tiles[static_cast<std::size_t>(i)];
    if (tile.pairs < kEnoughTilePairs || tile.meanPx() < kWorldMovesPx || isJittered(tile, true)) continue;
    auto& [moving, fitting] = counts[regionOf(tiles, i)];
    ++moving;
    if (tile.sums.asGiven < std::min(tile.sums.inPlace, tile.sums.jittered)) ++fitting;
  }
  std::set<RegionIndex> out;
  for (const auto& [region, count] : counts)
    if (count.second >= kEnoughFitting && 2 * count.second >= count.first) out.insert(region);
  return out;
}

bool isFixedBeforeWorld(const ScreenTile& tile) {
  return isFixed(tile) && tile.meanWorldPx() >= kWorldMovesPx;
}

/// Whether edges that rest in the world shift nevertheless, beside those that rest on the screen.
bool areRestingShifting(const ScreenTiles& tiles) {
  std::size_t resting = 0, shifting = 0;
  for (const ScreenTile& tile : tiles.tiles) {
    if (tile.pairs < kEnoughTilePairs || tile.fittingPx() > kRestsPx) continue;
    if (isFixed(tile)) ++resting;
    if (tile.changing >= kMostTilePairs * tile.pairs) ++shifting;
  }
  return static_cast<double>(shifting) >= kShiftingShare * static_cast<double>(resting);
}

enum class StatedJitter : std::uint8_t { Unknown, Seen, Missing };

/// Whether the jitter that is stated is in what does not rest on the screen.
StatedJitter statedJitter(const ScreenTiles& tiles) {
  std::size_t with = 0, without = 0;
  for (const ScreenTile& tile : tiles.tiles) {
    if (tile.pairs < kEnoughTilePairs || isFixed(tile)) continue;
    if (tile.sums.moving() <= kSeenShare * tile.sums.movingUnjittered()) ++with;
    if (tile.sums.movingUnjittered() <= kSeenShare * tile.sums.moving()) ++without;
  }
  if (with >= kEnoughSeen && kSeenFactor * with >= without) return StatedJitter::Seen;
  return without >= kEnoughSeen && without >= kUnseenFactor * with ? StatedJitter::Missing
                                                                   : StatedJitter::Unknown;
}

/// Where pictures have no jitter, what moves as given but for it seems to rest beside what is given.
bool isFixedUnjittered(const ScreenTile& tile) {
  return isFixedBeforeWorld(tile) && tile.sums.unjittered >= kMovingWithoutJitter * tile.sums.asGiven;
}

std::vector<TileKind> tileKinds(const ScreenTiles& tiles) {
  // One that rests while the world moves is an interface without jitter: then others are likely.
  const bool isKnown = std::ranges::count_if(tiles.tiles, isFixedBeforeWorld) >= kEnoughKnown;
  const StatedJitter stated = statedJitter(tiles);
  const bool isMissing = stated == StatedJitter::Missing && !isKnown;
  const bool isShifting =
      isKnown || stated == StatedJitter::Seen || (!isMissing && areRestingShifting(tiles));
  const std::set<RegionIndex> right = rightRegions(tiles);
  std::vector<TileKind> out;
  for (int i = 0; i < static_cast<int>(tiles.tiles.size()); ++i) {
    const ScreenTile& tile = tiles.tiles[static_cast<std::size_t>(i)];
    if (isShifting ? isFixed(tile) : isMissing ? isFixedUnjittered(tile) : isFixedBeforeWorld(tile))
      out.push_back(TileKind::Fixed);
    else if (isJittered(tile, right.contains(regionOf(tiles, i))))
      out.push_back(TileKind::Jittered);
    else
      out.push_back(TileKind::Other);
  }
  return out;
}

/// Calls `tell` with the index of each square around one, itself included.
template <typename Tell>
void forTilesAround(const ScreenTiles& tiles, int index, Tell tell) {
  const glm::ivec2 middle = tileAt(tiles, index);
  for (int y = std::max(0, middle.y - 1); y <= std::min(tiles.counts.y - 1, middle.y + 1); ++y)
    for (int x = std::max(0, middle.x - 1); x <= std::min(tiles.counts.x - 1, middle.x + 1); ++x)
      tell(y * tiles.counts.x + x);
}

/// Takes the squares of its kind that hang together with `start` out of `kinds`.
ScreenGroup takeGroup(const ScreenTiles& tiles, int start, std::vector<TileKind>& kinds) {
  const TileKind kind = kinds[static_cast<std::size_t>(start)];
  ScreenGroup out{kind == TileKind::Jittered, {start}, {}};
  kinds[static_cast<std::size_t>(start)] = TileKind::Other;
  for (std::size_t next = 0; next < out.tiles.size(); ++next) {
    out.sums.add(tiles.tiles[static_cast<std::size_t>(out.tiles[next])].sums);
    forTilesAround(tiles, out.tiles[next], [&](int beside) {
      TileKind& other = kinds[static_cast<std::size_t>(beside)];
      if (other != kind) return;
      other = TileKind::Other;
      out.tiles.push_back(beside);
    });
  }
  std::ranges::sort(out.tiles);
  return out;
}

/// Whether a group is an object, or the sky where that rests: others say what is wrong with those.
bool isOwnRegion(const ScreenGroup& group, const ScreenTiles& tiles) {
  std::map<RegionIndex, std::size_t> inGroup;
  std::size_t pixels = 0;
  for (const int tile : group.tiles)
    forPixelsOf(tiles, tile, [&](std::size_t pixel) {
      ++inGroup[tiles.labels[pixel]];
      ++pixels;
    });
  const auto [region, count] =
      *std::ranges::max_element(inGroup, {}, [](const auto& one) { return one.second; });
  // A sky without jitter moves with the camera.
  const double movesPx = group.sums.worldPx / static_cast<double>(group.sums.pixels);
  if (region == kNoRegion || (region == tiles.sky && movesPx >= kWorldMovesPx)) return false;
  const auto inPicture = std::ranges::count(tiles.labels, region);
  return static_cast<double>(count) >= kOfOneRegion * static_cast<double>(pixels) &&
         static_cast<double>(count) >= kMostOfRegion * static_cast<double>(inPicture);
}

RegionPlace groupPlace(const ScreenGroup& group, const ScreenTiles& tiles) {
  RegionPlace out;
  out.frame = tiles.frame;
  out.box = boxOf(tiles, group.tiles.front());
  std::vector<glm::ivec2> pixels;
  for (const int tile : group.tiles) {
    const glm::ivec4 box = boxOf(tiles, tile);
    out.box = {glm::min(out.box.x, box.x), glm::min(out.box.y, box.y), glm::max(out.box.z, box.z),
               glm::max(out.box.w, box.w)};
    forPixelsOf(tiles, tile, [&](std::size_t pixel) {
      const int index = static_cast<int>(pixel);
      pixels.emplace_back(index % tiles.sizePx.x, index / tiles.sizePx.x);
    });
  }
  const glm::ivec4 middle = boxOf(tiles, group.tiles[group.tiles.size() / 2]);
  out.pixel = {(middle.x + middle.z) / 2, (middle.y + middle.w) / 2};
  out.name =
      say<"%1 × %2 pixels at %3, %4">(out.box.z - out.box.x, out.box.w - out.box.y, out.box.x, out.box.y);
  out.share = static_cast<double>(pixels.size()) / (static_cast<double>(tiles.sizePx.x) * tiles.sizePx.y);
  out.pixels = runsOf(std::move(pixels));
  return out;
}

std::vector<Residual> screenResiduals(const TileSums& sums, bool isJittered) {
  const auto left = [&](double sum) { return 1000.0 * sum / static_cast<double>(sums.pixels); };
  std::vector<Residual> out = {
      {"inPlace", say<"at rest on the screen, without jitter">(), left(sums.inPlace), false, !isJittered},
      {"jittered", say<"at rest on the screen, with jitter">(), left(sums.jittered), false, isJittered},
      {"asGiven", say<"as given">(), left(sums.asGiven), true, false},
      {"ofCamera", say<"that of the camera">(), left(sums.ofWorld), false, false}};
  std::ranges::stable_sort(out, {}, &Residual::value);
  return out;
}

void tellGroups(const std::vector<ScreenGroup>& groups, const ScreenTiles& tiles, bool isJittered,
                Diagnosis& out) {
  TileSums sums;
  std::size_t squares = 0;
  Finding found = faultFinding(isJittered ? Fault::InterfaceJittered : Fault::InterfaceBefore);
  for (const ScreenGroup& group : groups) {
    if (group.isJittered != isJittered) continue;
    sums.add(group.sums);
    squares += group.tiles.size();
    found.regions.push_back(groupPlace(group, tiles));
  }
  if (found.regions.empty()) return;
  std::ranges::stable_sort(found.regions, std::greater(), &RegionPlace::share);
  found.reason =
      isJittered
          ? say<"In %1 squares of %2 pixels all edges rest on the screen but for the jitter, "
                "while what is behind them moves by %3 px a frame in the mean.">(
                squares, kTilePx,
                shortNumber(std::max(sums.worldPx, sums.givenPx) / static_cast<double>(sums.pixels)))
          : say<"In %1 squares of %2 pixels all edges rest on the screen, to %3 thousandths "
                "of luma, and do not follow the jitter that is in all else.">(
                squares, kTilePx, shortNumber(1000.0 * sums.inPlace / static_cast<double>(sums.pixels)));
  found.measure = say<"mean difference of luma at edges, × 1000">();
  found.residuals = screenResiduals(sums, isJittered);
  found.change = isJittered
                     ? say<"Draw it after TAA, with the projection without jitter.">()
                     : say<"Draw it after TAA. Where it has to be in the picture, write 0 for its motion, "
                           "and mask it, so that the resolve keeps no history there.">();
  out.findings.push_back(std::move(found));
}

/// Whether a square rests on the screen but for the jitter while the world moves, and motion does not
/// contradict that.
bool isAlong(const ScreenTile& tile) {
  return tile.pairs >= kEnoughTilePairs && tile.meanWorldPx() >= kWorldMovesPx &&
         tile.sums.jittered <= kJitteredShare * std::min(tile.sums.inPlace, tile.sums.ofWorld) &&
         tile.sums.asGiven <= tile.sums.jittered / kClearlyJittered;
}

/// What motion says rests on the screen may be one, whether that motion is right or not.
void tellAlong(std::size_t squares, Diagnosis& out) {
  out.parts.leaveOpen(
      {say<"Interface in the pictures">(),
       say<"in %1 squares of %2 pixels edges rest on the screen but for the jitter while the world moves, "
           "and "
           "motion has it so: things that go along with the camera look the same">(squares, kTilePx),
       say<"Let the camera pass by what it goes along with, or capture without the interface.">(),
       {Fault::InterfaceJittered}});
}

/// Where nothing moves, what is drawn with the jitter looks like what rests.
void tellOpen(const ScreenTiles& tiles, Diagnosis& out) {
  std::size_t squares = 0, moving = 0;
  for (const ScreenTile& tile : tiles.tiles) {
    if (tile.pairs < kEnoughTilePairs) continue;
    ++squares;
    if (tile.fittingPx() >= kWorldMovesPx) ++moving;
  }
  if (squares > 0 && static_cast<double>(moving) >= kOpenShare * static_cast<double>(squares)) {
    out.parts.addRight(
        say<"Interface in the pictures">(),
        say<"No interface is in the pictures: nothing rests on the screen while all else moves.">());
    return;
  }
  std::vector<Fault> faults{Fault::InterfaceJittered};
  // Without jitter and motion nothing tells one from the other.
  if (tiles.jitteredPairs < kEnoughTilePairs) faults.push_back(Fault::InterfaceBefore);
  out.parts.leaveOpen(
      {say<"Interface in the pictures">(),
       say<"too little moves over the screen: what rests in the world and what is drawn over it "
           "look the same">(),
       say<"Let the camera turn by some pixels a frame.">(), std::move(faults)});
}

/// Edges that rest on the screen but for the jitter a little better than they move.
void tellUnclear(std::size_t squares, Diagnosis& out) {
  out.parts.leaveOpen({say<"Interface in the pictures">(),
                       say<"in %1 squares of %2 pixels edges fit rest on the screen better than the "
                           "motion given, and not clearly: "
                           "what looks the same from all sides does, too">(squares, kTilePx),
                       say<"Let the camera turn by some pixels a frame.">(),
                       {Fault::InterfaceJittered},
                       true});
}

/// What is drawn over the world with a jitter that is not known rests by none that is.
void tellUnknownJitter(Diagnosis& out) {
  out.parts.leaveOpen(
      {say<"Interface in the pictures">(),
       say<"pictures have another jitter than is stated, and it is open which: what rests on the screen but "
           "for that does not show">(),
       say<"State the jitter that pictures are drawn with.">(),
       {Fault::InterfaceJittered}});
}

/// Whether a group is one, and whether it clearly is. Where motion is wrong, what moves as the world does may
/// still rest better than it moves as given.
bool isEnough(const ScreenGroup& group) {
  if (group.isJittered && group.sums.ofWorld <= group.sums.jittered) return false;
  return group.tiles.size() >= (group.isJittered ? kLeastJittered : kLeastFixed);
}
bool isClear(const ScreenGroup& group) {
  if (!group.isJittered) return true;
  return group.sums.jittered <= kClearlyJittered * std::min(group.sums.inPlace, group.sums.asGiven) &&
         static_cast<double>(group.sums.atSilhouette) <=
             kEdgesAtSilhouettes * static_cast<double>(group.sums.pixels);
}

} // namespace

ScreenGroups interfaceGroups(const ScreenTiles& tiles) {
  std::vector<TileKind> kinds = tileKinds(tiles);
  ScreenGroups groups;
  std::vector<ScreenGroup>& out = groups.clear;
  std::vector<ScreenGroup> own;
  for (int i = 0; i < static_cast<int>(kinds.size()); ++i) {
    if (kinds[static_cast<std::size_t>(i)] == TileKind::Other) continue;
    ScreenGroup group = takeGroup(tiles, i, kinds);
    if (!isEnough(group)) continue;
    if (!isClear(group)) {
      groups.unclear += group.tiles.size();
      continue;
    }
    (isOwnRegion(group, tiles) ? own : out).push_back(std::move(group));
  }
  // Beside an interface, what hides an object or the sky is more of it.
  const std::size_t apart = out.size();
  for (ScreenGroup& group : own)
    if (std::any_of(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(apart),
                    [&](const ScreenGroup& other) { return other.isJittered == group.isJittered; }))
      out.push_back(std::move(group));
  return groups;
}

std::vector<std::uint8_t> coveredPixels(const std::vector<ScreenGroup>& groups, const ScreenTiles& tiles) {
  if (groups.empty()) return {};
  std::vector<std::uint8_t> out(static_cast<std::size_t>(tiles.sizePx.x) * tiles.sizePx.y, 0);
  for (const ScreenGroup& group : groups)
    for (const int tile : group.tiles)
      forTilesAround(tiles, tile, [&](int beside) {
        forPixelsOf(tiles, beside, [&](std::size_t pixel) { out[pixel] = 1; });
      });
  return out;
}

void tellInterface(const ScreenGroups& groups, const ScreenTiles& tiles, Diagnosis& out) {
  tellGroups(groups.clear, tiles, false, out);
  tellGroups(groups.clear, tiles, true, out);
}

void tellInterfaceLeft(const ScreenGroups& groups, const ScreenTiles& tiles, bool isFound, bool isJitterOpen,
                       Diagnosis& out) {
  if (groups.unclear > 0) {
    tellUnclear(groups.unclear, out);
    return;
  }
  if (isFound) return;
  if (isJitterOpen) {
    tellUnknownJitter(out);
    return;
  }
  const auto along = static_cast<std::size_t>(std::ranges::count_if(tiles.tiles, isAlong));
  if (along >= kLeastJittered) {
    tellAlong(along, out);
    return;
  }
  tellOpen(tiles, out);
}

} // namespace taa::doctor
