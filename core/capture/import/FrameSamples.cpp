#include "core/capture/import/FrameSamples.h"

#include "core/base/Error.h"
#include "core/base/Light.h"
#include "core/base/Say.h"
#include "core/capture/decode/CameraMotion.h"
#include "core/capture/decode/Cameras.h"
#include "core/capture/decode/Color.h"
#include "core/capture/decode/Depth.h"
#include "core/capture/decode/Motion.h"
#include "core/capture/decode/PlaneShapes.h"
#include "core/capture/decode/ScreenUnits.h"
#include "core/capture/planes/Planes.h"

#include <glm/common.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <utility>

namespace taa::capture {

namespace {

constexpr double kSamplesPerPair = 40000.0;
constexpr double kMaxPictureValues = 64e6; ///< of all pairs' whole pictures
constexpr glm::vec2 kUnknownMotion(std::numeric_limits<float>::quiet_NaN());

/// The same for every run: a pixel somewhere in each cell of a grid.
std::vector<glm::ivec2> samplePlaces(const glm::ivec2& size) {
  const double pixels = static_cast<double>(size.x) * size.y;
  const int cell = std::max(1, static_cast<int>(std::lround(std::sqrt(pixels / kSamplesPerPair))));
  std::vector<glm::ivec2> places;
  std::uint32_t random = 1;
  for (int y = 0; y < size.y; y += cell)
    for (int x = 0; x < size.x; x += cell) {
      random = random * 1664525u + 1013904223u;
      const auto step = static_cast<std::uint32_t>(cell);
      const glm::ivec2 place(x + static_cast<int>((random >> 8u) % step),
                             y + static_cast<int>((random >> 20u) % step));
      if (place.x < size.x && place.y < size.y) places.push_back(place);
    }
  return places;
}

Image packed(const Image& plane, const std::vector<glm::ivec2>& places) {
  Image out(static_cast<int>(places.size()), 1, plane.channels);
  for (std::size_t i = 0; i < places.size(); ++i)
    std::copy_n(plane.at(places[i].x, places[i].y), plane.channels, out.at(static_cast<int>(i), 0));
  return out;
}

/// Frames to look at with those before them: spread over the capture, without cuts.
std::vector<std::size_t> pairIndices(const Manifest& manifest, int maxPairs) {
  std::vector<std::size_t> all;
  for (std::size_t i = 1; i < manifest.frames.size(); ++i)
    if (!manifest.frames[i].cut && manifest.frames[i].number == manifest.frames[i - 1].number + 1)
      all.push_back(i);
  const auto wanted = static_cast<std::size_t>(std::max(1, maxPairs));
  if (all.size() <= wanted) return all;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < wanted; ++i)
    out.push_back(all[wanted > 1 ? i * (all.size() - 1) / (wanted - 1) : all.size() / 2]);
  return out;
}

/// Distance along the axis from one along the ray; see DepthKind.
void makePlanar(Image& depth, const std::vector<glm::ivec2>& places, const StatedCamera& camera,
                const glm::dvec2& jitterPx, const glm::ivec2& size) {
  if (camera.camera.orthographic) return;
  const glm::dmat4& clip = camera.camera.clipFromView;
  const glm::dmat2 rayFromNdc = glm::inverse(glm::dmat2(clip));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec2 place = (glm::dvec2(places[i]) + 0.5 - jitterPx) / glm::dvec2(size);
    const glm::dvec2 ray =
        rayFromNdc * (glm::dvec2(2.0 * place.x - 1.0, 1.0 - 2.0 * place.y) + glm::dvec2(clip[2]));
    depth.pixels[i] /= static_cast<float>(std::sqrt(1.0 + ray.x * ray.x + ray.y * ray.y));
  }
}

Image packedPlane(const std::vector<float>& values) {
  Image out(static_cast<int>(values.size()), 1, 1);
  out.pixels = values;
  return out;
}

/// This program's depth of what lies at a distance along the camera's axis, m; 0 for 0, which is nowhere.
float depthAt(const StatedCamera& camera, double distance) {
  if (distance <= 0.0) return 0.0f;
  const glm::dmat4& clip = camera.camera.clipFromView;
  const bool isOrthographic = camera.camera.orthographic;
  return static_cast<float>(isOrthographic ? clip[3][2] - clip[2][2] * distance
                                           : camera.nearPlane / distance);
}

bool needsCamera(const MotionConventions& motion) {
  const bool canLack = motion.notWritten || motion.encoding == MotionEncoding::Unreal;
  return (canLack && motion.fallback == MotionFallback::Camera) || motion.whereNothing.has_value() ||
         !motion.includesCamera;
}

} // namespace

