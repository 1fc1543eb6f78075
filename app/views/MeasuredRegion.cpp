#include "app/views/MeasuredRegion.h"

#include "app/views/Viewport.h"

#include <QApplication>
#include <QClipboard>

#include <algorithm>

namespace taa::app {

MeasuredRegion::MeasuredRegion(Viewport& viewport, QObject* parent)
    : QObject(parent), viewport_(viewport), card_(new RegionCard(&viewport)) {
  card_->hide();
  connect(&viewport_, &Viewport::regionDragged, this, &MeasuredRegion::set);
  connect(&viewport_, &Viewport::transformChanged, card_, &RegionCard::place);
  connect(card_, &RegionCard::removeRequested, this, [this] { set({}); });
  connect(card_, &RegionCard::copyRequested, this, &MeasuredRegion::copy);
}

void MeasuredRegion::set(const std::optional<gl::Rect>& region) {
  if (region == region_) return;
  region_ = region;
  viewport_.setMeasured(region);
  if (region && !card_->isVisibleTo(&viewport_)) card_->setWaiting(*region);
  card_->setVisible(region.has_value());
  Q_EMIT changed();
}

void MeasuredRegion::setToVisible() {
  const gl::Rect seen = viewport_.viewGeometry().visiblePixels(viewport_.transform());
  if (seen.width > 0 && seen.height > 0) set(seen);
}

void MeasuredRegion::setResult(const ViewResult& result, const std::optional<MeasuredContent>& content) {
  if (!region_ || result.request.measured != region_) return; // of another one: that there is, is on its way
  if (content && result.spread)
    card_->setSpread(*content, *result.spread);
  else
    card_->setWaiting(*region_);
}

void MeasuredRegion::copy() const {
  if (const QString text = card_->exactText(); !text.isEmpty()) QApplication::clipboard()->setText(text);
}

QJsonArray MeasuredRegion::state() const {
  return region_ ? QJsonArray{region_->x, region_->y, region_->width, region_->height} : QJsonArray();
}

void MeasuredRegion::setState(const QJsonArray& state) {
  constexpr int kMaxEdge = 65536; // more than any picture has
  const auto numberAt = [&](int index) { return std::clamp(state.at(index).toInt(), 0, kMaxEdge); };
  const gl::Rect region{numberAt(0), numberAt(1), numberAt(2), numberAt(3)};
  set(region.width > 0 && region.height > 0 ? std::optional(region) : std::nullopt);
}

} // namespace taa::app
