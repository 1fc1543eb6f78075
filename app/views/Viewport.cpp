#include "app/views/Viewport.h"

#include "app/style/Theme.h"
#include "app/views/PixelOverlay.h"
#include "app/views/Wipe.h"
#include "app/views/legend/Legend.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>

namespace taa::app {

Viewport::Viewport(QWidget* parent)
    : QWidget(parent), content_{intermediate(IntermediateId::resolved), {}, {}} {
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
  ViewTransform transform = viewGeometry().transform(camera_);
  transform.scale = static_cast<float>(devicePixelRatioF());
  return transform;
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

void Viewport::setContent(const ViewContent& content) {
  content_ = content;
  update();
}

void Viewport::setMarks(const std::vector<PinMark>& marks) {
  if (marks == marks_) return;
  marks_ = marks;
  update();
}

void Viewport::setFramed(const std::optional<gl::Rect>& box) {
  if (box == framed_) return;
  framed_ = box;
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

void Viewport::setHovered(std::optional<glm::ivec2> pixel) {
  if (pixel == hovered_) return;
  hovered_ = pixel;
  Q_EMIT hoverChanged();
}

void Viewport::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), themeColors(this).surround);
  for (const SidePart& side : parts(shown())) paintSide(painter, side);
  paintOver(painter, shown());
  const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
  if (framed_) overlay.paintFrame(painter, *framed_);
  paintLegend(painter);
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
  pressCamera_ = camera_;
  Q_EMIT activated();
  dragsDivider_ = drag_ == Qt::LeftButton && isOnDivider(cursor_);
  if (drag_ == Qt::RightButton && size_.x > 0) {
    const glm::ivec2 pixel = viewGeometry().nearestPixel(transform(), deviceFrom(cursor_));
    if (event->modifiers().testFlag(Qt::ShiftModifier))
      Q_EMIT pinned(pixel);
    else
      Q_EMIT picked(pixel);
  } else if (!dragsDivider_ && (drag_ == Qt::LeftButton || drag_ == Qt::MiddleButton))
    setCursor(Qt::ClosedHandCursor);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  const glm::dvec2 moved = deviceFrom(event->position() - cursor_);
  cursor_ = event->position();
  if (drag_ == Qt::RightButton && size_.x > 0)
    Q_EMIT picked(viewGeometry().nearestPixel(transform(), deviceFrom(cursor_)));
  else if (dragsDivider_)
    setDivider(wipeShare(cursor_.x(), width()));
  else if (drag_ == Qt::LeftButton || drag_ == Qt::MiddleButton)
    moveCamera(viewGeometry().panned(camera_, moved));
  if (drag_ == Qt::NoButton) setCursor(isOnDivider(cursor_) ? Qt::SplitHCursor : Qt::CrossCursor);
  openLegend(drag_ == Qt::NoButton);
  setHovered(viewGeometry().pixelAt(transform(), deviceFrom(cursor_)));
}

void Viewport::mouseReleaseEvent(QMouseEvent*) {
  drag_ = Qt::NoButton;
  dragsDivider_ = false;
  setCursor(isOnDivider(cursor_) ? Qt::SplitHCursor : Qt::CrossCursor);
}

// Probe and divider are the undo stack's.
void Viewport::cancelDrag() {
  if (!dragsDivider_ && (drag_ == Qt::LeftButton || drag_ == Qt::MiddleButton)) moveCamera(pressCamera_);
  drag_ = Qt::NoButton;
  dragsDivider_ = false;
  setCursor(Qt::CrossCursor);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && isOnDivider(event->position()))
    setDivider(0.5);
  else
    mousePressEvent(event);
}

void Viewport::leaveEvent(QEvent*) {
  openLegend(false);
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