Image comparedLuma(const Image& color) {
  Image luma(color.width, color.height, 1);
  for (std::size_t i = 0; i < luma.pixels.size(); ++i) {
    const float* at = color.pixels.data() + i * static_cast<std::size_t>(color.channels);
    const float light = std::max(0.0f, luminance(glm::vec3(at[0], at[1], at[2])));
    const float bounded = light / (1.0f + light);
    luma.pixels[i] = std::isfinite(bounded) ? bounded : (light > 1.0f ? 1.0f : 0.0f);
  }
  Image rows = luma;
  const int lastX = luma.width - 1, lastY = luma.height - 1;
  for (int y = 0; y <= lastY; ++y)
    for (int x = 0; x <= lastX; ++x)
      *rows.at(x, y) = 0.25f * *luma.at(std::max(x - 1, 0), y) + 0.5f * *luma.at(x, y) +
                       0.25f * *luma.at(std::min(x + 1, lastX), y);
  for (int y = 0; y <= lastY; ++y)
    for (int x = 0; x <= lastX; ++x)
      *luma.at(x, y) = 0.25f * *rows.at(x, std::max(y - 1, 0)) + 0.5f * *rows.at(x, y) +
                       0.25f * *rows.at(x, std::min(y + 1, lastY));
  return luma;
}

float betweenPixels(const Image& plane, const glm::vec2& place) {
  const glm::vec2 first(0.5f),
      last(static_cast<float>(plane.width) - 0.5f, static_cast<float>(plane.height) - 0.5f);
  return bilinear(glm::clamp(place, first, last), [&](int x, int y) { return *plane.nearest(x, y); });
}

FrameSamples::FrameSamples(const std::filesystem::path& folder, Manifest manifest, int maxPairs,
                           const Progress& progress)
    : manifest_(std::move(manifest)) {
  const CapturedFrame& first = manifest_.frames.front();
  const auto someHave = [&](PlaneKind kind) {
    return std::ranges::any_of(manifest_.frames, [&](const CapturedFrame& frame) {
      return manifest_.plane(frame, kind) != nullptr;
    });
  };
  hasMotion_ = someHave(PlaneKind::Motion);
  hasDepth_ = someHave(PlaneKind::Depth);
  hasMatrices_ = std::ranges::all_of(manifest_.frames, [](const CapturedFrame& frame) {
    return frame.view.has_value() && frame.projection.has_value();
  });
  hasJitter_ = std::ranges::any_of(manifest_.frames,
                                   [&](const CapturedFrame& frame) { return frame.jitter != first.jitter; });
  const double pictures = asksDepthJitter() ? 2.0 : 1.0;
  const double values = pictures * static_cast<double>(manifest_.sizePx.x) * manifest_.sizePx.y;
  const int affordable = std::max(1, static_cast<int>(kMaxPictureValues / std::max(1.0, values)));
  const std::vector<std::size_t> indices = pairIndices(manifest_, std::min(maxPairs, affordable));
  int done = 0;
  for (const std::size_t index : indices) {
    report(progress, say<"Reading frames">(), done++, static_cast<int>(indices.size()));
    pairs_.push_back(read(folder, index));
  }
}

FramePair FrameSamples::read(const std::filesystem::path& folder, std::size_t index) {
  const auto colorOf = [&](const CapturedFrame& frame, FramePlanes& planes) {
    PlaneShapes shapes(planes, manifest_.sizePx, frame.number);
    Image color = shapes.takeUnscaled(PlaneKind::Color);
    if (color.empty()) throw Error(say<"frame %1 has no color">(frame.number));
    if (glm::ivec2(color.width, color.height) != manifest_.sizePx)
      throw Error(say<"frame %1: color is %2×%3, and others are %4×%5">(
          frame.number, color.width, color.height, manifest_.sizePx.x, manifest_.sizePx.y));
    ColorDecoder(manifest_, frame, PlaneKind::Color).decode(color);
    return comparedLuma(color);
  };
  const auto planesOf = [&](std::size_t at, std::initializer_list<PlaneKind> kinds) {
    const CapturedFrame& frame = manifest_.frames[at];
    FramePlanes planes;
    for (const PlaneKind kind : kinds)
      if (manifest_.plane(frame, kind)) planes.emplace(kind, readPlane(folder, manifest_, frame, kind));
    return planes;
  };
  FramePair pair;
  pair.index = index;
  pair.places = samplePlaces(manifest_.sizePx);
  const CapturedFrame& frame = manifest_.frames[index];
  FramePlanes planes = planesOf(index, {PlaneKind::Color, PlaneKind::Motion, PlaneKind::Depth});
  pair.luma = packed(colorOf(frame, planes), pair.places).pixels;
  PlaneShapes shapes(planes, manifest_.sizePx, frame.number);
  if (const Image motion = shapes.take(PlaneKind::Motion); !motion.empty())
    pair.motion = packed(motion, pair.places);
  if (const Image depth = shapes.take(PlaneKind::Depth); !depth.empty())
    pair.depth = packed(depth, pair.places);
  FramePlanes before = asksDepthJitter() ? planesOf(index - 1, {PlaneKind::Color, PlaneKind::Depth})
                                         : planesOf(index - 1, {PlaneKind::Color});
  pair.previousLuma = colorOf(manifest_.frames[index - 1], before);
  pair.previousDepth =
      PlaneShapes(before, manifest_.sizePx, manifest_.frames[index - 1].number).take(PlaneKind::Depth);
  return pair;
}

