#include "core/doctor/frames/Regions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <numeric>
#include <set>
#include <utility>

namespace taa::doctor {

namespace {

// Neighbors farther apart than this are of two surfaces: share of the nearer one's distance, px.
constexpr float kDepthStep = 0.05f;
constexpr float kMotionStep = 1.0f;
/// A region is shown in the last frame in which it has this share of its largest size: what is wrong with it
/// is seen where there is a history.
constexpr double kAsLarge = 0.98;
/// A part is that of the frame before where it covers so much of the smaller one of both.
constexpr double kCoveredShare = 0.5;

/// Whether two neighbors are of one surface, as far as depth and motion tell.
bool goesOn(const DoctorFrame& frame, std::size_t a, std::size_t b) {
  if (frame.isSky(a) != frame.isSky(b)) return false;
  if (!frame.depthView.empty()) {
    const float nearer = std::min(frame.depthView.pixels[a], frame.depthView.pixels[b]);
    const float farther = std::max(frame.depthView.pixels[a], frame.depthView.pixels[b]);
    if (farther - nearer > kDepthStep * nearer) return false;
  }
  if (frame.motionPx.empty()) return true;
  const float* motion = frame.motionPx.pixels.data();
  // Marks of no previous position differ from any motion, and not from each other.
  return std::abs(motion[2 * a] - motion[2 * b]) <= kMotionStep &&
         std::abs(motion[2 * a + 1] - motion[2 * b + 1]) <= kMotionStep;
}

/// Union-find over pixels.
class PixelSets {
 public:
  explicit PixelSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::uint32_t(0));
  }
  std::uint32_t root(std::uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    const std::uint32_t rootA = root(static_cast<std::uint32_t>(a));
    const std::uint32_t rootB = root(static_cast<std::uint32_t>(b));
    parents_[std::max(rootA, rootB)] = std::min(rootA, rootB);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

/// For each pixel one that stands for its part.
std::vector<std::uint32_t> connectedParts(const DoctorFrame& frame) {
  const glm::ivec2 size = frame.sizePx();
  const std::size_t count = static_cast<std::size_t>(size.x) * size.y;
  PixelSets sets(count);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
      if (x > 0 && goesOn(frame, i, i - 1)) sets.join(i, i - 1);
      if (y > 0 && goesOn(frame, i, i - size.x)) sets.join(i, i - size.x);
    }
  std::vector<std::uint32_t> roots(count);
  for (std::size_t i = 0; i < count; ++i) roots[i] = sets.root(static_cast<std::uint32_t>(i));
  return roots;
}

/// A connected part and how much it covers of the regions of the frame before.
struct PartOfFrame {
  std::size_t size = 0;
  std::map<RegionIndex, std::size_t> covered;
  RegionIndex region = kNoRegion;
};

/// The region of the frame before that a part goes on; none where it covers too little of any.
RegionIndex formerRegion(const PartOfFrame& part, const std::map<RegionIndex, std::size_t>& formerSizes,
                         const std::set<RegionIndex>& taken) {
  RegionIndex best = kNoRegion;
  std::size_t most = 0;
  for (const auto& [region, count] : part.covered)
    if (count > most && !taken.contains(region)) {
      most = count;
      best = region;
    }
  if (best == kNoRegion) return best;
  const std::size_t smaller = std::min(part.size, formerSizes.at(best));
  return static_cast<double>(most) >= kCoveredShare * static_cast<double>(smaller) ? best : kNoRegion;
}

} // namespace

RegionIndex RegionTracker::add(const Region& region) {
  regions_.push_back(region);
  return static_cast<RegionIndex>(regions_.size()) - 1;
}

RegionIndex RegionTracker::ofId(std::uint32_t id) {
  const auto [at, isNew] = ofIds_.try_emplace(id, kNoRegion);
  if (isNew) {
    Region region;
    region.objectId = id;
    at->second = add(region);
  }
  return at->second;
}

RegionIndex RegionTracker::ofSky() {
  if (sky_ == kNoRegion) {
    Region region;
    region.isSky = true;
    sky_ = add(region);
  }
  return sky_;
}

// A part goes on the region of the frame before that it covers most of, the largest parts first.
void RegionTracker::labelConnected(const DoctorFrame& frame, std::vector<RegionIndex>& labels) {
  const std::vector<std::uint32_t> roots = connectedParts(frame);
  std::map<std::uint32_t, PartOfFrame> parts;
  std::map<RegionIndex, std::size_t> formerSizes;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const RegionIndex former = before_.size() == labels.size() ? before_[i] : kNoRegion;
    if (former != kNoRegion) ++formerSizes[former];
    if (frame.isSky(i)) continue;
    PartOfFrame& part = parts[roots[i]];
    ++part.size;
    if (former != kNoRegion && former != sky_) ++part.covered[former];
  }
  std::vector<PartOfFrame*> bySize;
  for (auto& [root, part] : parts)
    if (part.size >= kLeastPart) bySize.push_back(&part);
  std::ranges::stable_sort(bySize, std::greater(), [](const PartOfFrame* part) { return part->size; });
  std::set<RegionIndex> taken;
  for (PartOfFrame* part : bySize) {
    part->region = formerRegion(*part, formerSizes, taken);
    if (part->region == kNoRegion) part->region = add({});
    taken.insert(part->region);
  }
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (!frame.isSky(i)) labels[i] = parts[roots[i]].region;
}

