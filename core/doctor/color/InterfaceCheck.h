// Whether an interface lies in the pictures: parts that rest on the screen, whatever is behind them, drawn
// with the jitter or without.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/color/ScreenTiles.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa::doctor {

/// Connected squares of the picture that rest on the screen in the same way.
struct ScreenGroup {
  bool isJittered = false;
  std::vector<int> tiles; ///< indices, row by row
  TileSums sums;
};

struct ScreenGroups {
  std::vector<ScreenGroup> clear;
  std::size_t unclear = 0; ///< squares of groups that rest but for the jitter, and not clearly
};

/// Those that are no objects of their own, nor the sky. Rather none than a wrong one: all edges have to stay
/// where they are in nearly all pairs of frames, and to contradict motion clearly. Where the world rests as
/// well, other edges that rest have to show that there is jitter in the pictures.
ScreenGroups interfaceGroups(const ScreenTiles& tiles);

/// Pixels that are no evidence of anything behind them, row by row: those of the groups and a square
/// around; empty where there are no groups.
std::vector<std::uint8_t> coveredPixels(const std::vector<ScreenGroup>& groups, const ScreenTiles& tiles);

/// Adds a finding for each of the two kinds of interface that there are.
void tellInterface(const ScreenGroups& groups, const ScreenTiles& tiles, Diagnosis& out);

/// Adds what is right or not decided. `isFound`: an interface was told of. `isJitterOpen`: which jitter the
/// pictures have is not known.
void tellInterfaceLeft(const ScreenGroups& groups, const ScreenTiles& tiles, bool isFound, bool isJitterOpen,
                       Diagnosis& out);

} // namespace taa::doctor
