#include "core/inspect/EvidenceFrames.h"

#include "core/base/Say.h"
#include "core/gl/PassTimer.h"
#include "core/measure/Profiler.h"
#include "core/measure/References.h"
#include "core/probe/NearParts.h"
#include "core/probe/SurfaceSteps.h"
#include "core/render/CaptureFacts.h"
#include "core/verdict/lineage/TwinStep.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

namespace {

/// Side of the tiles of references and steps: small, because each sample of a reference is drawn as far as
/// they reach, and where surfaces are dense that costs most of a verdict.
constexpr int kEvidenceTile = 2;

/// The tiles that a part lies in, as far as the picture goes.
gl::Rect tilesOf(const gl::Rect& part, const glm::ivec2& sizePx) {
  constexpr int kTile = kEvidenceTile;
  const int left = std::max(part.x, 0) / kTile * kTile, top = std::max(part.y, 0) / kTile * kTile;
  const auto endOf = [](int end, int size) { return std::min((end + kTile - 1) / kTile * kTile, size); };
  return {left, top, endOf(part.x + part.width, sizePx.x) - left,
          endOf(part.y + part.height, sizePx.y) - top};
}

/// Whether what one of the 3×3 pixels shows was not seen a frame before, or only beside its place.
bool isUncovered(const twin::Texels& steps, const glm::ivec2& pixel) {
  return std::ranges::any_of(stepsAround(steps, pixel), [](const glm::vec4& step) {
    return std::isnan(step.x) || hasFlag(step.w, StepFlag::SeenBeside);
  });
}

} // namespace

EvidenceFrames::EvidenceFrames(ShotPlayer& player, References& references, int lane, EvidenceSamples samples,
                               const Progress& progress)
    : references_(references), frames_(player, lane, progress), lane_(lane), samples_(samples),
      progress_(progress), isWhole_(state().frames->capture() != nullptr),
      surfaces_(*state().frames, state().request(0)) {}

std::vector<gl::Rect> EvidenceFrames::partsRead(int frame, const glm::ivec2& pixel) const {
  const gl::Rect alone{pixel.x, pixel.y, 1, 1};
  const auto holds = [&](const gl::Rect& part) { return gl::contains(part, alone); };
  if (expected_.first == frame && std::ranges::any_of(expected_.second, holds)) return expected_.second;
  return {alone};
}

// The twin reads a frame once: what is awaited of it is made at the same time.
const twin::Inputs& EvidenceFrames::inputs(int frame, const glm::ivec2& pixel) {
  const twin::Inputs& inputs = frames_.at(frame, partsRead(frame, pixel));
  const auto awaited = awaited_.find(frame);
  if (awaited != awaited_.end() && !awaited->second.record) {
    const glm::ivec2& at = awaited->second.pixel;
    awaited->second.record = twin::resolvePixel(inputs, settings(), at.x, at.y);
  }
  return inputs;
}

PixelStep EvidenceFrames::step(int frame, const glm::ivec2& pixel) {
  const gl::PassGroup group(pass_group::kProbe);
  return pixelStep(inputs(frame, pixel), settings(), pixel);
}

twin::PixelRecord EvidenceFrames::record(int frame, const glm::ivec2& pixel) {
  const gl::PassGroup group(pass_group::kProbe);
  const auto awaited = awaited_.find(frame);
  if (awaited != awaited_.end() && awaited->second.record && awaited->second.pixel == pixel)
    return *awaited->second.record;
  return twin::resolvePixel(inputs(frame, pixel), settings(), pixel.x, pixel.y);
}

ReferenceKey EvidenceFrames::keyOf(int frame) const {
  return {referenceRequest(state().request(0)), frame};
}

Image EvidenceFrames::referencePart(int frame, const gl::Rect& part) {
  const gl::PassGroup group(pass_group::kReference);
  return references_.part(*state().frames, keyOf(frame), samples_.parts, part, drawn_);
}

// Of the tile, which is drawn for the reference anyway.
std::optional<double> EvidenceFrames::referenceError(int frame, const glm::ivec2& pixel) {
  if (isWhole_) return {};
  const gl::PassGroup group(pass_group::kReference);
  const gl::Rect tile = tilesOf({pixel.x, pixel.y, 1, 1}, {state().width, state().height});
  const Image error = references_.partError(*state().frames, keyOf(frame), samples_.parts, tile, drawn_);
  const float* channels = error.at(pixel.x - tile.x, pixel.y - tile.y);
  return static_cast<double>(std::max({channels[0], channels[1], channels[2]}));
}

Image EvidenceFrames::stepsPart(int frame, const gl::Rect& part) {
  const gl::PassGroup group(pass_group::kReference);
  return surfaces_.steps(frame, part, startsHistory(state(), frame), drawn_);
}

Image EvidenceFrames::wholeReference(int frame) {
  const gl::PassGroup group(pass_group::kReference);
  return references_.foundOrDrawn(*state().frames, keyOf(frame), samples_.pictures, references_, progress_)
      .mean();
}