std::vector<RegionIndex> RegionTracker::label(const DoctorFrame& frame) {
  const glm::ivec2 size = frame.sizePx();
  std::vector<RegionIndex> labels(static_cast<std::size_t>(size.x) * size.y, kNoRegion);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (frame.isSky(i))
      labels[i] = ofSky();
    else if (!frame.objectId.empty())
      labels[i] = ofId(frame.objectId[i]);
  if (frame.objectId.empty()) labelConnected(frame, labels);
  measure(frame, labels);
  before_ = labels;
  return labels;
}

void RegionTracker::measure(const DoctorFrame& frame, const std::vector<RegionIndex>& labels) {
  struct Seen {
    std::size_t size = 0;
    glm::ivec4 box{0};
    glm::ivec2 pixel{-1};
    std::vector<PixelRun> runs;
  };
  const glm::ivec2 size = frame.sizePx();
  std::map<RegionIndex, Seen> seen;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const RegionIndex label = labels[static_cast<std::size_t>(y) * size.x + x];
      if (label == kNoRegion) continue;
      Seen& part = seen[label];
      const glm::ivec4 own(x, y, x + 1, y + 1);
      part.box = part.size == 0 ? own
                                : glm::ivec4(std::min(part.box.x, x), std::min(part.box.y, y),
                                             std::max(part.box.z, x + 1), std::max(part.box.w, y + 1));
      ++part.size;
      if (!part.runs.empty() && part.runs.back().y == y && part.runs.back().to == x)
        ++part.runs.back().to;
      else
        part.runs.push_back({y, x, x + 1});
      if (part.pixel.x < 0 || isInside(labels, size, x, y)) part.pixel = {x, y};
    }
  for (auto& [label, part] : seen) {
    Region& region = regions_[static_cast<std::size_t>(label)];
    ++region.frames;
    region.pixels += static_cast<double>(part.size);
    if (static_cast<double>(part.size) < kAsLarge * static_cast<double>(region.size)) continue;
    region.frame = frame.frame;
    region.size = std::max(region.size, part.size);
    region.box = part.box;
    region.pixel = part.pixel;
    region.runs = std::move(part.runs);
  }
}

bool isInside(const std::vector<RegionIndex>& labels, const glm::ivec2& sizePx, int x, int y) {
  if (x < 1 || y < 1 || x + 1 >= sizePx.x || y + 1 >= sizePx.y) return false;
  const RegionIndex* at = labels.data() + static_cast<std::size_t>(y) * sizePx.x + x;
  const std::ptrdiff_t row = sizePx.x;
  return std::ranges::all_of(
      std::initializer_list<std::ptrdiff_t>{-row - 1, -row, -row + 1, -1, 1, row - 1, row, row + 1},
      [&](std::ptrdiff_t step) { return at[step] == at[0]; });
}

bool isWide(const std::vector<RegionIndex>& labels, const glm::ivec2& sizePx, int x, int y) {
  const auto at = [&](int column, int row) {
    const bool isIn = column >= 0 && row >= 0 && column < sizePx.x && row < sizePx.y;
    return isIn ? labels[static_cast<std::size_t>(row) * sizePx.x + column] : kNoRegion;
  };
  const RegionIndex label = at(x, y);
  for (const int dx : {-1, 1})
    for (const int dy : {-1, 1})
      if (at(x + dx, y) == label && at(x, y + dy) == label && at(x + dx, y + dy) == label) return true;
  return false;
}

std::optional<std::array<std::size_t, 4>> pixelsAround(const glm::vec2& place, const glm::ivec2& sizePx) {
  // A comparison with NaN fails.
  const glm::vec2 center = place - 0.5f;
  if (!(center.x >= 0.0f && center.y >= 0.0f && center.x < static_cast<float>(sizePx.x - 1) &&
        center.y < static_cast<float>(sizePx.y - 1)))
    return {};
  const std::size_t row = static_cast<std::size_t>(sizePx.x);
  const std::size_t first = static_cast<std::size_t>(center.y) * row + static_cast<std::size_t>(center.x);
  return std::array{first, first + 1, first + row, first + row + 1};
}

std::vector<RegionIndex> insideOf(const std::vector<RegionIndex>& labels, const glm::ivec2& sizePx) {
  std::vector<RegionIndex> out(labels.size(), kNoRegion);
  for (int y = 1; y + 1 < sizePx.y; ++y)
    for (int x = 1; x + 1 < sizePx.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * sizePx.x + x;
      if (isInside(labels, sizePx, x, y)) out[i] = labels[i];
    }
  return out;
}

} // namespace taa::doctor
