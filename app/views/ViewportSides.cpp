// Both sides of a view: what of them is shown, where the divider lies, and who is who.
#include "app/views/Viewport.h"

#include "app/Theme.h"
#include "app/views/Legend.h"
#include "app/views/PixelOverlay.h"
#include "app/views/ReferenceNote.h"
#include "app/views/Wipe.h"

#include <QPainter>

#include <cmath>

namespace taa::app {

namespace {

QImage imageOf(const Picture& picture) {
  const QImage raw(picture.rgba.data(), picture.width, picture.height, picture.width * 4,
                   QImage::Format_RGBA8888);
  return raw.convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

std::optional<std::vector<float>> valueOf(const Image& values, const gl::Rect& region, glm::ivec2 pixel) {
  const glm::ivec2 at = pixel - glm::ivec2(region.x, region.y);
  if (at.x < 0 || at.y < 0 || at.x >= values.width || at.y >= values.height) return {};
  const float* first = values.at(at.x, at.y);
  return std::vector<float>(first, first + values.channels);
}

} // namespace

void Viewport::setResult(const ViewResult& result) {
  result_ = result;
  image_ = imageOf(result.picture);
  otherImage_ = result.other ? imageOf(result.other->picture) : QImage();
  update();
  if (hovered_) Q_EMIT hoverChanged();
}

void Viewport::setOther(const std::optional<ViewContent>& other) {
  other_ = other;
  update();
}

void Viewport::setShowing(Showing showing) {
  showing_ = showing;
  update();
}

void Viewport::setPeeking(bool peeking) {
  if (peeking == peeks_) return;
  peeks_ = peeking;
  update();
}

void Viewport::setShowsGrid(bool shows) {
  showsGrid_ = shows;
  update();
}

void Viewport::setDivider(double share) {
  share = wipeShare(share, 1);
  if (share == divider_) return;
  divider_ = share;
  update();
  Q_EMIT dividerMoved();
}

Showing Viewport::shown() const {
  if (!other_) return Showing::First;
  if (!peeks_) return showing_;
  return showing_ == Showing::Other ? Showing::First : Showing::Other;
}

bool Viewport::isOnDivider(QPointF position) const {
  return shown() == Showing::Wipe && std::abs(position.x() - wipePosition(divider_, width())) <= kWipeReach;
}

// Whether values and picture are of the row or difference that is spoken of.
bool Viewport::isResultOfContent() const {
  return result_ && result_->request.id == content_.row.id &&
         result_->request.asDifference == (other_ && showing_ == Showing::Difference);
}

std::optional<std::vector<float>> Viewport::valueAt(glm::ivec2 pixel) const {
  if (!isResultOfContent()) return {};
  return valueOf(result_->values, result_->region, pixel);
}

std::optional<std::vector<float>> Viewport::otherValueAt(glm::ivec2 pixel) const {
  if (!other_ || !result_ || !result_->other || !result_->request.other) return {};
  if (result_->request.other->id != other_->row.id) return {};
  return valueOf(result_->other->values, result_->region, pixel);
}

QString Viewport::label(bool other) const {
  const QString& text = other && other_ ? other_->text : content_.text;
  if (!result_ || (other && !result_->other)) return tr("%1 · on its way").arg(text);
  const int frame = other ? result_->other->frame : result_->frame;
  const bool exact = other ? result_->other->exact : result_->exact;
  const QString framed = tr("%1 · frame %2").arg(text).arg(frame);
  return exact ? framed : tr("%1 · not exact yet").arg(framed);
}

// One side with its grid and values, cut to a part of the widget.
void Viewport::paintSide(QPainter& painter, bool other, const QRect& part) const {
  const QImage& image = other ? otherImage_ : image_;
  painter.setClipRect(part);
  if (!image.isNull() && result_) {
    const ScreenRect place =
        movedPicture(result_->request.transform, {image.width(), image.height()}, transform());
    const double ratio = devicePixelRatioF();
    painter.drawImage(QRectF(place.x / ratio, place.y / ratio, place.width / ratio, place.height / ratio),
                      image);
  }
  const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
  if (size_.x > 0 && showsGrid_ && overlay.texelSize() >= kGridZoom) overlay.paintGrid(painter);
  if (showsValues() && other && result_ && result_->other)
    overlay.paintValues(painter, other_->row, result_->other->values, result_->region);
  else if (showsValues() && !other && isResultOfContent())
    overlay.paintValues(painter, content_.row, result_->values, result_->region);
  painter.setClipping(false);
}

void Viewport::paintSides(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const Showing now = shown();
  const int line = now == Showing::Wipe ? wipePosition(divider_, width()) : width();
  if (now == Showing::Other)
    paintSide(painter, true, rect());
  else
    paintSide(painter, false, QRect(0, 0, line, height()));
  if (!other_) return;
  if (now == Showing::Wipe) {
    paintSide(painter, true, QRect(line, 0, width() - line, height()));
    paintWipe(painter, rect(), line);
    const QRect half(0, 0, width() / 2, height());
    paintSideLabel(painter, half, label(false), false, colors);
    paintSideLabel(painter, half.translated(width() - half.width(), 0), label(true), true, colors);
  } else if (now == Showing::Difference) {
    paintSideLabel(painter, rect(), tr("%1  −  %2").arg(label(false), label(true)), false, colors);
  } else {
    paintSideLabel(painter, rect(), label(now == Showing::Other), now == Showing::Other, colors);
  }
}

void Viewport::paintLegends(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const bool onlyOther = shown() == Showing::Other;
  const ViewContent& main = onlyOther ? *other_ : content_;
  const bool isDifference = shown() == Showing::Difference;
  int lines = 1 + overlayLegendLines(main.row, main.style);
  // Where another row is beside it, that has a line of its own.
  const bool hasSecond = shown() == Showing::Wipe && (other_->row.id != main.row.id);
  if (hasSecond) ++lines;
  QRect strip(0, height() - kLegendHeight, width(), kLegendHeight);
  if (!marks_.empty() && marks_.back().isActive) {
    // The strip gives way to the picked pixel.
    const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
    const ScreenRect cell = overlay.pixelRect(marks_.back().pixel);
    const int top = height() - lines * kLegendHeight;
    if (cell.y + cell.height > top - 2 * kUnit && cell.y < height()) {
      const int labels = other_ ? 7 * kUnit : 0;
      strip.moveTop(labels + (lines - 1) * kLegendHeight);
    }
  }
  const bool isOfResult = result_ && result_->request.id == main.row.id;
  paintLegend(painter, strip, main.row, main.style, isDifference, colors,
              isOfResult ? referenceNote(*result_) : QString());
  if (hasSecond) {
    strip.translate(0, -kLegendHeight);
    paintLegend(painter, strip, other_->row, other_->style, false, colors);
  }
  strip.translate(0, -kLegendHeight);
  paintOverlayLegend(painter, strip, main.row, main.style, colors);
}

} // namespace taa::app
