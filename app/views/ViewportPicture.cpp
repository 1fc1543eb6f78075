// What a viewport shows, as a picture for a file or the clipboard.
#include "app/views/Viewport.h"

#include "app/style/Theme.h"
#include "app/views/PixelOverlay.h"
#include "app/views/Wipe.h"

#include "core/inspect/ShownPicture.h"

#include <QPainter>

#include <cmath>

namespace taa::app {

int Viewport::dividerColumn() const {
  return static_cast<int>(std::lround(wipePosition(divider_, width()) * devicePixelRatioF()));
}

bool Viewport::isPictureComplete() const {
  if (!isResultOfContent() || result_->picture.width == 0) return false;
  const bool needsOther = other_ && (showing_ == Showing::Other || showing_ == Showing::Wipe);
  if (!needsOther) return true;
  return result_->other && !kept_ && result_->request.other && result_->request.other->id == other_->row.id &&
         result_->other->picture.width == result_->picture.width;
}

// The bytes of the sides, whatever is painted on them: see-through where there is no picture.
Picture Viewport::sidesPicture() const {
  if (!isPictureComplete()) return {};
  if (!other_ || showing_ == Showing::First || showing_ == Showing::Difference) return result_->picture;
  if (showing_ == Showing::Other) return result_->other->picture;
  return wiped(result_->picture, result_->other->picture, dividerColumn());
}

QImage Viewport::picture(bool withLegend) const {
  const Picture sides = sidesPicture();
  if (sides.width == 0) return {};
  const QImage shown(sides.rgba.data(), sides.width, sides.height, 4 * sides.width, QImage::Format_RGBA8888);
  if (!withLegend) return shown.copy();
  const double ratio = devicePixelRatioF();
  const Showing now = other_ ? showing_ : Showing::First;
  const LegendFlow flow = legend(now);
  const int strips = flow.lines(width()) * kLegendHeight;
  // Of the format that the window is painted in: texts are then mixed with the picture to the same bits.
  QImage image(sides.width, sides.height + static_cast<int>(std::lround(strips * ratio)),
               QImage::Format_ARGB32_Premultiplied);
  image.fill(themeColors(this).panel);
  QPainter painter(&image);
  painter.setCompositionMode(QPainter::CompositionMode_Source);
  painter.drawImage(0, 0, shown);
  painter.end();
  image.setDevicePixelRatio(ratio);
  painter.begin(&image);
  painter.setRenderHint(QPainter::TextAntialiasing);
  const int height = static_cast<int>(sides.height / ratio);
  painter.setClipRect(QRectF(0, 0, sides.width / ratio, sides.height / ratio));
  paintOver(painter, now);
  painter.setClipping(false);
  flow.paint(painter, {0, height}, static_cast<int>(std::ceil(sides.width / ratio)), themeColors(this));
  painter.end();
  return image.convertToFormat(QImage::Format_RGBA8888);
}

} // namespace taa::app
