#include "core/doctor/color/CoplanarFlips.h"

#include "core/base/Say.h"
#include "core/doctor/Outline.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace taa::doctor {

namespace {

using ObjectPair = std::pair<std::uint32_t, std::uint32_t>;

/// Of the distance: surfaces farther apart hide each other, whatever the jitter.
constexpr float kSameDistance = 5e-4f;
constexpr int kFlipReach = 2;             ///< px: flips are an area where so many around a pixel flip, too:
constexpr int kLeastFlipsAround = 12;     ///< of 25; a row and its neighbor have 10
constexpr int kEnoughFlippedPairs = 3;    ///< of frames
constexpr std::size_t kEnoughFlips = 100; ///< pixels of all of them
constexpr double kBothWays = 0.1;         ///< least share of either direction

/// What a pixel shows where it showed another object in the frame before.
struct Flip {
  std::uint32_t now = 0, before = 0; ///< the same: there is none

  ObjectPair objects() const { return {std::min(now, before), std::max(now, before)}; }
  bool isNone() const { return now == before; }
};

/// By how much the distance changes from a pixel to the next on its own surface: beside a silhouette, on the
/// other side of the pixel.
float slopeAt(const Image& depthView, int x, int y) {
  const float middle = *depthView.at(x, y);
  const auto less = [&](int u, int v) {
    return std::min(std::abs(*depthView.at(x + u, y + v) - middle),
                    std::abs(*depthView.at(x - u, y - v) - middle));
  };
  return less(1, 0) + less(0, 1);
}

Flip flipAt(const FrameNeighbors& frames, int x, int y) {
  const DoctorFrame &now = frames.now, &before = frames.before;
  const glm::ivec2 size = now.sizePx();
  const glm::vec2 motionPx = now.motionAt(x, y);
  if (!isMotion(motionPx)) return {};
  const glm::ivec2 place(glm::floor(glm::vec2(x, y) + 0.5f - motionPx + frames.jitterStep()));
  if (place.x < 1 || place.y < 1 || place.x + 1 >= size.x || place.y + 1 >= size.y) return {};
  const Flip flip{now.objectId[static_cast<std::size_t>(y) * size.x + x],
                  before.objectId[static_cast<std::size_t>(place.y) * size.x + place.x]};
  const float expected = *now.previousDepthView.at(x, y), seen = *before.depthView.at(place.x, place.y);
  if (flip.isNone() || flip.now == 0 || flip.before == 0 || !(expected > 0.0f) || !(seen > 0.0f)) return {};
  const float reach = kSameDistance * expected + slopeAt(before.depthView, place.x, place.y);
  return std::abs(expected - seen) <= reach ? flip : Flip{};
}

/// Flips of a pair of frames, and which of them are areas.
class FlipMap {
 public:
  explicit FlipMap(const FrameNeighbors& frames) : size_(frames.now.sizePx()) {
    flips_.resize(static_cast<std::size_t>(size_.x) * size_.y);
    for (int y = 1; y + 1 < size_.y; ++y)
      for (int x = 1; x + 1 < size_.x; ++x) flips_[index(x, y)] = flipAt(frames, x, y);
  }

  /// Calls `tell` with each pixel in an area, and its flip.
  template <typename Tell>
  void forAreas(Tell tell) const {
    for (int y = kFlipReach; y + kFlipReach < size_.y; ++y)
      for (int x = kFlipReach; x + kFlipReach < size_.x; ++x) {
        const Flip& flip = flips_[index(x, y)];
        if (!flip.isNone() && countAround(x, y, flip.objects()) >= kLeastFlipsAround)
          tell(glm::ivec2(x, y), flip);
      }
  }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * size_.x + x; }
  int countAround(int x, int y, const ObjectPair& objects) const {
    int count = 0;
    for (int v = y - kFlipReach; v <= y + kFlipReach; ++v)
      for (int u = x - kFlipReach; u <= x + kFlipReach; ++u) {
        const Flip& flip = flips_[index(u, v)];
        if (!flip.isNone() && flip.objects() == objects) ++count;
      }
    return count;
  }

