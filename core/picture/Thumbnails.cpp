// Exposes a picture at few of its pixels.
#include "core/picture/Thumbnails.h"

namespace taa {

const Exposure& Thumbnails::exposed(TaaPass& pass, const ResolvedFrame& frame, const glm::ivec2& texels) {
  const gl::Rect whole{0, 0, frame.inputs.outputWidth(), frame.inputs.outputHeight()};
  if (exposure_.region() != whole || exposure_.texels() != texels) {
    forget();
    exposure_ = Exposure(allRows(), whole, texels);
  }
  if (shownHistory_.lock() == frame.current) return exposure_;
  pass.expose(frame.inputs, frame.previous.get(), *frame.current, frame.settings, exposure_);
  shownHistory_ = frame.current;
  return exposure_;
}

Picture Thumbnails::draw(TaaPass& pass, Visualizer& visualizer, const ResolvedFrame& frame, IntermediateId id,
                         const glm::ivec2& texels) {
  const Exposure& exposure = exposed(pass, frame, texels);
  const Intermediate& row = intermediate(id);
  return visualizer.draw(exposure.texture(id), exposure.layer(id), exposure.firstChannel(id), row,
                         defaultStyle(row), {}, texels.x, texels.y);
}

void Thumbnails::forget() {
  exposure_ = {};
  shownHistory_.reset();
}

} // namespace taa
