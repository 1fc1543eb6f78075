#include "core/doctor/resolve/ResolvePixels.h"

#include "core/doctor/frames/Detail.h"
#include "core/taa/twin/BlendStages.h"
#include "core/taa/twin/SampleStages.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::doctor {

namespace {

constexpr float kMostDistance = 0.05f;
constexpr float kSilhouetteMotionPx =
    0.1f; ///< motions of the nearest and the farthest of nine differ by more
constexpr float kLeastBlended = 0.05f;
/// Places that are looked at for the pixels of a set: silhouettes are few.
constexpr std::size_t kMostTries = 12000, kMostTriesOfSilhouettes = 60000;

bool isPlain(const DoctorFrame& frame, const glm::ivec2& pixel) {
  for (int y = pixel.y - 1; y <= pixel.y + 1; ++y)
    for (int x = pixel.x - 1; x <= pixel.x + 1; ++x)
      for (int channel = 0; channel < 3; ++channel)
        if (!std::isfinite(frame.color.at(x, y)[channel])) return false;
  for (int channel = 0; channel < 3; ++channel)
    if (!std::isfinite(frame.output.at(pixel.x, pixel.y)[channel])) return false;
  if (frame.mask.empty()) return true;
  const float* mask = frame.mask.at(pixel.x, pixel.y);
  return mask[0] < kLeastBlended && mask[1] < kLeastBlended;
}

bool leavesPicture(const DoctorFrame& frame, const glm::ivec2& pixel) {
  const glm::vec2 motion = frame.motionAt(pixel.x, pixel.y);
  if (!isMotion(motion)) return false;
  const glm::vec2 place = glm::vec2(pixel) + 0.5f - motion, size(frame.sizePx());
  constexpr float kClearlyPx = 1.0f; // whichever of the motions around is taken
  return place.x < -kClearlyPx || place.y < -kClearlyPx || place.x > size.x + kClearlyPx ||
         place.y > size.y + kClearlyPx;
}

/// Whether the nearest and the farthest of nine lead to different places.
bool isAtSilhouette(const DoctorFrame& frame, const glm::ivec2& pixel) {
  if (frame.depth.empty()) return false;
  glm::ivec2 nearest = pixel, farthest = pixel;
  for (int y = pixel.y - 1; y <= pixel.y + 1; ++y)
    for (int x = pixel.x - 1; x <= pixel.x + 1; ++x) {
      if (*frame.depth.at(x, y) > *frame.depth.at(nearest.x, nearest.y)) nearest = {x, y};
      if (*frame.depth.at(x, y) < *frame.depth.at(farthest.x, farthest.y)) farthest = {x, y};
    }
  const glm::vec2 near = frame.motionAt(nearest.x, nearest.y), far = frame.motionAt(farthest.x, farthest.y);
  if (!isMotion(near) || !isMotion(far)) return false;
  return std::hypot(near.x - far.x, near.y - far.y) >= kSilhouetteMotionPx;
}

bool isOfSet(const DoctorFrame& frame, PixelSet set, const glm::ivec2& pixel) {
  switch (set) {
  case PixelSet::Anywhere:
    return hasDetail(frame.luma, pixel.x, pixel.y) && !leavesPicture(frame, pixel) &&
           isMotion(frame.motionAt(pixel.x, pixel.y));
  case PixelSet::Silhouettes:
    return isAtSilhouette(frame, pixel);
  case PixelSet::Border:
    return leavesPicture(frame, pixel);
  }
  return false;
}

twin::Texels nothing(const glm::ivec2& sizePx, int channels) {
  return {sizePx.x, sizePx.y, channels,
          [channels](int, int, int width, int height) { return Image(width, height, channels); }};
}

twin::Texels orNothing(const Image& plane, const glm::ivec2& sizePx, int channels) {
  return plane.empty() ? nothing(sizePx, channels) : twin::Texels(plane);
}

Image negated(Image plane) {
  for (float& value : plane.pixels)
    if (std::abs(value) < kNoPreviousPosition) value = -value;
  return plane;
}

/// Of a frame, without its history.
twin::Inputs twinInputs(const DoctorFrame& frame) {
  const glm::ivec2 size = frame.sizePx();
  twin::Inputs out;
  out.color = frame.color;
  out.depth = orNothing(frame.depth, size, 1);
  out.motion = frame.motionPx;
  out.normal = nothing(size, 4);
  out.objectId = nothing(size, 1);
  out.previousDepth = orNothing(frame.previousDepthView, size, 1);
  out.frame = frame.frame;
  out.jitterPx = frame.jitterPx;
  out.depthTerms = frame.depthTerms;
  return out;
}

/// What a lane keeps of the surfaces of a frame, made where it is read.
template <typename Value>
twin::Texels keptOf(const twin::Inputs& inputs, const DilateSettings& dilate, Value value) {
  constexpr int kKeptTile = 4;
  return {inputs.width(), inputs.height(), 2,
          [&inputs, dilate, value](int left, int top, int width, int height) {
            Image out(width, height, 2);
            for (int y = 0; y < height; ++y)
              for (int x = 0; x < width; ++x) {
                const glm::vec2 kept = value(twin::dilateMotion(inputs, dilate, {left + x, top + y}));
                out.at(x, y)[0] = kept.x;
                out.at(x, y)[1] = kept.y;
              }
            return out;
          },
          kKeptTile};
}

/// Distances of one pixel, by its own α and by those tried.
ModelDistances distancesAt(const ResolveModel& model, const twin::PixelRecord& record,
                           const glm::vec3& output, const glm::ivec2& pixel, int frame) {
  const auto color = [&](IntermediateId id) { return glm::vec3(twin::at(record, id)); };
  ModelDistances out{};
  out[0] = colorDistance(color(IntermediateId::resolved), output);
  twin::BlendInputs mix;
  mix.current = color(IntermediateId::currentFiltered);
  mix.history = color(IntermediateId::historyRectified);
  mix.historyLength = twin::at(record, IntermediateId::historyKeptLength).x;
  mix.pixel = pixel;
  mix.frame = frame;
  const float invalid = twin::at(record, IntermediateId::alphaInvalid).x;
  for (std::size_t i = 0; i < kTriedAlphas.size(); ++i) {
    mix.alpha = std::max(kTriedAlphas[i], invalid);
    mix.channels = glm::vec3(mix.alpha);
    out[i + 1] = colorDistance(twin::blend(model.settings, mix).resolved, output);
  }
  return out;
}

} // namespace

