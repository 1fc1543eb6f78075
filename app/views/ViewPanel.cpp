#include "app/views/ViewPanel.h"

#include "app/style/Theme.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/views/legend/RangeHistogram.h"
#include "app/views/legend/ValueFinder.h"

#include <QVBoxLayout>

#include <memory>

namespace taa::app {

ViewPanel::ViewPanel(int index, IntermediateId id, QWidget* parent)
    : QWidget(parent), index_(index), id_(id), style_(defaultStyle(intermediate(id))),
      difference_(differenceStyle(intermediate(id))),
      header_(new ViewHeader(QChar(static_cast<char16_t>('A' + index)))), viewport_(new Viewport),
      histogram_(new RangeHistogram(viewport_)), finder_(new ValueFinder(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(header_);
  layout->addWidget(viewport_, 1);
  setObjectName(QStringLiteral("view") + QChar(static_cast<char16_t>('A' + index)));
  viewport_->setAccessibleName(tr("View %1").arg(QChar(static_cast<char16_t>('A' + index))));
  connectParts();
  connectComparing();
  makeHistogram();
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

const ViewStyle& ViewPanel::style() const {
  return isDifference() ? difference_ : style_;
}

void ViewPanel::refresh() {
  const Intermediate row = shownRow();
  header_->setContent(row, style(), space_);
  header_->setAlwaysAuto(alwaysAuto_);
  header_->setComparing(static_cast<bool>(comparison_), hasDifference(), showing_);
  viewport_->setContent({row, drawn(style()), sideText(false), space_});
  viewport_->setOther(comparison_ ? std::optional(ViewContent{intermediate(otherId()), otherStyle(),
                                                              sideText(true), otherSpace_})
                                  : std::nullopt);
  viewport_->setShowing(showing_);
  viewport_->setShowsGrid(shows(Overlay::Grid));
  viewport_->setLegendWhole(shows(Overlay::WholeLegend));
  histogram_->setRange({style().low, style().high});
  if (!hasRange(row)) setHistogramShown(false);
}

// After anything that is drawn has changed.
void ViewPanel::change() {
  refresh();
  Q_EMIT contentChanged();
  Q_EMIT requestChanged();
}

void ViewPanel::setIntermediate(IntermediateId id) {
  if (id == id_) return;
  remembered_[id_] = style_;
  id_ = id;
  const auto known = remembered_.find(id);
  style_ = known != remembered_.end() ? known->second : defaultStyle(intermediate(id));
  difference_ = differenceStyle(intermediate(id));
  wantsRange_ = false;
  histogram_->setDistribution({});
  if (showing_ == Showing::Difference && !hasDifference()) showing_ = Showing::Wipe;
  change();
}

void ViewPanel::setStyle(const ViewStyle& style) {
  if (style == this->style()) return;
  (isDifference() ? difference_ : style_) = style;
  change();
}

void ViewPanel::setResult(const std::shared_ptr<const ViewResult>& result) {
  viewport_->setResult(result);
  measure();
}

// Asks how the values at hand are spread, for who wants to know.
void ViewPanel::measure() {
  const auto& result = viewport_->result();
  const bool fits = wantsRange_ || alwaysAuto_;
  if (!(fits || showsHistogram()) || !result || result->values.empty()) return;
  if (result->request.id != id_ || result->request.asDifference != isDifference()) return;
  ValueFinder::Wish wish{.result = result, .row = shownRow(), .style = style(), .range = {}};
  if (!fits) wish.range = ValueRange{style().low, style().high};
  if (showsHistogram()) wish.bins = RangeHistogram::kBins;
  finder_->find(wish);
}

void ViewPanel::fitRange(const std::optional<ValueRange>& range) {
  wantsRange_ = false;
  ViewStyle style = this->style();
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
  if (!hasExposure(shownRow())) return;
  ViewStyle style = this->style();
  style.exposure += stops;
  setStyle(style);
}

void ViewPanel::normalize() {
  refresh(); // a click has checked the button
  if (!hasRange(shownRow())) return;
  wantsRange_ = true;
  measure();
  if (wantsRange_) Q_EMIT requestChanged();
}

void ViewPanel::setAlwaysAuto(bool always) {
  alwaysAuto_ = always;
  refresh();
  Q_EMIT contentChanged();
  Q_EMIT requestChanged();
}

void ViewPanel::resetStyle() {
  if (alwaysAuto_) setAlwaysAuto(false);
  setStyle(isDifference() ? differenceStyle(intermediate(id_)) : defaultStyle(intermediate(id_)));
}

void ViewPanel::nextColorMap() {
  if (!usesColorMap(shownRow(), style())) return;
  ViewStyle style = this->style();
  constexpr int kMapCount = static_cast<int>(ColorMap::Categorical) + 1;
  style.map = static_cast<ColorMap>((static_cast<int>(style.map) + 1) % kMapCount);
  setStyle(style);
}

void ViewPanel::toggleMarks() {
  ViewStyle style = this->style();
  style.markInvalid = !style.markInvalid;
  setStyle(style);
}

void ViewPanel::toggleChannel(int channel) {
  if (channel >= intermediate(id_).channels) return;
  ViewStyle style = this->style();
  setShown(style, channel, !isShown(style, channel));
  setStyle(style);
}

// Below the header, over the picture; asks for values while it is open.
void ViewPanel::makeHistogram() {
  histogram_->hide();
  histogram_->move(2 * kUnit, 8 * kUnit); // below the label of a side
  connect(header_, &ViewHeader::histogramToggled, this, [this] { setHistogramShown(!showsHistogram()); });
  connect(histogram_, &RangeHistogram::rangeEdited, this, [this](ValueRange range) {
    ViewStyle style = this->style();
    style.low = range.low;
    style.high = range.high;
    setStyle(style);
  });
  connect(finder_, &ValueFinder::found, this, [this](const ValueFinder::Wish& of, const Distribution& found) {
    if (of.row.id != id_ || of.result->request.asDifference != isDifference()) return;
    for (int channel = 0; channel < 3; ++channel)
      if (isShown(of.style, channel) != isShown(style(), channel)) return; // a picture of these is on its way
    if (wantsRange_ || alwaysAuto_) fitRange(found.values);
    if (showsHistogram() && !found.counts.empty()) histogram_->setDistribution(found);
  });
}

bool ViewPanel::isMeasuring() const {
  return finder_->isBusy();
}

bool ViewPanel::showsHistogram() const {
  return !histogram_->isHidden();
}

void ViewPanel::setHistogramShown(bool shown) {
  shown = shown && hasRange(shownRow());
  if (shown == showsHistogram()) return header_->setHistogramShown(shown); // a click has checked the button
  histogram_->setVisible(shown);
  header_->setHistogramShown(showsHistogram());
  measure();
  Q_EMIT contentChanged();
  Q_EMIT requestChanged();
}

} // namespace taa::app
