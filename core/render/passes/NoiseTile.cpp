#include "core/render/passes/NoiseTile.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace taa {

namespace {

constexpr int kCells = kNoiseTileSize * kNoiseTileSize;

/// How crowded each cell is: a fixed-point bell around every point, so that sums do not depend on their
/// order.
class Crowding {
 public:
  Crowding() : bell_(kCells) {
    for (int cell = 0; cell < kCells; ++cell) {
      const auto along = [](int step) { return std::min(step, kNoiseTileSize - step); };
      const int x = along(cell % kNoiseTileSize), y = along(cell / kNoiseTileSize);
      bell_[static_cast<std::size_t>(cell)] = power(x * x + y * y);
    }
  }

  void add(int point) { change(point, 1); }
  void remove(int point) { change(point, -1); }
  /// The cell among those with `isPoint` that is most (or least) crowded; the first of equals.
  int fullest(const std::vector<bool>& points) const { return extreme(points, true, 1); }
  int emptiest(const std::vector<bool>& points) const { return extreme(points, false, -1); }

 private:
  /// 2³⁰·exp(−d²/2σ²) with σ = 1.5 cells, by repeated multiplication: the same on every machine.
  static std::int64_t power(int squaredDistance) {
    double value = 1 << 30;
    for (int i = 0; i < squaredDistance; ++i) value *= 0.8007374029168081; // exp(−1/4.5)
    return static_cast<std::int64_t>(value);
  }

  void change(int point, int sign) {
    const int px = point % kNoiseTileSize, py = point / kNoiseTileSize;
    for (int cell = 0; cell < kCells; ++cell) {
      const int dx = (cell - px) & (kNoiseTileSize - 1); // px is below the width, which is a power of two
      const int dy = (cell / kNoiseTileSize - py) & (kNoiseTileSize - 1);
      sums_[static_cast<std::size_t>(cell)] +=
          sign * bell_[static_cast<std::size_t>(dy * kNoiseTileSize + dx)];
    }
  }

  int extreme(const std::vector<bool>& points, bool wanted, int sign) const {
    int best = -1;
    for (int cell = 0; cell < kCells; ++cell) {
      if (points[static_cast<std::size_t>(cell)] != wanted) continue;
      if (best < 0 ||
          sign * sums_[static_cast<std::size_t>(cell)] > sign * sums_[static_cast<std::size_t>(best)])
        best = cell;
    }
    return best;
  }

  std::vector<std::int64_t> bell_;
  std::vector<std::int64_t> sums_ = std::vector<std::int64_t>(kCells);
};

struct Pattern {
  std::vector<bool> points = std::vector<bool>(kCells);
  Crowding crowding;
  int count = 0;

  void set(int cell, bool isPoint) {
    points[static_cast<std::size_t>(cell)] = isPoint;
    isPoint ? crowding.add(cell) : crowding.remove(cell);
    count += isPoint ? 1 : -1;
  }
};

/// A tenth of the cells, moved from clusters into voids until the last one moved goes back to where it was.
Pattern evenPattern() {
  Pattern pattern;
  std::uint32_t random = 1;
  while (pattern.count < kCells / 10) {
    random = random * 1664525u + 1013904223u;
    const int cell = static_cast<int>(random >> 22u); // 10 bits
    if (!pattern.points[static_cast<std::size_t>(cell)]) pattern.set(cell, true);
  }
  for (;;) {
    const int cluster = pattern.crowding.fullest(pattern.points);
    pattern.set(cluster, false);
    const int empty = pattern.crowding.emptiest(pattern.points);
    pattern.set(empty, true);
    if (empty == cluster) return pattern;
  }
}

} // namespace

Image blueNoiseTile() {
  const Pattern start = evenPattern();
  Image tile(kNoiseTileSize, kNoiseTileSize, 1);
  const auto rank = [&tile](int cell, int number) {
    tile.pixels[static_cast<std::size_t>(cell)] = (static_cast<float>(number) + 0.5f) / kCells;
  };
  // Ranks below the start: taken away where they crowd most. Above: put where there is most room.
  for (Pattern fewer = start; fewer.count > 0;) {
    const int cell = fewer.crowding.fullest(fewer.points);
    fewer.set(cell, false);
    rank(cell, fewer.count);
  }
  for (Pattern more = start; more.count < kCells;) {
    const int cell = more.crowding.emptiest(more.points);
    rank(cell, more.count);
    more.set(cell, true);
  }
  return tile;
}

} // namespace taa