bool FrameSamples::takeGeometry(const FramePair& pair, const glm::dvec2& jitterPx, PairMotion& out) {
  Image depth = pair.depth;
  DepthConventions& kind = manifest_.conventions.depth;
  const glm::dvec2 depthJitter = kind.jittered ? jitterPx : glm::dvec2(0.0);
  StatedCameras cameras;
  try {
    if (hasMatrices_) cameras = statedCameras(manifest_, pair.index);
    const StatedCamera* now = cameras.now ? &*cameras.now : nullptr;
    if (kind.kind == DepthKind::Radial && now) {
      makePlanar(depth, pair.places, *now, depthJitter, manifest_.sizePx);
      kind.kind = DepthKind::Planar;
    }
    DepthDecoder(manifest_, now, jitterPx).decode(depth);
  } catch (const Error&) {
    return false;
  }
  out.depth = std::move(depth.pixels);
  if (!cameras.now || !cameras.previous) return true;
  const CameraMotion camera(cameras.now->camera, cameras.previous->camera, manifest_.sizePx, depthJitter);
  for (std::size_t i = 0; i < pair.places.size(); ++i) {
    const glm::ivec2 place = pair.places[i];
    out.camera.push_back(camera.motionPx(place.x, place.y, out.depth[i]));
    const float distance = camera.previousDepth(place.x, place.y, out.depth[i]);
    out.previousDepth.push_back(depthAt(*cameras.previous, static_cast<double>(distance)));
  }
  return true;
}

// The camera's motion needs places, which packed pixels have not: they are marked and filled in here.
void FrameSamples::takeStored(const FramePair& pair, const MotionInputs& inputs, PairMotion& out) {
  MotionConventions& motion = manifest_.conventions.motion;
  const MotionConventions stated = motion;
  if (motion.fallback == MotionFallback::Camera) motion.fallback = MotionFallback::None;
  if (motion.whereNothing == MotionFallback::Camera) motion.whereNothing = MotionFallback::None;
  Image decoded = pair.motion;
  MotionDecoder(manifest_, inputs).decode(decoded);
  for (std::size_t i = 0; i < pair.places.size(); ++i) {
    glm::vec2 px(decoded.pixels[2 * i], decoded.pixels[2 * i + 1]);
    const bool isMarked = px == glm::vec2(kNoPreviousPosition);
    const bool isNothing = !out.depth.empty() && out.depth[i] == 0.0f && stated.whereNothing.has_value();
    const bool isCamera =
        isMarked && (isNothing ? stated.whereNothing : stated.fallback) == MotionFallback::Camera;
    const glm::vec2 ofCamera = out.camera.empty() ? glm::vec2(0.0f) : out.camera[i];
    if (isCamera)
      px = ofCamera;
    else if (!stated.includesCamera && !isMarked && !isNothing)
      px += ofCamera;
    const bool isKnown = std::max(std::abs(px.x), std::abs(px.y)) < kNoPreviousPosition;
    out.stored[i] = isKnown ? px : kUnknownMotion;
  }
}

std::optional<PairMotion> FrameSamples::motionOf(const FramePair& pair, const TestState& state,
                                                 bool withCamera) {
  manifest_.conventions = state.conventions;
  PairMotion out;
  const bool isStated = statesJitterOf(manifest_, pair.index).has_value() &&
                        statesJitterOf(manifest_, pair.index - 1).has_value();
  const glm::dvec2 jitterPx = decodeJitter(manifest_, pair.index);
  const glm::dvec2 previousJitterPx = decodeJitter(manifest_, pair.index - 1);
  if (state.isJittered) out.jitterStep = glm::vec2(previousJitterPx - jitterPx);
  const bool isWanted = withCamera || pair.motion.empty() || needsCamera(manifest_.conventions.motion);
  if (isWanted && !pair.depth.empty() && !takeGeometry(pair, jitterPx, out)) return {};

  out.stored.assign(pair.places.size(), isStated ? glm::vec2(0.0f) : kUnknownMotion);
  if (!isStated) return out;
  if (pair.motion.empty()) {
    if (!out.camera.empty()) out.stored = out.camera;
    return out;
  }
  Image depth;
  if (!out.depth.empty()) depth = packedPlane(out.depth);
  takeStored(pair, {jitterPx, previousJitterPx, depth.empty() ? nullptr : &depth, nullptr}, out);
  return out;
}

std::optional<Image> FrameSamples::previousDepthOf(const FramePair& pair, const TestState& state) {
  manifest_.conventions = state.conventions;
  Image depth = pair.previousDepth;
  if (depth.empty()) return depth;
  try {
    const StatedCameras cameras = statedCameras(manifest_, pair.index - 1);
    const StatedCamera* camera = cameras.now ? &*cameras.now : nullptr;
    DepthDecoder(manifest_, camera, decodeJitter(manifest_, pair.index - 1)).decode(depth);
  } catch (const Error&) {
    return {};
  }
  return depth;
}

} // namespace taa::capture
