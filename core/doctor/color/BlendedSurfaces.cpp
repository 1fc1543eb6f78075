#include "core/doctor/color/BlendedSurfaces.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/Outline.h"
#include "core/doctor/frames/Connected.h"
#include "core/doctor/frames/Detail.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionEvidence.h"
#include "core/doctor/motion/MotionSearch.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

constexpr float kBlended = 0.1f; ///< of the mask: something is blended in; and a step at a silhouette
constexpr std::size_t kLeastSilhouette = 24; ///< pixels
constexpr int kShapeReachPx = 12;
// px: shapes are known to a pixel; what is seen through them better.
constexpr float kElsewherePx = 1.0f, kOtherwisePx = 0.5f;
/// Of the mask in the mean: what the motion given leaves at silhouettes where it does not fit.
constexpr double kShapeMissed = 0.05, kShapeFactor = 2.0;
constexpr double kRestingObjectShare =
    0.8; ///< of an object's pixels that nothing covers: it rests in the world
constexpr double kBehindFactor = 1.5, kBehindLuma = 0.004;
constexpr std::size_t kEnoughBehind = 150;
constexpr int kEnoughBlendedPairs = 3;
constexpr double kBlendedPairsWon = 0.7;

Image shapesOf(const Image& mask) {
  Image out(mask.width, mask.height, 1);
  for (std::size_t i = 0; i < out.pixels.size(); ++i)
    out.pixels[i] = mask.pixels[i * static_cast<std::size_t>(mask.channels)];
  return out;
}

bool isInPictureAt(const glm::vec2& place, const glm::ivec2& sizePx) {
  return place.x >= 0.5f && place.y >= 0.5f && place.x <= static_cast<float>(sizePx.x) - 0.5f &&
         place.y <= static_cast<float>(sizePx.y) - 0.5f; // NaN is not
}

/// Connected pixels in which something is blended.
using Shape = std::vector<glm::ivec2>;

std::vector<Shape> shapesIn(const Image& shapes) {
  std::vector<std::uint8_t> taken(shapes.pixels.size(), 0);
  const auto isBlendedAt = [&](const glm::ivec2& at) { return *shapes.at(at.x, at.y) >= kBlended; };
  std::vector<Shape> out;
  for (int y = 0; y < shapes.height; ++y)
    for (int x = 0; x < shapes.width; ++x) {
      if (taken[static_cast<std::size_t>(y) * shapes.width + x] != 0 || !isBlendedAt({x, y})) continue;
      Shape shape = takeConnected({x, y}, {shapes.width, shapes.height}, isBlendedAt, taken);
      if (shape.size() >= kLeastPart) out.push_back(std::move(shape));
    }
  return out;
}

void takePlace(BlendedTrial& out, const Shape& pixels, int frame) {
  if (pixels.size() <= out.most) return;
  out.most = pixels.size();
  out.place.frame = frame;
  out.place.pixel = pixels[pixels.size() / 2];
  out.place.pixels = runsOf(pixels);
  out.place.box = boxAround(pixels);
}

/// What both leave of a pair of frames.
struct BlendedSums {
  std::size_t pixels = 0;
  double given = 0.0, tried = 0.0;
  Shape shape;

  void addTo(BlendedTrial& out, int frame) const {
    if (pixels == 0) return;
    ++out.pairs;
    if (tried < given) ++out.won;
    out.pixels += pixels;
    out.given += given;
    out.tried += tried;
    takePlace(out, shape, frame);
  }
};

/// A pair of frames.
class BlendedPair {
 public:
  explicit BlendedPair(const FrameNeighbors& frames)
      : frames_(frames), jitterStep_(frames.jitterStep()), shapes_(shapesOf(frames.now.mask)),
        shapesBefore_(shapesOf(frames.before.mask)) {}

  void addTo(BlendedEvidence& out) const {
    BlendedSums moved;
    for (const Shape& shape : shapesIn(shapes_)) {
      out.blended += shape.size();
      addShape(shape, moved);
    }
    moved.addTo(out.shapes, frames_.now.frame);
    behind().addTo(out.behind, frames_.now.frame);
  }

 private:
  glm::vec2 givenAt(const glm::ivec2& pixel) const {
    const glm::vec2 given = frames_.now.motionAt(pixel.x, pixel.y);
    return isMotion(given) ? given : glm::vec2(0.0f);
  }
  glm::vec2 placeOf(const glm::ivec2& pixel, const glm::vec2& motionPx) const {
    return glm::vec2(pixel) + 0.5f - motionPx + jitterStep_;
  }