  glm::ivec2 size_;
  std::vector<Flip> flips_;
};

/// Areas of one frame and one pair of objects.
struct FlippedArea {
  std::size_t toFirst = 0, toSecond = 0;
  glm::ivec4 box{0};
  std::vector<glm::ivec2> pixels;

  void add(const glm::ivec2& at, bool isToFirst) {
    const bool isNew = toFirst + toSecond == 0;
    ++(isToFirst ? toFirst : toSecond);
    box = isNew ? glm::ivec4(at, at + 1)
                : glm::ivec4(glm::min(glm::ivec2(box), at), glm::max(glm::ivec2(box.z, box.w), at + 1));
    pixels.push_back(at);
  }
};

std::string objectText(std::uint32_t object, const CaptureInfo& captureInfo) {
  const auto name = captureInfo.objectNames.find(object);
  return name == captureInfo.objectNames.end() ? say<"object %1">(object)
                                               : say<"object %1 (%2)">(object, name->second);
}

} // namespace

bool FlippedPair::isFighting() const {
  const std::size_t all = toFirst + toSecond;
  return pairs >= kEnoughFlippedPairs && all >= kEnoughFlips &&
         static_cast<double>(std::min(toFirst, toSecond)) >= kBothWays * static_cast<double>(all);
}

void CoplanarEvidence::add(const FrameNeighbors& frames) {
  const DoctorFrame& now = frames.now;
  pixels += static_cast<double>(now.sizePx().x) * now.sizePx().y;
  if (now.objectId.empty() || now.motionPx.empty() || now.depthView.empty()) return;
  std::map<ObjectPair, FlippedArea> areas;
  FlipMap(frames).forAreas(
      [&](const glm::ivec2& at, const Flip& flip) { areas[flip.objects()].add(at, flip.now < flip.before); });
  for (const auto& [key, area] : areas) {
    FlippedPair& out = objects[key];
    ++out.pairs;
    out.toFirst += area.toFirst;
    out.toSecond += area.toSecond;
    if (area.toFirst + area.toSecond <= out.most) continue;
    out.most = area.toFirst + area.toSecond;
    out.place.frame = now.frame;
    out.place.box = area.box;
    out.place.pixel = area.pixels.back();
    out.place.pixels = runsOf(area.pixels);
  }
}

void tellCoplanar(const CoplanarEvidence& evidence, const CaptureInfo& captureInfo, Diagnosis& out) {
  Finding found;
  std::size_t flips = 0;
  int pairs = 0;
  for (const auto& [key, flipped] : evidence.objects) {
    if (!flipped.isFighting()) continue;
    RegionPlace place = flipped.place;
    place.name = say<"%1 and %2">(objectText(key.first, captureInfo), objectText(key.second, captureInfo));
    place.share = static_cast<double>(flipped.toFirst + flipped.toSecond) / std::max(1.0, evidence.pixels);
    flips += flipped.toFirst + flipped.toSecond;
    pairs = std::max(pairs, flipped.pairs);
    found.regions.push_back(std::move(place));
  }
  if (found.regions.empty()) return;
  found.id = "zFighting";
  found.name = say<"Two surfaces in one place">();
  found.reason =
      say<"In %1 pairs of frames %2 pixels, in areas, show one of two objects and showed the other one "
          "a frame before, at the same distance.">(pairs, flips);
  found.symptom =
      say<"Stripes or speckles of two surfaces shimmer with the jitter, in a still picture, too.">();
  found.change =
      say<"Move one of the two surfaces, or draw only one of them; or give one an offset of depth. A "
          "nearer far plane, or reversed depth of floats, helps where they lie apart.">();
  out.findings.push_back(std::move(found));
}

} // namespace taa::doctor
