#include "app/views/ViewPanel.h"

#include "app/views/RangeMath.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"

#include <QVBoxLayout>

namespace taa::app {

ViewPanel::ViewPanel(int index, IntermediateId id, QWidget* parent)
    : QWidget(parent), index_(index), id_(id), style_(defaultStyle(intermediate(id))),
      header_(new ViewHeader(QChar(static_cast<char16_t>('A' + index)))), viewport_(new Viewport) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(header_);
  layout->addWidget(viewport_, 1);
  setObjectName(QStringLiteral("view") + QChar(static_cast<char16_t>('A' + index)));
  connectParts();
  refresh();
}

void ViewPanel::connectParts() {
  connect(header_, &ViewHeader::styleEdited, this, &ViewPanel::setStyle);
  connect(header_, &ViewHeader::intermediateRequested, this, [this] {
    Q_EMIT activated();
    Q_EMIT intermediateRequested();
  });
  connect(header_, &ViewHeader::autoRangeRequested, this, &ViewPanel::normalize);
  connect(header_, &ViewHeader::alwaysAutoToggled, this, [this] { setAlwaysAuto(!alwaysAuto_); });
  connect(header_, &ViewHeader::resetRequested, this, &ViewPanel::resetStyle);
  connect(header_, &ViewHeader::pressed, this, &ViewPanel::activated);
  connect(header_, &ViewHeader::zoomClicked, this, [this] {
    if (viewport_->camera().fit)
      viewport_->oneToOne();
    else
      viewport_->fit();
  });
  connect(viewport_, &Viewport::activated, this, &ViewPanel::activated);
  connect(viewport_, &Viewport::transformChanged, this, [this] {
    header_->setZoom(viewport_->zoom(), viewport_->camera().fit);
    Q_EMIT requestChanged();
  });
  // The values under the mouse are asked for only while there is one.
  connect(viewport_, &Viewport::hoverChanged, this, &ViewPanel::requestChanged);
}

ViewRequest ViewPanel::request() const {
  const ViewGeometry geometry = viewport_->viewGeometry();
  ViewRequest request;
  request.id = id_;
  request.style = style_;
  request.transform = viewport_->transform();
  const bool isShown = isVisible() && !geometry.isEmpty();
  request.width = isShown ? geometry.viewport.x : 0;
  request.height = isShown ? geometry.viewport.y : 0;
  request.withValues =
      wantsRange_ || alwaysAuto_ || viewport_->showsValues() || viewport_->hovered().has_value();
  return request;
}

void ViewPanel::refresh() {
  header_->setContent(intermediate(id_), style_);
  header_->setAlwaysAuto(alwaysAuto_);
  viewport_->setContent(id_, style_);
}

void ViewPanel::setIntermediate(IntermediateId id) {
  if (id == id_) return;
  remembered_[id_] = style_;
  id_ = id;
  const auto known = remembered_.find(id);
  style_ = known != remembered_.end() ? known->second : defaultStyle(intermediate(id));
  wantsRange_ = false;
  refresh();
  Q_EMIT contentChanged();
  Q_EMIT requestChanged();
}

void ViewPanel::setStyle(const ViewStyle& style) {
  if (style == style_) return;
  style_ = style;
  refresh();
  Q_EMIT contentChanged();
  Q_EMIT requestChanged();
}

void ViewPanel::setResult(const ViewResult& result) {
  viewport_->setResult(result);
  fitRange(result);
}

void ViewPanel::fitRange(const ViewResult& result) {
  if (!(wantsRange_ || alwaysAuto_) || result.request.id != id_ || result.values.empty()) return;
  wantsRange_ = false;
  const std::optional<ValueRange> range = autoRange(result.values, intermediate(id_), style_);
  ViewStyle style = style_;
  if (range) {
    style.low = range->low;
    style.high = range->high;
    style.exposure = 0.0f;
  }
  setStyle(style);
  refresh();
}

void ViewPanel::setActive(bool active) {
  header_->setActive(active);
}

void ViewPanel::changeExposure(float stops) {
  if (!hasExposure(intermediate(id_))) return;
  ViewStyle style = style_;
  style.exposure += stops;
  setStyle(style);
}

void ViewPanel::normalize() {
  refresh(); // a click has checked the button
  if (!hasRange(intermediate(id_))) return;
  wantsRange_ = true;
  if (viewport_->result() && viewport_->result()->request.id == id_ && !viewport_->result()->values.empty())
    fitRange(*viewport_->result());
  else
    Q_EMIT requestChanged();
}

void ViewPanel::setAlwaysAuto(bool always) {
  alwaysAuto_ = always;
  refresh();
  Q_EMIT requestChanged();
}

void ViewPanel::resetStyle() {
  alwaysAuto_ = false;
  refresh();
  setStyle(defaultStyle(intermediate(id_)));
}

void ViewPanel::nextColorMap() {
  if (!usesColorMap(intermediate(id_), style_)) return;
  ViewStyle style = style_;
  constexpr int kMapCount = static_cast<int>(ColorMap::Categorical) + 1;
  style.map = static_cast<ColorMap>((static_cast<int>(style.map) + 1) % kMapCount);
  setStyle(style);
}

void ViewPanel::toggleMarks() {
  ViewStyle style = style_;
  style.markInvalid = !style.markInvalid;
  setStyle(style);
}

void ViewPanel::toggleChannel(int channel) {
  if (channel >= intermediate(id_).channels) return;
  ViewStyle style = style_;
  setShown(style, channel, !isShown(style, channel));
  setStyle(style);
}

} // namespace taa::app