  bool isSilhouette(const glm::ivec2& at) const {
    if (at.x < 1 || at.y < 1 || at.x + 1 >= shapes_.width || at.y + 1 >= shapes_.height) return false;
    const float own = *shapes_.at(at.x, at.y);
    return std::abs(own - *shapes_.at(at.x + 1, at.y)) >= kBlended ||
           std::abs(own - *shapes_.at(at.x - 1, at.y)) >= kBlended ||
           std::abs(own - *shapes_.at(at.x, at.y + 1)) >= kBlended ||
           std::abs(own - *shapes_.at(at.x, at.y - 1)) >= kBlended;
  }

  /// A shape whose silhouette its motion does not lead to, and another one does.
  void addShape(const Shape& shape, BlendedSums& out) const {
    std::vector<SearchedPixel> silhouette;
    glm::vec2 givenPx(0.0f);
    double given = 0.0;
    for (const glm::ivec2& pixel : shape) {
      if (!isSilhouette(pixel)) continue;
      const glm::vec2 motionPx = givenAt(pixel);
      const float own = *shapes_.at(pixel.x, pixel.y);
      silhouette.push_back({placeOf(pixel, glm::vec2(0.0f)), own});
      given += static_cast<double>(
          std::abs(own - capture::betweenPixels(shapesBefore_, placeOf(pixel, motionPx))));
      givenPx += motionPx;
    }
    const auto count = static_cast<double>(silhouette.size());
    if (silhouette.size() < kLeastSilhouette || given < kShapeMissed * count) return;
    givenPx /= static_cast<float>(silhouette.size());
    const auto found = searchMotion(silhouette, shapesBefore_, givenPx, kShapeReachPx);
    if (!found || glm::distance(*found, givenPx) < kElsewherePx) return;
    double tried = 0.0;
    for (const SearchedPixel& pixel : silhouette)
      tried += static_cast<double>(
          std::abs(pixel.luma - capture::betweenPixels(shapesBefore_, pixel.place - *found)));
    if (given < kShapeFactor * tried) return;
    out.pixels += silhouette.size();
    out.given += given;
    out.tried += tried;
    out.shape.insert(out.shape.end(), shape.begin(), shape.end());
  }

  bool isOfCamera(const glm::ivec2& pixel) const {
    const auto camera = cameraMotionPx(frames_.now, pixel);
    return camera && isSameMotion(frames_.now.motionAt(pixel.x, pixel.y), *camera);
  }

  /// Objects that rest in the world where nothing is blended over them.
  std::vector<std::uint32_t> restingObjects() const {
    std::map<std::uint32_t, std::pair<std::size_t, std::size_t>> counts; // all; those of the camera
    for (int y = 0; y < shapes_.height; ++y)
      for (int x = 0; x < shapes_.width; ++x) {
        if (*shapes_.at(x, y) > 0.0f) continue;
        auto& [all, resting] = counts[frames_.now.objectId[static_cast<std::size_t>(y) * shapes_.width + x]];
        ++all;
        if (isOfCamera({x, y})) ++resting;
      }
    std::vector<std::uint32_t> out;
    for (const auto& [object, count] : counts)
      if (count.first >= kLeastPart &&
          static_cast<double>(count.second) >= kRestingObjectShare * static_cast<double>(count.first))
        out.push_back(object);
    return out;
  }

  /// What is seen through something blended over objects that rest.
  BlendedSums behind() const {
    BlendedSums out;
    if (frames_.now.objectId.empty() || !frames_.now.previousClipFromClip) return out;
    const std::vector<std::uint32_t> resting = restingObjects();
    for (int y = 0; y < shapes_.height; ++y)
      for (int x = 0; x < shapes_.width; ++x) {
        if (!(*shapes_.at(x, y) >= kBlended) || !hasDetail(frames_.now.luma, x, y)) continue;
        const std::uint32_t object = frames_.now.objectId[static_cast<std::size_t>(y) * shapes_.width + x];
        if (std::ranges::find(resting, object) != resting.end()) addBehind({x, y}, out);
      }
    return out;
  }

  void addBehind(const glm::ivec2& pixel, BlendedSums& out) const {
    const glm::vec2 given = givenAt(pixel);
    const auto camera = cameraMotionPx(frames_.now, pixel);
    if (!camera || glm::distance(given, *camera) < kOtherwisePx) return;
    const glm::vec2 givenPlace = placeOf(pixel, given), place = placeOf(pixel, *camera);
    const glm::ivec2 size = frames_.now.sizePx();
    if (!isInPictureAt(givenPlace, size) || !isInPictureAt(place, size)) return;
    // Where nothing was blended in a frame ago the picture has changed, whatever moved.
    if (!(capture::betweenPixels(shapesBefore_, place) >= kBlended)) return;
    const float luma = *frames_.now.luma.at(pixel.x, pixel.y);
    ++out.pixels;
    out.given +=
        static_cast<double>(std::abs(luma - capture::betweenPixels(frames_.before.luma, givenPlace)));
    out.tried += static_cast<double>(std::abs(luma - capture::betweenPixels(frames_.before.luma, place)));
    out.shape.push_back(pixel);
  }

