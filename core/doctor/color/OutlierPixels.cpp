#include "core/doctor/color/OutlierPixels.h"

#include "core/base/Say.h"
#include "core/doctor/frames/Connected.h"
#include "core/doctor/motion/MotionFindings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>

namespace taa::doctor {

namespace {

/// Of light that is compared, 0 to 1: less is noise, and what is read between pixels. That no scene of this
/// program has kEnoughPlaces, under three cameras, is asked by DoctorScenes.OfThisProgramAreHealthy.
constexpr float kOutlierLuma = 0.03f;
/// px around a place: jitter moves what is seen by a pixel at most, and what goes on by another motion in the
/// frame after is not found to a pixel.
constexpr int kReachPx = 2;
/// In which the place in the frame after is looked for, each from where the last one has led.
constexpr int kSteps = 3;
/// Length over width. Light that is compared is that of 3×3 pixels: a line that is thinner than a pixel and
/// seen in one frame alone is long and three pixels wide; what moves by itself need not be.
constexpr int kLongestOfWide = 3;
constexpr std::size_t kEnoughPlaces = 8; ///< of a region …
constexpr std::size_t kEnoughFrames = 3; ///< … and frames with some …
/// … of all that were asked: thin posts blink while a camera stops.
constexpr double kEnoughFramesOf = 1.0 / 3.0;
constexpr std::size_t kMostOutlierNamed = 4; ///< regions

enum class Outlier : std::uint8_t { None, Brighter, Darker };

/// Against all that is around a place, if the pixel there is not like it.
Outlier outlierFrom(const Image& luma, const glm::vec2& place, float value) {
  const glm::ivec2 at(glm::floor(place));
  if (std::abs(*luma.nearest(at.x, at.y) - value) <= kOutlierLuma) return Outlier::None;
  float low = *luma.nearest(at.x, at.y), high = low;
  for (int y = at.y - kReachPx; y <= at.y + kReachPx; ++y)
    for (int x = at.x - kReachPx; x <= at.x + kReachPx; ++x) {
      low = std::min(low, *luma.nearest(x, y));
      high = std::max(high, *luma.nearest(x, y));
    }
  if (value > high + kOutlierLuma) return Outlier::Brighter;
  return value < low - kOutlierLuma ? Outlier::Darker : Outlier::None;
}

/// One frame and those beside it.
class OutlierFrame {
 public:
  OutlierFrame(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels)
      : frames_(frames), labels_(labels), sizePx_(frames.now.sizePx()),
        outliers_(labels.size(), Outlier::None), taken_(labels.size(), 0) {
    for (int y = 0; y < sizePx_.y; ++y)
      for (int x = 0; x < sizePx_.x; ++x) outliers_[indexOf({x, y})] = outlierOf({x, y});
  }

  void addTo(std::map<RegionIndex, OutlierPlaces>& regions) {
    for (int y = 0; y < sizePx_.y; ++y)
      for (int x = 0; x < sizePx_.x; ++x)
        if (const Outlier kind = outliers_[indexOf({x, y})]; kind != Outlier::None)
          addPlace({x, y}, kind, regions);
  }

 private:
  std::size_t indexOf(const glm::ivec2& pixel) const {
    return static_cast<std::size_t>(pixel.y) * sizePx_.x + pixel.x;
  }
  /// By the motion of the frame after where that is another one, as where a camera stops.
  glm::vec2 placeAfter(const glm::ivec2& pixel, const glm::vec2& motionPx) const {
    const DoctorFrame& after = *frames_.after;
    const glm::vec2 place = glm::vec2(pixel) + 0.5f + after.jitterPx - frames_.now.jitterPx;
    glm::vec2 found = place + motionPx;
    for (int step = 0; step < kSteps && isInPicture(found, sizePx_) && !after.motionPx.empty(); ++step) {
      const glm::ivec2 at(glm::floor(found));
      const glm::vec2 next = after.motionAt(at.x, at.y);
      if (isMotion(next)) found = place + next;
    }
    return found;
  }

  Outlier outlierOf(const glm::ivec2& pixel) const {
    const glm::vec2 motion = frames_.now.motionAt(pixel.x, pixel.y);
    if (labels_[indexOf(pixel)] == kNoRegion || !isMotion(motion) || isMasked(frames_.now, pixel))
      return Outlier::None;
    const glm::vec2 before = glm::vec2(pixel) + 0.5f - motion + frames_.jitterStep(),
                    after = placeAfter(pixel, motion);
    if (!isInPicture(before, sizePx_) || !isInPicture(after, sizePx_)) return Outlier::None;
    const float luma = *frames_.now.luma.at(pixel.x, pixel.y);
    const Outlier kind = outlierFrom(frames_.before.luma, before, luma);
    if (kind == Outlier::None || outlierFrom(frames_.after->luma, after, luma) != kind) return Outlier::None;
    return wasHidden(frames_, pixel, glm::ivec2(before)) ? Outlier::None : kind;
  }

