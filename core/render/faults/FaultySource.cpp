#include "core/render/faults/FaultySource.h"

#include "core/base/Say.h"
#include "core/gl/Context.h"
#include "core/render/CaptureFacts.h"
#include "core/render/FrameRequest.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cassert>
#include <utility>

namespace taa {

namespace {

bool changesPlanes(const FaultSettings& faults) {
  return changesMotion(faults) || changesDepth(faults) || changesColor(faults) || faults.depthJitter != 1.0f;
}

bool changesJitter(const FaultSettings& faults) {
  return faults.jitter != JitterFault::None || faults.jitterReported != 1.0f ||
         faults.jitterApplied != 1.0f || faults.jitterPeriod > 0 || faults.jitterMeanX != 0.0f ||
         faults.jitterMeanY != 0.0f;
}

glm::vec2 misreported(JitterFault fault, const glm::vec2& j) {
  switch (fault) {
  case JitterFault::NegatedX:
    return {-j.x, j.y};
  case JitterFault::NegatedY:
    return {j.x, -j.y};
  case JitterFault::Negated:
    return -j;
  case JitterFault::Swapped:
    return {j.y, j.x};
  case JitterFault::Unreported:
    return glm::vec2(0.0f);
  case JitterFault::None:
  case JitterFault::Late:
  case JitterFault::Early:
    break; // right, of this frame or of another
  }
  return j;
}

// Matrices as they would be if the picture were drawn with the jitter that is reported.
void reportJitter(const glm::vec2& applied, const FaultyJitter& now, const glm::vec2& last,
                  shared::FrameBlock& block) {
  const glm::dvec2 ndc =
      glm::dvec2(2.0, -2.0) * glm::dvec2(now.reported - applied) / glm::dvec2(block.sizePx);
  const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), glm::dvec3(ndc, 0.0));
  const glm::dmat4 clip = glm::inverse(glm::dmat4(block.worldFromJitteredClip));
  block.worldFromJitteredClip = glm::mat4(glm::inverse(moved * clip));
  block.jitteredClipFromWorld = glm::mat4(moved * glm::dmat4(block.jitteredClipFromWorld));
  block.jitterPx = now.reported;
  block.previousJitter = glm::vec4(last, 0.0f, 0.0f);
}

} // namespace

bool changesInputs(const FaultSettings& faults) {
  return changesJitter(faults) || changesPlanes(faults);
}

bool isFaultyFrame(const FaultSettings& faults, int frame) {
  return frame >= faults.firstFrame && frame <= faults.lastFrame;
}

FaultyJitter faultyJitter(const FaultSettings& faults, const JitterOfFrame& given, int frame, bool isDrawn) {
  if (!isFaultyFrame(faults, frame)) return {given(frame), given(frame)};
  const auto drawn = [&](int number) {
    if (!isDrawn) return given(number);
    const int place = faults.jitterPeriod > 0 ? number % faults.jitterPeriod : number;
    return given(place) + glm::vec2(faults.jitterMeanX, faults.jitterMeanY);
  };
  int told = frame;
  if (faults.jitter == JitterFault::Late) told = std::max(frame - 1, 0);
  if (faults.jitter == JitterFault::Early) told = frame + 1;
  return {(isDrawn ? faults.jitterApplied : 1.0f) * drawn(frame),
          faults.jitterReported * misreported(faults.jitter, drawn(told))};
}

FaultySource::FaultySource(std::unique_ptr<FrameSource> source) : source_(std::move(source)) {
  assert(source_);
}

// The sequence is asked for with what the request says of it; of a capture it ends with its frames.
FaultyJitter FaultySource::jitter(const FrameRequest& request, int frame) const {
  const auto facts = source_->capture();
  const int last = facts ? static_cast<int>(facts->jitterPx.size()) - 1 : std::max(frame + 1, 0);
  const auto given = [&](int number) { return source_->info(request, std::min(number, last)).jitterPx; };
  return faultyJitter(request.faults, given, frame, isDrawn());
}

/// What is asked of the source: the frame without faults, but for what it is drawn with.
FrameRequest FaultySource::plain(const FrameRequest& request, int frame, float jitterScale) const {
  FrameRequest asked = request;
  asked.faults = {};
  if (changesPlanes(request.faults))
    asked.part.reset(); // planes are read elsewhere than where they are written
  if (isDrawn() && (changesJitter(request.faults) || jitterScale != 1.0f))
    asked.jitterPx = jitterScale * jitter(request, frame).applied;
  return asked;
}

