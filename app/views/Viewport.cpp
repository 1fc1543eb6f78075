#include "app/views/Viewport.h"

#include "app/style/PictureImage.h"
#include "app/style/TextSize.h"
#include "app/style/Theme.h"
#include "app/views/PixelOverlay.h"
#include "app/views/Wipe.h"
#include "app/views/legend/Legend.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::app {

namespace {
constexpr int kLegendWidth = 320; ///< of a picture for a file at least, where the view is as wide: logical px
} // namespace

Viewport::Viewport(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setCursor(Qt::CrossCursor);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(80, 60);
  setProperty(kKeepsLimits, true);
}

ViewGeometry Viewport::viewGeometry() const {
  const double ratio = devicePixelRatioF();
  return {{static_cast<int>(std::lround(width() * ratio)), static_cast<int>(std::lround(height() * ratio))},
          size_,
          static_cast<int>(std::lround(legendHeight() * ratio))};
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
  sides_.setContent(content);
  update();
}

void Viewport::setMarks(const std::vector<ProbeMark>& marks) {
  if (marks == marks_) return;
  marks_ = marks;
  update();
}

void Viewport::setFramed(const std::optional<gl::Rect>& box) {
  if (box == framed_) return;
  framed_ = box;
  update();
}

void Viewport::setOutlines(const std::vector<doctor::OutlineEdge>& edges) {
  if (edges == outlines_) return;
  outlines_ = edges;
  update();
}

void Viewport::setMeasured(const std::optional<gl::Rect>& region) {
  if (region == measured_) return;
  measured_ = region;
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
  paintOver(painter, shown(), rect());
  const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
  if (framed_) overlay.paintFrame(painter, *framed_);
  overlay.paintOutline(painter, outlines_);
  if (measured_) overlay.paintRegion(painter, *measured_, darkColors().accent);
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
      Q_EMIT otherProbed(pixel);
    else
      Q_EMIT probed(pixel);
  } else if (!dragsDivider_ && drag_ == Qt::LeftButton && size_.x > 0 &&
             event->modifiers().testFlag(Qt::ControlModifier)) {
    regionFrom_ = viewGeometry().nearestPixel(transform(), deviceFrom(cursor_));
    Q_EMIT regionDragged({});
  } else if (!dragsDivider_ && (drag_ == Qt::LeftButton || drag_ == Qt::MiddleButton))
    setCursor(Qt::ClosedHandCursor);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  const glm::dvec2 moved = deviceFrom(event->position() - cursor_);
  cursor_ = event->position();
  if (drag_ == Qt::RightButton && size_.x > 0)
    Q_EMIT probed(viewGeometry().nearestPixel(transform(), deviceFrom(cursor_)));
  else if (regionFrom_)
    dragRegion(viewGeometry().nearestPixel(transform(), deviceFrom(cursor_)));
  else if (dragsDivider_)
    setDivider(wipeShare(cursor_.x(), width()));
  else if (drag_ == Qt::LeftButton || drag_ == Qt::MiddleButton)
    moveCamera(viewGeometry().panned(camera_, moved));
  if (drag_ == Qt::NoButton) setCursor(isOnDivider(cursor_) ? Qt::SplitHCursor : Qt::CrossCursor);
  openLegend(drag_ == Qt::NoButton);
  setHovered(viewGeometry().pixelAt(transform(), deviceFrom(cursor_)));
}

// A press that stays on its pixel is a click.
void Viewport::dragRegion(glm::ivec2 pixel) {
  if (measured_ || pixel != *regionFrom_) Q_EMIT regionDragged(regionBetween(*regionFrom_, pixel));
}

void Viewport::mouseReleaseEvent(QMouseEvent*) {
  drag_ = Qt::NoButton;
  dragsDivider_ = false;
  regionFrom_.reset();
  setCursor(isOnDivider(cursor_) ? Qt::SplitHCursor : Qt::CrossCursor);
}

// Probe, divider and region are the undo stack's.
void Viewport::cancelDrag() {
  if (!dragsDivider_ && !regionFrom_ && (drag_ == Qt::LeftButton || drag_ == Qt::MiddleButton))
    moveCamera(pressCamera_);
  drag_ = Qt::NoButton;
  dragsDivider_ = false;
  regionFrom_.reset();
  setCursor(Qt::CrossCursor);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && isOnDivider(event->position()))
    setDivider(0.5);
  else if (event->button() == Qt::LeftButton)
    Q_EMIT doubleClicked();
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
    Q_EMIT probeMoved(-step, 0);
    return;
  case Qt::Key_Right:
    Q_EMIT probeMoved(step, 0);
    return;
  case Qt::Key_Up:
    Q_EMIT probeMoved(0, -step);
    return;
  case Qt::Key_Down:
    Q_EMIT probeMoved(0, step);
    return;
  default:
    QWidget::keyPressEvent(event);
  }
}