  /// Whether four pixels in a square from this one on are such, and all around them are of one region.
  bool isWideInside(const glm::ivec2& pixel, Outlier kind) const {
    const glm::ivec2 beyond = sizePx_ - kReachPx;
    if (pixel.x < kReachPx || pixel.y < kReachPx || pixel.x >= beyond.x || pixel.y >= beyond.y) return false;
    for (const glm::ivec2& step : {glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)})
      if (outliers_[indexOf(pixel + step)] != kind) return false;
    for (int y = -kReachPx; y <= kReachPx; ++y)
      for (int x = -kReachPx; x <= kReachPx; ++x)
        if (labels_[indexOf(pixel + glm::ivec2(x, y))] != labels_[indexOf(pixel)]) return false;
    return true;
  }

  void addPlace(const glm::ivec2& start, Outlier kind, std::map<RegionIndex, OutlierPlaces>& regions) {
    if (taken_[indexOf(start)] != 0) return;
    const auto isOfKind = [&](const glm::ivec2& pixel) { return outliers_[indexOf(pixel)] == kind; };
    const std::vector<glm::ivec2> pixels = takeConnected(start, sizePx_, isOfKind, taken_);
    const glm::ivec4 box = boxAround(pixels);
    const int width = box.z - box.x, height = box.w - box.y;
    if (std::max(width, height) > kLongestOfWide * std::min(width, height)) return;
    const auto wide =
        std::ranges::find_if(pixels, [&](const glm::ivec2& pixel) { return isWideInside(pixel, kind); });
    if (wide == pixels.end()) return;
    OutlierPlaces& region = regions[labels_[indexOf(*wide)]];
    ++region.places;
    if (region.frames.empty() || region.frames.back() != frames_.now.frame)
      region.frames.push_back(frames_.now.frame);
    if (pixels.size() <= region.most) return;
    region.most = pixels.size();
    region.frame = frames_.now.frame;
    region.pixel = *wide;
  }

  const FrameNeighbors& frames_;
  const std::vector<RegionIndex>& labels_;
  glm::ivec2 sizePx_;
  std::vector<Outlier> outliers_;
  std::vector<std::uint8_t> taken_; ///< 1: it was added
};

/// Whether a finding is of it, by its name, or of all there is.
bool isTold(const RegionPlace& place, const Diagnosis& out) {
  return std::ranges::any_of(out.findings, [&](const Finding& finding) {
    return finding.isWholePicture || std::ranges::any_of(finding.regions, [&](const RegionPlace& told) {
             return told.isWholeFrame || told.name == place.name;
           });
  });
}

} // namespace

void OutlierPixels::add(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels) {
  if (!frames.after || frames.after->startsHistory || frames.now.motionPx.empty()) return;
  ++asked_;
  OutlierFrame(frames, labels).addTo(regions_);
}

void tellOutlier(const OutlierPixels& outlier, const std::vector<Region>& regions,
                 const CaptureInfo& captureInfo, Diagnosis& out) {
  std::string names;
  std::size_t places = 0, named = 0;
  std::set<int> withPlaces;
  const OutlierPlaces* largest = nullptr;
  for (const auto& [index, found] : outlier.regions()) {
    const RegionPlace place = placeOf(regions[static_cast<std::size_t>(index)], captureInfo, 1.0);
    const std::size_t frames = found.frames.size();
    if (found.places < kEnoughPlaces || frames < kEnoughFrames ||
        static_cast<double>(frames) < kEnoughFramesOf * outlier.asked() || isTold(place, out))
      continue;
    places += found.places;
    withPlaces.insert(found.frames.begin(), found.frames.end());
    if (++named <= kMostOutlierNamed) names += (names.empty() ? "" : ", ") + place.name;
    if (!largest || found.most > largest->most) largest = &found;
  }
  if (!largest) return;
  if (named > kMostOutlierNamed) names = say<"%1 and %2 more">(names, named - kMostOutlierNamed);
  out.parts.leaveOpen(
      {say<"Motion">(),
       say<"at %1 places on %2, in %3 of %4 frames, something shows that motion leads to neither from the "
           "frame before nor to the frame after, the largest in frame %5 at %6, %7">(
           places, names, withPlaces.size(), outlier.asked(), captureInfo.frameNames.of(largest->frame),
           largest->pixel.x, largest->pixel.y),
       say<"Particles do that, limbs, pictures that move over a surface, shadows and lights that move: let them "
           "write motion of their own, or give the resolve a mask of them.">(),
       {},
       true});
}

} // namespace taa::doctor
