#include "core/render/CaptureFacts.h"

#include "core/base/Say.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace taa {

namespace {

/// Faults of what pictures are drawn with; those of a capture are drawn already.
constexpr std::array<std::string_view, 6> kDrawnFaults{"fault.jitterApplied", "fault.jitterPeriod",
                                                       "fault.jitterMeanX",   "fault.jitterMeanY",
                                                       "fault.depthJitter",   "fault.skyJitter"};

bool wantsCameras(const Parameter& row) {
  return row.path == "inputs.motion" || row.path == "fault.previousCamera" || row.path == "fault.cameraTurn";
}

} // namespace

int periodOf(const std::vector<glm::vec2>& jitterPx) {
  constexpr float kSame = 1e-3f;               // px; engines print few digits
  constexpr std::size_t kLongestPeriod = 1024; // as jitter.period; of 100,000 frames more would take seconds
  const std::size_t frames = jitterPx.size();
  const auto repeats = [&](std::size_t period) {
    for (std::size_t frame = period; frame < frames; ++frame)
      if (glm::distance(jitterPx[frame], jitterPx[frame - period]) > kSame) return false;
    return true;
  };
  // A pattern that is seen less than twice is not known to repeat, unless nothing moves at all.
  for (std::size_t period = 1; 2 * period <= frames && period <= kLongestPeriod; ++period)
    if (repeats(period)) return static_cast<int>(period);
  return std::max(1, static_cast<int>(frames));
}

Settings settingsOn(const CaptureFacts& capture, const Settings& settings) {
  Settings own = settings;
  own.jitter = {};
  own.jitter.taa = settings.jitter.taa;
  own.jitter.period = std::min(capture.jitterPeriod, static_cast<int>(parameter("jitter.period").maximum));
  own.inputs = {};
  own.inputs.precision = settings.inputs.precision;
  if (capture.hasCameraMotion) own.inputs.motion = settings.inputs.motion;
  if (capture.hasMask) own.inputs.mask = MaskSource::Material;
  if (capture.hasOverlay) own.inputs.blended = BlendedAs::After;
  const Settings healthy;
  for (const Parameter& row : parameters())
    if (row.stage == Stage::Faults && isFixedBy(capture, row)) row.set(own, row.get(healthy));
  const glm::vec2 ratio = glm::vec2(capture.renderPx) / glm::vec2(capture.outputPx);
  own.inputs.renderScale = std::min(ratio.x, ratio.y);
  return own;
}

bool isFixedBy(const CaptureFacts& capture, const Parameter& row) {
  if (row.path == "inputs.precision") return false;
  if (wantsCameras(row)) return !capture.hasCameraMotion;
  if (std::ranges::find(kDrawnFaults, row.path) != kDrawnFaults.end()) return true;
  return row.path.starts_with("jitter.") || row.path.starts_with("inputs.");
}

std::string whyFixed(const Parameter& row) {
  if (wantsCameras(row))
    return say<"this capture lacks depth or matrices, so that there is no other motion than its own">();
  return say<"%1 is the capture's own: its frames are as they were taken">(row.label);
}

std::string whyNoScene() {
  return say<"a capture has the camera and the objects it was taken with">();
}

std::string whyOneSize(const CaptureFacts& capture) {
  return say<"this capture has the size it was taken with, %1 × %2 pixels">(capture.outputPx.x,
                                                                            capture.outputPx.y);
}

std::string whyNoReference() {
  return say<"this capture has no reference, and none can be drawn of it">();
}

std::string whyNoEngineOutput() {
  return say<"there is no output of an engine: only a capture that holds it has one">();
}

} // namespace taa
