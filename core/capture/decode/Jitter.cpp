// Jitter as a capture states it, in pixels that content moves by.
#include "core/capture/decode/ScreenUnits.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/decode/DecodedFrame.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace taa::capture {

glm::dvec2 pxPerJitter(const Manifest& manifest) {
  const JitterConventions& conventions = manifest.conventions.jitter;
  const glm::dvec2 px = pxPerUnit(conventions.unit, conventions.yAxis, manifest.sizePx);
  return conventions.meaning == JitterMeaning::Sample ? -px : px;
}

std::optional<std::size_t> statesJitterOf(const Manifest& manifest, std::size_t index) {
  const auto at = static_cast<std::int64_t>(index) - manifest.conventions.jitter.delay;
  if (at < 0 || at >= static_cast<std::int64_t>(manifest.frames.size())) return {};
  return static_cast<std::size_t>(at);
}

glm::dvec2 decodeJitter(const Manifest& manifest, std::size_t index) {
  const std::optional<std::size_t> at = statesJitterOf(manifest, index);
  if (!at) return glm::dvec2(0.0);
  const CapturedFrame& frame = manifest.frames[*at];
  // + 0: no −0 in tables.
  const glm::dvec2 px = frame.jitter * pxPerJitter(manifest) + 0.0;
  if (!std::isfinite(px.x) || !std::isfinite(px.y))
    throw Error(say<"frame %1: its jitter is not a finite number">(frame.number));
  return px;
}

} // namespace taa::capture