  const FrameNeighbors& frames_;
  glm::vec2 jitterStep_;
  Image shapes_, shapesBefore_; ///< the mask's first channel
};

bool isBlendedWon(const BlendedTrial& trial) {
  return trial.pairs >= kEnoughBlendedPairs && trial.won >= kBlendedPairsWon * trial.pairs;
}

bool isBehindSeen(const BlendedTrial& trial) {
  return isBlendedWon(trial) && trial.pixels >= kEnoughBehind && trial.given >= kBehindFactor * trial.tried &&
         trial.given - trial.tried >= kBehindLuma * static_cast<double>(trial.pixels);
}

Finding blendedFinding(Fault fault, const BlendedTrial& trial, double allPixels, const std::string& tried) {
  Finding out = faultFinding(fault);
  RegionPlace place = trial.place;
  place.name = say<"what is blended at %1, %2">(place.pixel.x, place.pixel.y);
  place.share = static_cast<double>(trial.pixels) / std::max(1.0, allPixels);
  out.regions = {std::move(place)};
  out.residuals = {{"tried", tried, 1000.0 * trial.share(trial.tried), false, true},
                   {"asGiven", say<"as given">(), 1000.0 * trial.share(trial.given), true, false}};
  return out;
}

Finding unmovedShapes(const BlendedEvidence& evidence) {
  const BlendedTrial& trial = evidence.shapes;
  Finding out =
      blendedFinding(Fault::TransparentsWithoutMotion, trial, evidence.pixels, say<"found by search">());
  out.reason =
      say<"In %1 pairs of frames shapes in the mask, %2 pixels of their rims, are not where their motion "
          "leads; another motion leaves %3 % of that.">(
          trial.pairs, trial.pixels, std::lround(100.0 * trial.tried / std::max(1e-9, trial.given)));
  out.measure = say<"mean difference of the mask at rims, × 1000">();
  out.change =
      say<"Let it write motion where it covers most of what is behind; and give the resolve the mask, so "
          "that it keeps less history there.">();
  return out;
}

Finding overwrittenMotion(const BlendedEvidence& evidence) {
  const BlendedTrial& trial = evidence.behind;
  Finding out = blendedFinding(Fault::TransparentsOverwriteMotion, trial, evidence.pixels,
                               say<"that of what is behind">());
  out.reason =
      say<"At %1 pixels of %2 pairs of frames something is blended over what rests, and what is seen moves "
          "as that does: the motion given leaves %3 times as much.">(
          trial.pixels, trial.pairs, shortNumber(trial.given / std::max(1e-9, trial.tried)));
  out.measure = say<"mean difference of luma, × 1000">();
  out.change = say<"Let what is mostly transparent write no motion, and give the resolve a mask of it.">();
  return out;
}

} // namespace

void BlendedEvidence::add(const FrameNeighbors& frames) {
  if (frames.now.mask.empty() || frames.before.mask.empty()) return;
  isMaskKnown = true;
  pixels += static_cast<double>(frames.now.sizePx().x) * frames.now.sizePx().y;
  if (!frames.now.motionPx.empty()) BlendedPair(frames).addTo(*this);
}

void tellBlended(const BlendedEvidence& evidence, bool isMaskUsed, Diagnosis& out) {
  const bool isOverwritten = isBehindSeen(evidence.behind);
  // Several that lie over each other are one shape of no one motion.
  const bool isUnmoved = !isOverwritten && isBlendedWon(evidence.shapes);
  if (isOverwritten) out.findings.push_back(overwrittenMotion(evidence));
  if (isUnmoved && isMaskUsed)
    out.notes.push_back(
        say<"What is blended in has no motion of its own: the mask, which the resolve gets, stands "
            "for it.">());
  else if (isUnmoved)
    out.findings.push_back(unmovedShapes(evidence));
  const std::vector<Fault> faults{Fault::TransparentsWithoutMotion, Fault::TransparentsOverwriteMotion};
  if (!evidence.isMaskKnown)
    out.parts.leaveOpen({say<"Transparent surfaces">(),
                         say<"nothing says where something is blended over surfaces">(),
                         say<"Capture the reactive mask, too.">(), faults});
  else if (evidence.blended > 0 && !isOverwritten && !isUnmoved)
    out.parts.leaveOpen({say<"Transparent surfaces">(),
                         say<"what is blended in moves too little, or by no one motion">(),
                         say<"Let it, or the camera, move by some pixels a frame.">(), faults});
}

} // namespace taa::doctor
