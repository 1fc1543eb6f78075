// Both sides of a view: what of them is shown, where the divider lies, and who is who.
#include "app/views/Viewport.h"

#include "app/style/Theme.h"
#include "app/views/PixelOverlay.h"
#include "app/views/Wipe.h"
#include "app/views/legend/Legend.h"
#include "app/views/legend/ReferenceNote.h"

#include <QPainter>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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

// While time goes on, or another pair is on its way, the other side that was there last stays.
void Viewport::setResult(std::shared_ptr<const ViewResult> result) {
  const std::shared_ptr<const ViewResult> before = kept_ ? kept_ : result_;
  const bool keeps = !result->other && before && before->other && result->request.other &&
                     result->request.other == before->request.other &&
                     result->request.transform == before->request.transform &&
                     result->picture.width == before->other->picture.width;
  kept_ = keeps ? before : nullptr;
  result_ = std::move(result);
  image_ = imageOf(result_->picture);
  if (!keeps) otherImage_ = result_->other ? imageOf(result_->other->picture) : QImage();
  update();
  if (hovered_) Q_EMIT hoverChanged();
}

const ViewSide* Viewport::otherSide() const {
  const ViewResult* holder = kept_ ? kept_.get() : result_.get();
  return holder && holder->other ? &*holder->other : nullptr;
}

void Viewport::setPlaying(bool playing) {
  if (playing == playing_) return;
  playing_ = playing;
  update();
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
  if (!other_ || !otherSide() || !result_->request.other) return {};
  if (result_->request.other->id != other_->row.id) return {};
  return valueOf(otherSide()->values, (kept_ ? kept_ : result_)->region, pixel);
}

bool Viewport::isBesideAnotherFrame() const {
  return result_ && result_->request.other && result_->request.other->isOfAnotherFrame();
}

// With why it is not there, or not of now, and what helps.
QString Viewport::label(bool other) const {
  const QString& text = other && other_ ? other_->text : content_.text;
  if (!result_ || (other && !otherSide())) {
    if (other && isBesideAnotherFrame() && isOfReference(other_->row.id))
      return tr("%1 · only the frame on show has a reference: go to that frame to see its own").arg(text);
    if (other && isBesideAnotherFrame() && playing_) return tr("%1 · comes when it is paused").arg(text);
    return tr("%1 · on its way").arg(text);
  }
  const int frame = other ? otherSide()->frame : result_->frame;
  const bool exact = other ? otherSide()->exact : result_->exact;
  const QString framed = tr("%1 · frame %2").arg(text).arg(frame);
  const bool waits = playing_ && (kept_ || result_->request.asDifference) && isBesideAnotherFrame();
  if (other && waits) return tr("%1 · stays until it is paused").arg(framed);
  return exact ? framed : tr("%1 · not exact yet").arg(framed);
}

std::vector<Viewport::SidePart> Viewport::parts(Showing showing) const {
  if (showing == Showing::Other) return {{true, rect()}};
  if (showing != Showing::Wipe) return {{false, rect()}};
  const int line = wipePosition(divider_, width());
  return {{false, QRect(0, 0, line, height())}, {true, QRect(line, 0, width() - line, height())}};
}

void Viewport::paintSide(QPainter& painter, const SidePart& side) const {
  const QImage& image = side.other ? otherImage_ : image_;
  if (image.isNull() || !result_) return;
  const ScreenRect place =
      movedPicture(result_->request.transform, {image.width(), image.height()}, transform());
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
  if (showsValues() && side.other && otherSide())
    overlay.paintValues(painter, other_->row, otherSide()->values, (kept_ ? kept_ : result_)->region);
  else if (showsValues() && !side.other && isResultOfContent())
    overlay.paintValues(painter, content_.row, result_->values, result_->region);
  painter.setClipping(false);
}

void Viewport::paintLabels(QPainter& painter, Showing showing) const {
  if (!other_) return;
  const ThemeColors& colors = themeColors(this);
  if (showing == Showing::Wipe) {
    paintWipe(painter, rect(), wipePosition(divider_, width()));
    const QRect half(0, 0, width() / 2, height());
    paintSideLabel(painter, half, label(false), false, colors);
    paintSideLabel(painter, half.translated(width() - half.width(), 0), label(true), true, colors);
  } else if (showing == Showing::Difference) {
    paintSideLabel(painter, rect(), tr("%1  −  %2").arg(label(false), label(true)), false, colors);
  } else {
    const bool isOther = showing == Showing::Other;
    paintSideLabel(painter, rect(), label(isOther), isOther, colors);
  }
}

void Viewport::paintOver(QPainter& painter, Showing showing) const {
  for (const SidePart& side : parts(showing)) paintGridAndValues(painter, side);
  paintLabels(painter, showing);
  const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
  for (const PinMark& mark : marks_) overlay.paintPin(painter, mark);
}

// From the top: what lies over the picture, the other side where it is another row, this side. Folded: a sign
// for the first.
LegendFlow Viewport::legend(Showing showing, bool isFolded) const {
  const ThemeColors& colors = themeColors(this);
  const bool onlyOther = showing == Showing::Other;
  const auto subjectOf = [&](bool other) {
    const ViewContent& content = other ? *other_ : content_;
    LegendSubject subject{content.row, content.style, !other && showing == Showing::Difference, {}};
    const bool isOfOther =
        other && otherSide() && result_->request.other && result_->request.other->id == content.row.id;
    const bool isOfResult = !other && isResultOfContent();
    if (isOfResult && totalOf(result_->reasons) > 0) subject.reasons = &result_->reasons;
    if (isOfOther && totalOf(otherSide()->reasons) > 0) subject.reasons = &otherSide()->reasons;
    if (isOfResult) subject.note = referenceNote(*result_);
    subject.space = content.space;
    return subject;
  };
  const LegendSubject main = subjectOf(onlyOther);
  LegendFlow flow;
  const ReasonCounts* beside = nullptr;
  if (showing == Showing::Wipe) beside = subjectOf(true).reasons;
  if (beside && main.reasons && *beside == *main.reasons) beside = nullptr;
  if (!isFolded) addOverlayLegend(flow, main, beside, transform(), colors);
  if (showing == Showing::Wipe && other_->row.id != main.row.id) addRowLegend(flow, subjectOf(true), colors);
  addRowLegend(flow, main, colors);
  if (isFolded) flow.text(tr("⋯ overlays"), secondaryFont(), colors.accent);
  return flow;
}

// At the lower edge; it gives way to the picked pixel.
int Viewport::legendTop(int height) const {
  const int top = this->height() - height;
  if (marks_.empty() || !marks_.back().isActive) return top;
  const PixelOverlay overlay(viewGeometry(), transform(), devicePixelRatioF());
  const ScreenRect cell = overlay.pixelRect(marks_.back().pixel);
  const bool isBelow = cell.y + cell.height > top - 2 * kUnit && cell.y < this->height();
  return isBelow ? (other_ ? 7 * kUnit : 0) : top;
}

// Unfolded it stays at the edge where it was folded, under the mouse.
ShownLegend Viewport::shownLegend() const {
  constexpr int kShare = 6; // of the height is what a legend of more than a line may cover
  LegendFlow whole = legend(shown());
  const int height = whole.lines(width()) * kLegendHeight;
  if (!isLegendWhole_ && height * kShare > this->height()) {
    LegendFlow folded = legend(shown(), true);
    const int least = folded.lines(width()) * kLegendHeight, top = legendTop(least);
    const QRect sign = folded.lastPlace(width()).translated(0, top);
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

} // namespace taa::app
