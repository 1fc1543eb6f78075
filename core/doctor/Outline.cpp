#include "core/doctor/Outline.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

namespace taa::doctor {

namespace {

/// Where a row changes from outside to inside and back, by rising x.
using RowEnds = std::vector<int>;

std::map<int, RowEnds> endsOfRows(const std::vector<PixelRun>& runs) {
  std::map<int, RowEnds> rows;
  for (const PixelRun& run : runs) {
    RowEnds& row = rows[run.y];
    if (!row.empty() && row.back() == run.from)
      row.back() = run.to;
    else
      row.insert(row.end(), {run.from, run.to});
  }
  return rows;
}

/// Between two rows an edge runs wherever one of them is inside and the other is not.
void addHorizontal(int y, const RowEnds& above, const RowEnds& below, std::vector<OutlineEdge>& out) {
  RowEnds ends;
  std::ranges::set_symmetric_difference(above, below, std::back_inserter(ends));
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) out.push_back({{ends[i], y}, {ends[i + 1], y}});
}

/// Goes on the edges that end at y, by their x; others begin there.
void addVertical(int y, const RowEnds& row, std::map<int, std::size_t>& open, std::vector<OutlineEdge>& out) {
  std::map<int, std::size_t> going;
  for (const int x : row) {
    const auto before = open.find(x);
    if (before == open.end()) out.push_back({{x, y}, {x, y}});
    const std::size_t edge = before == open.end() ? out.size() - 1 : before->second;
    out[edge].to.y = y + 1;
    going.emplace(x, edge);
  }
  open = std::move(going);
}

} // namespace

std::vector<PixelRun> runsOf(std::vector<glm::ivec2> pixels) {
  std::ranges::sort(
      pixels, [](const glm::ivec2& a, const glm::ivec2& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  std::vector<PixelRun> out;
  for (const glm::ivec2& pixel : pixels)
    if (!out.empty() && out.back().y == pixel.y && pixel.x <= out.back().to)
      out.back().to = pixel.x + 1;
    else
      out.push_back({pixel.y, pixel.x, pixel.x + 1});
  return out;
}

std::vector<OutlineEdge> outlineOf(const std::vector<PixelRun>& runs) {
  std::vector<OutlineEdge> out;
  std::map<int, std::size_t> open; ///< vertical edges that end where the row before does
  RowEnds before;
  int next = 0; // below the row before
  for (const auto& [y, row] : endsOfRows(runs)) {
    if (!before.empty() && y != next) {
      addHorizontal(next, before, {}, out);
      before.clear();
      open.clear();
    }
    addHorizontal(y, before, row, out);
    addVertical(y, row, open, out);
    before = row;
    next = y + 1;
  }
  addHorizontal(next, before, {}, out);
  return out;
}

} // namespace taa::doctor
