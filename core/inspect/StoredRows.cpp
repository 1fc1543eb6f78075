#include "core/inspect/StoredRows.h"

namespace taa {

namespace {

// Output is resolved as long as nothing is done to it, see shaders/taa/output.glsl.
bool showsResolved(const Settings& settings) {
  return settings.output.sharpen == Sharpen::None && settings.output.motionBlur == Switch::Off &&
         settings.inputs.blended != BlendedAs::After;
}

} // namespace

// The resolve writes colors to the history that were rounded before to what it can hold, and lengths as
// 32-bit floats (blend.glsl). What else a history keeps is computed from rows and is none itself.
bool isStored(IntermediateId id, const Settings& settings) {
  if (id == IntermediateId::output) return showsResolved(settings);
  return id == IntermediateId::resolved || id == IntermediateId::historyLength;
}

Exposure storedRows(const History& history, const std::vector<IntermediateId>& ids) {
  Exposure exposure(ids, {0, 0, history.color.width(), history.color.height()});
  const gl::Framebuffer color({{&history.color}}, nullptr, "history color");
  const gl::Framebuffer surface({{&history.surface}}, nullptr, "history surface");
  for (const IntermediateId id : exposure.watched()) {
    const gl::Framebuffer row({{&exposure.texture(id), exposure.layer(id)}}, nullptr, "stored row");
    gl::copyColor(id == IntermediateId::historyLength ? surface : color, row);
  }
  return exposure;
}

} // namespace taa
