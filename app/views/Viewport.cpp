#include "app/views/Viewport.h"

#include "app/Theme.h"
#include "app/views/Legend.h"
#include "app/views/PixelOverlay.h"
#include "app/views/ReferenceNote.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>

namespace taa::app {

Viewport::Viewport(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setCursor(Qt::CrossCursor);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(80, 60);
}

ViewGeometry Viewport::viewGeometry() const {
  const double ratio = devicePixelRatioF();
  return {{static_cast<int>(std::lround(width() * ratio)), static_cast<int>(std::lround(height() * ratio))},
          size_,
          static_cast<int>(std::lround(kLegendHeight * ratio))};
}

ViewTransform Viewport::transform() const {
  return viewGeometry().transform(camera_);
}

glm::dvec2 Viewport::deviceFrom(QPointF logical) const {
  return glm::dvec2(logical.x(), logical.y()) * devicePixelRatioF();
}

bool Viewport::showsValues() const {
  return zoom() / devicePixelRatioF() >= kValueZoom;
}

void Viewport::setPictureSize(glm::ivec2 size) {
  if (size == size_) return;
  size_ = size;
  update();
  Q_EMIT transformChanged();
}

void Viewport::setContent(IntermediateId id, const ViewStyle& style) {
  id_ = id;
  style_ = style;
  update();
}

void Viewport::setResult(const ViewResult& result) {
  result_ = result;
  const Picture& picture = result.picture;
  const QImage raw(picture.rgba.data(), picture.width, picture.height, picture.width * 4,
                   QImage::Format_RGBA8888);
  image_ = raw.convertToFormat(QImage::Format_ARGB32_Premultiplied);
  result_->picture = {}; // kept as image_
  update();
  if (hovered_) Q_EMIT hoverChanged();
}

void Viewport::setPick(std::optional<glm::ivec2> pixel) {
  if (pixel == pick_) return;
  pick_ = pixel;
  update();
}

void Viewport::setCamera(const ViewCamera& camera) {
  if (camera == camera_) return;
  camera_ = camera;
  update();
  Q_EMIT transformChanged();
}

void Viewport::moveCamera(const ViewCamera& camera) {
  if (camera == camera_) return;
  setCamera(camera);
  Q_EMIT cameraChanged(camera_);
}

void Viewport::fit() {
  moveCamera({});
}

void Viewport::oneToOne() {
  const ViewGeometry view = viewGeometry();
  moveCamera(view.oneToOne(camera_, underMouse() ? deviceFrom(cursor_) : glm::dvec2(view.viewport) / 2.0));
}

void Viewport::zoomBy(double notches) {
  const ViewGeometry view = viewGeometry();
  const glm::dvec2 held = underMouse() ? deviceFrom(cursor_) : glm::dvec2(view.viewport) / 2.0;
  moveCamera(view.zoomed(camera_, held, wheelFactor(notches)));
}

void Viewport::reveal(glm::ivec2 pixel) {
  if (!camera_.fit) moveCamera(viewGeometry().revealed(camera_, pixel));
}

std::optional<std::vector<float>> Viewport::valueAt(glm::ivec2 pixel) const {
  if (!result_ || result_->values.empty() || result_->request.id != id_) return {};
  const glm::ivec2 at = pixel - glm::ivec2(result_->region.x, result_->region.y);
  const Image& values = result_->values;
  if (at.x < 0 || at.y < 0 || at.x >= values.width || at.y >= values.height) return {};
  const float* first = values.at(at.x, at.y);
  return std::vector<float>(first, first + values.channels);
}

void Viewport::setHovered(std::optional<glm::ivec2> pixel) {
  if (pixel == hovered_) return;
  hovered_ = pixel;
  Q_EMIT hoverChanged();
}

void Viewport::paintPicture(QPainter& painter) const {
  if (image_.isNull() || !result_) return;
  const ScreenRect place =
      movedPicture(result_->request.transform, {image_.width(), image_.height()}, transform());
  const double ratio = devicePixelRatioF();
  painter.drawImage(QRectF(place.x / ratio, place.y / ratio, place.width / ratio, place.height / ratio),
                    image_);
}

void Viewport::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.surround);
  paintPicture(painter);
  const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
  if (size_.x > 0 && overlay.texelSize() >= kGridZoom) overlay.paintGrid(painter);
  if (result_ && result_->request.id == id_ && showsValues()) overlay.paintValues(painter, *result_);
  if (pick_) overlay.paintPick(painter, *pick_);

  QRect strip(0, height() - kLegendHeight, width(), kLegendHeight);
  if (pick_) {
    // The strip gives way to the picked pixel.
    const ScreenRect cell = overlay.pixelRect(*pick_);
    if (cell.y + cell.height > strip.top() - 2 * kUnit && cell.y < height()) strip.moveTop(0);
  }
  const bool isOfResult = result_ && result_->request.id == id_;
  paintLegend(painter, strip, intermediate(id_), style_, colors,
              isOfResult ? referenceNote(*result_) : QString());
}

void Viewport::resizeEvent(QResizeEvent*) {
  Q_EMIT transformChanged();
}

void Viewport::wheelEvent(QWheelEvent* event) {
  cursor_ = event->position();
  const int delta = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
  moveCamera(viewGeometry().zoomed(camera_, deviceFrom(cursor_), wheelFactor(delta / 120.0)));
  setHovered(viewGeometry().pixelAt(transform(), deviceFrom(cursor_)));
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  cursor_ = event->position();
  drag_ = event->button();
  Q_EMIT activated();
  if (drag_ == Qt::RightButton && size_.x > 0)
    Q_EMIT picked(viewGeometry().nearestPixel(transform(), deviceFrom(cursor_)));
  else if (drag_ == Qt::LeftButton || drag_ == Qt::MiddleButton)
    setCursor(Qt::ClosedHandCursor);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  const glm::dvec2 moved = deviceFrom(event->position() - cursor_);
  cursor_ = event->position();
  if (drag_ == Qt::RightButton && size_.x > 0)
    Q_EMIT picked(viewGeometry().nearestPixel(transform(), deviceFrom(cursor_)));
  else if (drag_ == Qt::LeftButton || drag_ == Qt::MiddleButton)
    moveCamera(viewGeometry().panned(camera_, moved));
  setHovered(viewGeometry().pixelAt(transform(), deviceFrom(cursor_)));
}

void Viewport::mouseReleaseEvent(QMouseEvent*) {
  drag_ = Qt::NoButton;
  setCursor(Qt::CrossCursor);
}

void Viewport::leaveEvent(QEvent*) {
  setHovered({});
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  const int step = event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1;
  switch (event->key()) {
  case Qt::Key_Left:
    Q_EMIT pickMoved(-step, 0);
    return;
  case Qt::Key_Right:
    Q_EMIT pickMoved(step, 0);
    return;
  case Qt::Key_Up:
    Q_EMIT pickMoved(0, -step);
    return;
  case Qt::Key_Down:
    Q_EMIT pickMoved(0, step);
    return;
  default:
    QWidget::keyPressEvent(event);
  }
}

void Viewport::focusInEvent(QFocusEvent*) {
  Q_EMIT activated();
}

} // namespace taa::app
