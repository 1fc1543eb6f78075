// Exposes a picture at few of its pixels.
#include "core/picture/Thumbnails.h"

namespace taa {

const ExposedRows& Thumbnails::exposed(TaaPass& pass, const ResolvedFrame& frame, const glm::ivec2& texels) {
  const gl::Rect whole{0, 0, frame.inputs.outputWidth(), frame.inputs.outputHeight()};
  if (exposedRows_.region() != whole || exposedRows_.texels() != texels) {
    forget();
    exposedRows_ = ExposedRows(allRows(), whole, texels);
  }
  if (shownHistory_.lock() == frame.current) return exposedRows_;
  pass.expose(frame.inputs, frame.previous.get(), *frame.current, frame.settings, exposedRows_);
  shownHistory_ = frame.current;
  return exposedRows_;
}

Picture Thumbnails::draw(TaaPass& pass, Visualizer& visualizer, const ResolvedFrame& frame, IntermediateId id,
                         const glm::ivec2& texels) {
  const ExposedRows& exposedRows = exposed(pass, frame, texels);
  const Intermediate& row = intermediate(id);
  return visualizer.draw(exposedRows.texture(id), exposedRows.layer(id), exposedRows.firstChannel(id), row,
                         defaultStyle(row), {}, texels.x, texels.y);
}

void Thumbnails::forget() {
  exposedRows_ = {};
  shownHistory_.reset();
}

} // namespace taa