void FaultySource::draw(const FrameRequest& request, int frame, FrameInputs& out) {
  if (request.faults == FaultSettings{}) {
    source_->draw(request, frame, out);
    return;
  }
  source_->draw(plain(request, frame), frame, out);
  if (isFaultyFrame(request.faults, frame) && changesPlanes(request.faults)) drawFaulty(request, frame, out);
  report(request, frame, out);
}

void FaultySource::drawFaulty(const FrameRequest& request, int frame, FrameInputs& out) {
  const FaultSettings& faults = request.faults;
  if (!pass_) pass_.emplace();
  const int last = out.info.startsHistory ? frame : std::max(frame - 1, 0);
  pass_->begin(faults, out, {jitter(request, frame).applied, jitter(request, last).applied});
  if (faults.previousAge > 1) followOlder(request, frame, out);
  if (changesMotion(faults)) pass_->drawMotion(motionOf(request, frame, out), out);
  if (changesColor(faults)) {
    const bool isSkyApart = faults.skyJitter != 1.0f && isDrawn();
    if (isSkyApart) source_->draw(plain(request, frame, faults.skyJitter), frame, other_);
    pass_->drawColor(isSkyApart ? other_ : out, out);
  }
  if (faults.depthJitter != 1.0f && isDrawn()) {
    source_->draw(plain(request, frame, faults.depthJitter), frame, other_);
    std::swap(out.depth, other_.depth);
  }
  if (changesDepth(faults)) pass_->drawDepth(out);
  gl::checkErrors(say<"injecting faults into frame %1">(frame));
}

// Back to a cut at most: before it nothing is of the same picture.
void FaultySource::followOlder(const FrameRequest& request, int frame, FrameInputs& out) {
  bool isStart = out.info.startsHistory;
  for (int back = 1; back < request.faults.previousAge && !isStart; ++back) {
    const int older = frame - back;
    source_->draw(plain(request, older), older, other_);
    pass_->follow(other_.motion, out);
    isStart = other_.info.startsHistory;
  }
}

/// The plane that is taken for the frame's motion.
const gl::Texture& FaultySource::motionOf(const FrameRequest& request, int frame, FrameInputs& out) {
  int from = std::max(frame - request.faults.motionLag, 0);
  if (const auto facts = source_->capture()) // which ends with its frames
    from = std::min(from, static_cast<int>(facts->jitterPx.size()) - 1);
  const bool isUntested = isOn(request.faults.motionUntested) && isDrawn();
  if (from == frame && !isUntested) return out.motion;
  FrameRequest asked = plain(request, from);
  asked.untestedMotion = isUntested;
  source_->draw(asked, from, other_);
  return other_.motion;
}

void FaultySource::report(const FrameRequest& request, int frame, FrameInputs& out) const {
  const FaultSettings& faults = request.faults;
  const glm::vec2 applied = out.info.jitterPx;
  out.info = info(request, frame);
  if (isFaultyFrame(faults, frame)) out.block.depthTerms.y *= faults.nearPlane;
  if (!changesJitter(faults)) return;
  const int last = out.info.startsHistory ? frame : std::max(frame - 1, 0);
  reportJitter(applied, jitter(request, frame), jitter(request, last).reported, out.block);
}

FrameInfo FaultySource::info(const FrameRequest& request, int frame) const {
  FrameInfo info = source_->info(request, frame);
  if (changesJitter(request.faults)) info.jitterPx = jitter(request, frame).reported;
  const bool isRestart = std::ranges::find(request.restarts, frame) != request.restarts.end();
  if (isOn(request.faults.keepsAtCuts) && frame > 0 && !isRestart) info.startsHistory = false;
  return info;
}

CameraState FaultySource::camera(const FrameRequest& request, int frame) const {
  return source_->camera(request, frame);
}

void FaultySource::warmUp(const FrameRequest& request, const Progress& progress) {
  source_->warmUp(request, progress);
}

const DrawCounts& FaultySource::counts() const {
  return source_->counts();
}

void FaultySource::reloadShaders() {
  std::optional<FaultPass> pass;
  if (pass_) pass.emplace(pass_->reloaded());
  source_->reloadShaders();
  if (pass) pass_ = std::move(pass);
}

std::shared_ptr<const CaptureFacts> FaultySource::capture() const {
  return source_->capture();
}

std::shared_ptr<const Image> FaultySource::reference(int frame) {
  return source_->reference(frame);
}

std::shared_ptr<const Image> FaultySource::engineOutput(int frame) {
  return source_->engineOutput(frame);
}

} // namespace taa