void Viewport::focusInEvent(QFocusEvent*) {
  Q_EMIT activated();
}

void Viewport::setResult(std::shared_ptr<const ViewResult> result) {
  sides_.setResult(std::move(result));
  update();
  if (hovered_) Q_EMIT hoverChanged();
}

void Viewport::setPlaying(bool playing) {
  if (playing == sides_.isPlaying()) return;
  sides_.setPlaying(playing);
  update();
}

void Viewport::setOther(const std::optional<ViewContent>& other) {
  sides_.setOther(other);
  update();
}

void Viewport::setShowing(Showing showing) {
  sides_.setShowing(showing);
  update();
}

void Viewport::setPeeking(bool peeking) {
  if (peeking == sides_.isPeeking()) return;
  sides_.setPeeking(peeking);
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

bool Viewport::isOnDivider(QPointF position) const {
  return shown() == Showing::Wipe && std::abs(position.x() - wipePosition(divider_, width())) <= kWipeReach;
}

std::vector<Viewport::SidePart> Viewport::parts(Showing showing) const {
  if (showing == Showing::Other) return {{true, rect()}};
  if (showing != Showing::Wipe) return {{false, rect()}};
  const int line = wipePosition(divider_, width());
  return {{false, QRect(0, 0, line, height())}, {true, QRect(line, 0, width() - line, height())}};
}

void Viewport::paintSide(QPainter& painter, const SidePart& side) const {
  const QImage& image = sides_.image(side.other);
  if (image.isNull() || !result()) return;
  const ScreenRect place =
      movedPicture(result()->request.transform, {image.width(), image.height()}, transform());
  const double ratio = devicePixelRatioF();
  painter.setClipRect(side.part);
  painter.drawImage(QRectF(place.x / ratio, place.y / ratio, place.width / ratio, place.height / ratio),
                    image);
  painter.setClipping(false);
}

void Viewport::paintGridAndValues(QPainter& painter, const SidePart& side) const {
  painter.setClipRect(side.part);
  const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
  if (size_.x > 0 && showsGrid_ && overlay.texelSize() >= kGridZoom) overlay.paintGrid(painter);
  if (showsValues() && side.other && sides_.otherSide())
    overlay.paintValues(painter, otherContent()->row,
                        {sides_.otherSide()->values, sides_.otherSide()->absence}, sides_.otherRegion());
  else if (showsValues() && !side.other && sides_.isResultOfContent())
    overlay.paintValues(painter, shownContent().row, {result()->values, result()->absence}, result()->region);
  painter.setClipping(false);
}

void Viewport::paintLabels(QPainter& painter, Showing showing, const QRect& area) const {
  if (!otherContent()) return;
  const ThemeColors& colors = themeColors(this);
  if (showing == Showing::Wipe) {
    paintWipe(painter, rect(), wipePosition(divider_, width()));
    const QRect half(area.left(), area.top(), area.width() / 2, area.height());
    const SideTexts texts =
        fittingTexts({label(false), label(true)}, QFontMetrics(secondaryFont()), half.width() - 4 * kUnit);
    paintSideLabel(painter, half, texts.first, false, colors);
    paintSideLabel(painter, half.translated(area.width() - half.width(), 0), texts.other, true, colors);
  } else if (showing == Showing::Difference) {
    paintSideLabel(painter, area, tr("%1  −  %2").arg(label(false), label(true)), false, colors);
  } else {
    const bool isOther = showing == Showing::Other;
    paintSideLabel(painter, area, label(isOther), isOther, colors);
  }
}

void Viewport::paintOver(QPainter& painter, Showing showing, const QRect& area) const {
  for (const SidePart& side : parts(showing)) paintGridAndValues(painter, side);
  paintLabels(painter, showing, area);
  const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
  overlay.paintPath(painter, path_);
  for (const ProbeMark& mark : marks_) overlay.paintProbe(painter, mark);
}

LegendFlow Viewport::legend(Showing showing, LegendFold fold) const {
  return sides_.legend(showing, fold, transform(), themeColors(this));
}

// At the lower edge; it gives way to the probed pixel.
int Viewport::legendTop(int height) const {
  const int top = this->height() - height;
  if (marks_.empty() || !marks_.back().isActive) return top;
  const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
  const ScreenRect cell = overlay.pixelRect(marks_.back().pixel);
  const bool isBelow = cell.y + cell.height > top - 2 * kUnit && cell.y < this->height();
  return isBelow ? (otherContent() ? 7 * kUnit : 0) : top;
}

// Unfolded it stays at the edge where it was folded, under the mouse.
ShownLegend Viewport::shownLegend() const {
  constexpr int kShare = 6;       // of the height is what a legend of more than a line may cover
  constexpr double kMostOf = 0.4; // of the height, that one without overlays may cover
  LegendFlow whole = legend(shown());
  const int height = whole.lines(width()) * legendHeight();
  if (!isLegendWhole_ && height * kShare > this->height()) {
    LegendFlow folded = legend(shown(), LegendFold::Overlays);
    const bool isShort = folded.lines(width()) * legendHeight() > kMostOf * this->height();
    if (isShort) folded = legend(shown(), LegendFold::AllButName);
    const int least = folded.lines(width()) * legendHeight(), top = legendTop(least);
    const QRect sign = isShort ? QRect(0, top, width(), least) : folded.lastPlace(width()).translated(0, top);
    if (least < height && !isLegendOpen_) return {std::move(folded), {0, top, width(), least}, sign};
    if (least < height) {
      const bool isAtBottom = top + least == this->height();
      return {std::move(whole), {0, isAtBottom ? this->height() - height : top, width(), height}, sign};
    }
  }
  return {std::move(whole), {0, legendTop(height), width(), height}, {}};
}

void Viewport::paintLegend(QPainter& painter) const {
  const ShownLegend legend = shownLegend();
  legend.flow.paint(painter, legend.place.topLeft(), width(), themeColors(this));
}

void Viewport::setLegendWhole(bool whole) {
  isLegendWhole_ = whole;
  isLegendOpen_ = false;
  update();
}

// On its sign, and for as long as the mouse stays on what was unfolded.
void Viewport::openLegend(bool mayOpen) {
  const ShownLegend legend = shownLegend();
  const bool isOn = (isLegendOpen_ ? legend.place : legend.sign).contains(cursor_.toPoint());
  const bool opens = mayOpen && !legend.sign.isEmpty() && isOn;
  if (opens == isLegendOpen_) return;
  isLegendOpen_ = opens;
  update();
}

int Viewport::dividerColumn() const {
  return static_cast<int>(std::lround(wipePosition(divider_, width()) * devicePixelRatioF()));
}

QRect Viewport::pictureRect() const {
  if (size_.x == 0) return {};
  const QRect part = shownPart();
  const double ratio = devicePixelRatioF();
  return QRectF(part.x() / ratio, part.y() / ratio, part.width() / ratio, part.height() / ratio).toRect();
}

// All of the viewport where nothing of the picture is in it.
QRect Viewport::shownPart() const {
  const ViewGeometry view = viewGeometry();
  const ViewTransform now = transform();
  // The corner lies on a whole pixel of the screen, but for the rounding of single floats.
  constexpr double kRounding = 0.01;
  const glm::dvec2 low = glm::floor(screenFromPicture(now, {0.0, 0.0}) + kRounding);
  const glm::dvec2 high = glm::ceil(screenFromPicture(now, glm::dvec2(size_)) - kRounding);
  const QRect whole(0, 0, view.viewport.x, view.viewport.y);
  const QRect part = whole & QRect(QPoint(static_cast<int>(low.x), static_cast<int>(low.y)),
                                   QPoint(static_cast<int>(high.x) - 1, static_cast<int>(high.y) - 1));
  return part.isEmpty() ? whole : part;
}

QImage Viewport::picture(bool withLegend) const {
  const Picture sides = sides_.picture(dividerColumn());
  if (sides.width == 0) return {};
  const QRect part = shownPart();
  const QImage shown = imageOver(sides).copy(part);
  if (!withLegend) return shown;
  const double ratio = devicePixelRatioF();
  const Showing now = sides_.showing();
  const LegendFlow flow = legend(now);
  const QRectF area(part.x() / ratio, part.y() / ratio, part.width() / ratio, part.height() / ratio);
  const int wide = std::max(static_cast<int>(std::ceil(area.width())), std::min(kLegendWidth, width()));
  const int strips = flow.lines(wide) * legendHeight();
  // Of the format that the window is painted in: texts are then mixed with the picture to the same bits.
  QImage image(std::max(part.width(), static_cast<int>(std::lround(wide * ratio))),
               part.height() + static_cast<int>(std::lround(strips * ratio)),
               QImage::Format_ARGB32_Premultiplied);
  image.fill(themeColors(this).panel);
  QPainter painter(&image);
  painter.setCompositionMode(QPainter::CompositionMode_Source);
  painter.drawImage(0, 0, shown);
  painter.end();
  image.setDevicePixelRatio(ratio);
  painter.begin(&image);
  painter.setRenderHint(QPainter::TextAntialiasing);
  painter.setClipRect(QRectF(0, 0, area.width(), area.height()));
  painter.translate(-area.topLeft());
  paintOver(painter, now, area.toAlignedRect());
  painter.translate(area.topLeft());
  painter.setClipping(false);
  flow.paint(painter, {0, static_cast<int>(area.height())}, wide, themeColors(this));
  painter.end();
  return image.convertToFormat(QImage::Format_RGBA8888);
}

} // namespace taa::app