float colorDistance(const glm::vec3& a, const glm::vec3& b) {
  float largest = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const auto bounded = [](float c) { return c / (1.0f + std::max(c, 0.0f)); };
    const float difference = std::abs(bounded(a[i]) - bounded(b[i]));
    if (!(difference < kMostDistance)) return kMostDistance; // NaN, too
    largest = std::max(largest, difference);
  }
  return largest;
}

std::vector<glm::ivec2> resolvePixels(const ResolveFrames& frames, PixelSet set, std::size_t most) {
  // Roberts 2018: the additive sequence of the plastic number fills a square evenly.
  constexpr double kPlaceStepX = 0.7548776662466927, kPlaceStepY = 0.5698402909980532;
  const glm::ivec2 size = frames.now.sizePx();
  std::vector<glm::ivec2> out;
  if (size.x < 3 || size.y < 3) return out;
  const std::size_t tries = set == PixelSet::Silhouettes ? kMostTriesOfSilhouettes : kMostTries;
  std::vector<bool> isTaken(static_cast<std::size_t>(size.x) * size.y, false);
  double x = 0.5, y = 0.5;
  for (std::size_t i = 0; i < tries && out.size() < most; ++i) {
    x += kPlaceStepX;
    y += kPlaceStepY;
    x -= std::floor(x);
    y -= std::floor(y);
    const glm::ivec2 pixel(1 + static_cast<int>(x * (size.x - 2)), 1 + static_cast<int>(y * (size.y - 2)));
    const std::size_t index = static_cast<std::size_t>(pixel.y) * size.x + pixel.x;
    if (isTaken[index] || !isOfSet(frames.now, set, pixel) || !isPlain(frames.now, pixel)) continue;
    isTaken[index] = true;
    out.push_back(pixel);
  }
  return out;
}

ResolveTwin::ResolveTwin(const ResolveFrames& frames)
    : frames_(frames), inputs_(twinInputs(frames.now)), inputsBefore_(twinInputs(frames.before)),
      opposite_(negated(frames.now.motionPx)), output_(frames.before.output),
      outputTwoBefore_(frames.outputTwoBefore) {
  inputs_.lastJitterPx = frames.before.jitterPx;
}

bool ResolveTwin::canTry(const ResolveModel& model) const {
  return model.kind != ResolveKind::NotSwapped || !outputTwoBefore_.empty();
}

void ResolveTwin::takeHistory(const ResolveModel& model) {
  std::swap(inputs_.historyColor, model.kind == ResolveKind::NotSwapped ? outputTwoBefore_ : output_);
  if (model.kind == ResolveKind::Opposite) std::swap(inputs_.motion, opposite_);
}

ModelDistances ResolveTwin::distances(const ResolveModel& model, const std::vector<glm::ivec2>& pixels) {
  takeHistory(model);
  const float length = lengthAfterFrames(model.settings, frames_.historyFrames);
  const glm::vec4 terms = frames_.before.depthTerms;
  const DilateSettings& dilate = model.settings.dilate;
  inputs_.historySurface = keptOf(inputsBefore_, dilate, [length, terms](const twin::DilatedMotion& dilated) {
    return glm::vec2(length, twin::viewDepth(dilated.depth, terms));
  });
  inputs_.historyMotion =
      keptOf(inputsBefore_, dilate, [](const twin::DilatedMotion& dilated) { return dilated.motion; });
  ModelDistances sum{};
  for (const glm::ivec2& pixel : pixels) {
    const twin::PixelRecord record = twin::resolvePixel(inputs_, model.settings, pixel.x, pixel.y);
    const glm::vec3 output(frames_.now.output.texel(pixel.x, pixel.y));
    const ModelDistances one = distancesAt(model, record, output, pixel, frames_.now.frame);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one[i];
  }
  takeHistory(model); // gives back what was swapped
  return sum;
}

} // namespace taa::doctor