Image EvidenceFrames::wholeSteps(int frame) {
  const gl::PassGroup group(pass_group::kReference);
  return drawSteps(*state().frames, state().request(0), frame, seen_);
}

const twin::Texels& EvidenceFrames::reference(int frame) {
  const auto known = means_.find(frame);
  if (known != means_.end()) return known->second;
  if (isWhole_) return means_[frame] = wholeReference(frame);
  const auto fetch = [this, frame](int x, int y, int width, int height) {
    return referencePart(frame, {x, y, width, height});
  };
  return means_[frame] = twin::Texels(state().width, state().height, 3, fetch, kEvidenceTile);
}

const twin::Texels& EvidenceFrames::steps(int frame) {
  const auto known = steps_.find(frame);
  if (known != steps_.end()) return known->second;
  const bool isStart = startsHistory(state(), frame);
  if (isWhole_) {
    if (!isStart) return steps_[frame] = wholeSteps(frame);
    const gl::PassGroup group(pass_group::kReference);
    const FrameRequest request = state().request(0);
    return steps_[frame] = firstSteps(drawSurfaces(*state().frames, request, frame),
                                      {0, 0, state().width, state().height});
  }
  const auto fetch = [this, frame](int x, int y, int width, int height) {
    return stepsPart(frame, {x, y, width, height});
  };
  return steps_[frame] = twin::Texels(state().width, state().height, kStepChannels, fetch, kEvidenceTile);
}

int EvidenceFrames::object(int frame, const glm::ivec2& pixel) {
  if (isWhole_) return EvidenceSource::object(frame, pixel);
  const gl::PassGroup group(pass_group::kReference);
  const glm::ivec2 last(state().width - 1, state().height - 1);
  return surfaces_.object(frame, glm::clamp(pixel, glm::ivec2(0), last), drawn_);
}

// The moment is read as well.
void EvidenceFrames::expect(int frame, const std::vector<gl::Rect>& parts) {
  if (isWhole_) return;
  std::vector<gl::Rect> wanted = parts;
  if (const auto awaited = awaited_.find(frame); awaited != awaited_.end())
    wanted.push_back({awaited->second.pixel.x, awaited->second.pixel.y, 1, 1});
  for (gl::Rect& part : wanted) part = tilesOf(part, {state().width, state().height});
  std::erase_if(wanted, [](const gl::Rect& part) { return part.width <= 0 || part.height <= 0; });
  wanted = nearParts(wanted);
  for (const gl::Rect& part : wanted) referencePart(frame, part);
  surfaces_.expect(frame, wanted);
  expected_ = {frame, std::move(wanted)};
}

std::vector<SurfaceMoment> EvidenceFrames::moments(int frame, const glm::ivec2& pixel, int frames) {
  std::vector<SurfaceMoment> moments;
  glm::dvec2 position(pixel.x + 0.5, pixel.y + 0.5);
  const float object = steps(frame).texel(pixel.x, pixel.y).z;
  for (int age = 0; age < frames; ++age) {
    SurfaceMoment moment;
    moment.frame = frame - age;
    moment.pixel = glm::ivec2(position);
    moment.place = position;
    moments.push_back(moment);
    awaited_[moment.frame].pixel = moment.pixel;
    if (!isWhole_) surfaces_.expect(moment.frame, {{moment.pixel.x - 1, moment.pixel.y - 1, 3, 3}});
    moments.back().isUncovered = isUncovered(steps(moment.frame), moment.pixel);
    const std::optional<glm::dvec2> step = stepAt(steps(moment.frame), position, object);
    if (!step) break;
    moments.back().motion = step;
    moments.back().isJump = glm::length(*step) > kJumpShare * state().width;
    position -= *step;
    if (position.x < 0.0 || position.y < 0.0 || position.x >= state().width || position.y >= state().height)
      break;
  }
  return moments;
}

glm::dvec3 EvidenceFrames::formerTruth(const SurfaceMoment& moment, const glm::dvec3& now) {
  const glm::ivec2 corner(glm::floor(moment.place - 0.5));
  glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
  for (int texel = 0; texel < 4; ++texel) {
    const glm::ivec2 at = corner + glm::ivec2(texel % 2, texel / 2);
    const glm::dvec3 truth = pixelColorAt(reference(moment.frame), at);
    low = glm::min(low, truth);
    high = glm::max(high, truth);
  }
  return glm::clamp(now, low, high);
}

void EvidenceFrames::fill(std::vector<SurfaceMoment>& moments) {
  for (SurfaceMoment& moment : moments) {
    report(progress_, say<"Looking back">(), static_cast<int>(&moment - moments.data()),
           static_cast<int>(moments.size()));
    moment.record = record(moment.frame, moment.pixel);
    moment.resolved = glm::dvec3(glm::vec3(twin::at(moment.record, IntermediateId::resolved)));
    moment.reference = pixelColorAt(reference(moment.frame), moment.pixel);
    moment.former = formerTruth(moment, moments.front().reference);
  }
}

} // namespace taa
