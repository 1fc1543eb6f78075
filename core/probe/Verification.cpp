#include "core/probe/Verification.h"

#include "core/base/Median.h"
#include "core/base/Parallel.h"
#include "core/taa/twin/Known.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <deque>
#include <utility>

namespace taa {

namespace {

using Rows = std::bitset<kIntermediateCount>;
using Compared = twin::Observation::Compared;
using Decision = twin::Observation::Decision;

/// One path through the resolve: how its comparisons went.
struct Path {
  std::vector<Decision> decisions;
  std::vector<Compared> values;
  std::size_t outside = 0;
};

Path pathOf(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
            const PixelRecord& found, const Rows& rows, std::vector<bool> script) {
  const twin::Observation observation(found, rows, std::move(script));
  twin::resolvePixelIn<twin::Interval>(inputs, settings, pixel);
  Path path{observation.decisions(), observation.compared(), 0};
  path.outside = static_cast<std::size_t>(
      std::ranges::count_if(path.values, [](const Compared& each) { return !each.isInside(); }));
  return path;
}

/// The same decisions up to the one at `place`, and there the other.
std::vector<bool> otherScript(const Path& path, std::size_t place) {
  std::vector<bool> script;
  for (std::size_t i = 0; i <= place; ++i) script.push_back(path.decisions[i].is != (i == place));
  return script;
}

/// So often a pixel is resolved at most, in search of a path that gives its values; verify counts what is
/// left open by that.
constexpr std::size_t kMaxPaths = 96;

std::size_t indexOf(IntermediateId id) {
  return static_cast<std::size_t>(id);
}

void add(const Compared& value, const glm::ivec2& pixel, bool isOpen, VerifiedValues& row) {
  ++row.sums.values;
  const bool isEqual =
      std::bit_cast<std::uint32_t>(value.found) == std::bit_cast<std::uint32_t>(value.allowed.value) ||
      (std::isnan(value.found) && std::isnan(value.allowed.value));
  if (isEqual) ++row.sums.equal;
  if (!value.isInside()) {
    ++(isOpen ? row.sums.open : row.sums.outside);
    if (!isOpen && !row.sums.example)
      row.sums.example = OutsideValue{pixel, value.channel, value.found, value.allowed};
  }
  const float twins = value.allowed.value, low = value.allowed.low, high = value.allowed.high;
  if (!std::isfinite(low) || !std::isfinite(high)) {
    if (value.allowed.isAnything()) ++row.sums.anything;
    return;
  }
  const float width = high - low;
  if (width == 0.0f)
    ++row.points;
  else
    row.widths.push_back(width);
  row.squares += static_cast<double>(twins) * static_cast<double>(twins);
  if (width <= row.widest) return;
  row.widest = width;
  row.sums.widestAt = pixel;
}

void join(VerifiedValues& all, const VerifiedValues& part) {
  all.sums.addCounts(part.sums);
  all.points += part.points;
  if (!all.sums.example) all.sums.example = part.sums.example;
  all.widths.insert(all.widths.end(), part.widths.begin(), part.widths.end());
  all.squares += part.squares;
  if (part.widest <= all.widest) return;
  all.widest = part.widest;
  all.sums.widestAt = part.sums.widestAt;
}

RowVerification measured(const VerifiedValues& row) {
  RowVerification out = row.sums;
  if (row.widths.empty()) return out;
  const std::size_t count = row.points + row.widths.size(), middle = count / 2;
  const double unit = twin::unitInLastPlace(std::sqrt(row.squares / static_cast<double>(count)));
  std::vector<float> widths = row.widths;
  if (middle >= row.points)
    out.medianUlp = static_cast<double>(valueOfRank(widths, middle - row.points)) / unit;
  out.widestUlp = static_cast<double>(row.widest) / unit;
  return out;
}

/// Line `y` of the picture, `line` of the part.
VerifiedTable lineOf(const twin::Inputs& inputs, const Settings& settings,
                     std::span<const IntermediateId> ids, std::span<const Image> images, const Rows& rows,
                     int y, int line) {
  VerifiedTable table;
  PixelRecord found{};
  for (int x = 0; x < inputs.outputWidth(); ++x) {
    for (std::size_t i = 0; i < ids.size(); ++i) found[indexOf(ids[i])] = images[i].texel(x, line);
    const auto [values, isOpen] = verifyPixel(inputs, settings, {x, y}, found, rows);
    for (const Compared& value : values) add(value, {x, y}, isOpen, table[indexOf(value.id)]);
  }
  return table;
}

} // namespace

void RowVerification::addCounts(const RowVerification& other) {
  values += other.values;
  equal += other.equal;
  outside += other.outside;
  anything += other.anything;
  open += other.open;
}

RowVerification Verification::all() const {
  RowVerification sum;
  for (const RowVerification& row : rows) {
    sum.addCounts(row);
    if (row.widestUlp < sum.widestUlp) continue;
    sum.widestUlp = row.widestUlp;
    sum.widestAt = row.widestAt;
  }
  return sum;
}

VerifiedPixel verifyPixel(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                          const PixelRecord& found, const Rows& rows) {
  Path best = pathOf(inputs, settings, pixel, found, rows, {});
  std::deque<std::vector<bool>> untried;
  // Only what was chosen before a value that is outside can have led there.
  const auto branch = [&untried](const Path& path, std::size_t fixed) {
    const auto outside = std::ranges::find_if(path.values, [](const Compared& v) { return !v.isInside(); });
    const auto reached = static_cast<std::size_t>(outside - path.values.begin());
    for (std::size_t place = path.decisions.size(); place-- > fixed;)
      if (path.decisions[place].before <= reached) untried.push_back(otherScript(path, place));
  };
  if (best.outside > 0) branch(best, 0);
  std::size_t tried = 1;
  for (; best.outside > 0 && !untried.empty() && tried < kMaxPaths; ++tried) {
    const std::vector<bool> script = std::move(untried.front());
    untried.pop_front();
    Path path = pathOf(inputs, settings, pixel, found, rows, script);
    if (path.outside > 0) branch(path, script.size());
    if (path.outside < best.outside) best = std::move(path);
  }
  return {std::move(best.values), best.outside > 0 && !untried.empty()};
}

void FrameVerifier::add(const twin::Inputs& inputs, const Settings& settings, int firstLine,
                        std::span<const IntermediateId> ids, std::span<const Image> rows) {
  assert(ids.size() == rows.size() && !rows.empty());
  Rows compared;
  for (const IntermediateId id : ids)
    if (!isOfHistory(id) || !inputs.historyColor.empty()) compared.set(indexOf(id));
  std::vector<VerifiedTable> lines(static_cast<std::size_t>(rows.front().height));
  parallelFor(rows.front().height, [&](int line) {
    lines[static_cast<std::size_t>(line)] =
        lineOf(inputs, settings, ids, rows, compared, firstLine + line, line);
  });
  for (const VerifiedTable& line : lines)
    for (std::size_t row = 0; row < line.size(); ++row) join(all_[row], line[row]);
}

Verification FrameVerifier::verification() const {
  Verification out;
  for (const Intermediate& row : kResolveRows) {
    const VerifiedValues& values = all_[indexOf(row.id)];
    if (values.sums.values == 0) continue;
    out.rows.push_back(measured(values));
    out.rows.back().id = row.id;
  }
  return out;
}

} // namespace taa
