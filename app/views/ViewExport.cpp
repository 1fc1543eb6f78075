// What a view shows, as files and command lines are asked for it.
#include "app/views/ViewPanel.h"
#include "app/views/Viewport.h"

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {

/// The column of the whole picture that lies at a column of the screen.
double pictureColumn(const ViewTransform& transform, int screen) {
  return pictureFromScreen(transform, {screen, 0.0}).x;
}

} // namespace

PictureRequest ViewPanel::pictureRequest(const QStringList& presets, PictureExtent extent) const {
  const ViewRequest shown = request(presets);
  PictureRequest picture{.id = id_,
                         .style = shown.style,
                         .transform = {},
                         .width = viewport_->viewGeometry().picture.x,
                         .height = viewport_->viewGeometry().picture.y,
                         .lane = shown.lane,
                         .other = shown.other,
                         .showing = shown.other ? showing_ : Showing::First};
  if (extent == PictureExtent::Viewport) {
    picture.transform = viewport_->transform();
    picture.width = viewport_->viewGeometry().viewport.x;
    picture.height = viewport_->viewGeometry().viewport.y;
    picture.divider = viewport_->dividerColumn();
  } else {
    const double column = pictureColumn(viewport_->transform(), viewport_->dividerColumn());
    picture.divider = static_cast<int>(std::lround(std::clamp(column, 0.0, 1.0 * picture.width)));
  }
  return picture;
}

CommandView ViewPanel::commandView() const {
  const int width = std::max(1, viewport_->viewGeometry().picture.x);
  const double column = pictureColumn(viewport_->transform(), viewport_->dividerColumn());
  return {.id = id_,
          .style = drawn(style()),
          .comparison = comparison_,
          .showing = showing_,
          .otherStyle = comparison_ ? otherStyle() : ViewStyle{},
          .divider = std::clamp(std::round(column) / width, 0.0, 1.0)};
}

} // namespace taa::app
