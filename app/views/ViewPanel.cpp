#include "app/views/ViewPanel.h"

#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/MeasuredRegion.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/views/legend/RangeHistogram.h"
#include "app/views/legend/ValueFinder.h"

#include <QJsonArray>
#include <QMenu>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <memory>

namespace taa::app {

namespace {

/// The column of the whole picture that lies at a column of the screen.
double pictureColumn(const ViewTransform& transform, int screen) {
  return pictureFromScreen(transform, {screen, 0.0}).x;
}

/// Where a view looks, as session files keep it.
QJsonObject cameraJson(const ViewCamera& camera) {
  return {{QStringLiteral("fit"), camera.fit},
          {QStringLiteral("zoom"), camera.zoom},
          {QStringLiteral("center"), QJsonArray{camera.center.x, camera.center.y}}};
}

/// What makes no sense fits the whole picture.
ViewCamera cameraFromJson(const QJsonObject& json) {
  ViewCamera camera;
  camera.fit = json.value(QLatin1String("fit")).toBool(true);
  camera.zoom = json.value(QLatin1String("zoom")).toDouble(1.0);
  const QJsonArray center = json.value(QLatin1String("center")).toArray();
  camera.center = {center.at(0).toDouble(), center.at(1).toDouble()};
  const bool isUsable = std::isfinite(camera.zoom) && camera.zoom > 0.0 && std::isfinite(camera.center.x) &&
                        std::isfinite(camera.center.y);
  return isUsable ? camera : ViewCamera{};
}

} // namespace

ViewPanel::ViewPanel(int index, IntermediateId id, QWidget* parent)
    : QWidget(parent), index_(index), source_(id),
      header_(new ViewHeader(QChar(static_cast<char16_t>('A' + index)))), viewport_(new Viewport),
      histogram_(new RangeHistogram(viewport_)), finder_(new ValueFinder(this)),
      measured_(new MeasuredRegion(*viewport_, this)) {
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
  connect(measured_, &MeasuredRegion::changed, this, [this] {
    Q_EMIT contentChanged();
    Q_EMIT requestChanged();
  });
}

void ViewPanel::refresh() {
  const Intermediate row = source_.row();
  header_->setContent(row, style(), source_.space());
  header_->setAlwaysAuto(alwaysAuto_);
  header_->setComparing(static_cast<bool>(comparison()), hasDifference(), showing());
  viewport_->setContent(source_.content());
  viewport_->setOther(source_.otherContent());
  viewport_->setShowing(showing());
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
  if (id == this->id()) return;
  source_.setId(id);
  wantsRange_ = false;
  histogram_->setDistribution({});
  change();
}

void ViewPanel::setStyle(const ViewStyle& style) {
  if (style == this->style()) return;
  source_.setStyle(style);
  change();
}

void ViewPanel::setResult(const std::shared_ptr<const ViewResult>& result) {
  viewport_->setResult(result);
  measure();
  if (!result) return;
  const bool isOfThis = result->request.id == id() && result->request.asDifference == isDifference();
  const QString label = qtext(source_.row().label);
  const MeasuredContent content{.row = source_.row(),
                                .space = source_.space(),
                                .label = isDifference() ? tr("%1, difference").arg(label) : label,
                                .frame = result->frame};
  measured_->setResult(*result, isOfThis ? std::optional(content) : std::nullopt);
}

// Asks how the values at hand are spread, for who wants to know.
void ViewPanel::measure() {
  const auto& result = viewport_->result();
  const bool fits = wantsRange_ || alwaysAuto_;
  if (!(fits || showsHistogram()) || !result || result->values.empty()) return;
  if (result->request.id != id() || result->request.asDifference != isDifference()) return;
  ValueFinder::Question question{.result = result, .row = source_.row(), .style = style(), .range = {}};
  if (!fits) question.range = ValueRange{style().low, style().high};
  if (showsHistogram()) question.bins = RangeHistogram::kBins;
  finder_->find(question);
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
  if (!hasExposure(source_.row())) return;
  ViewStyle style = this->style();
  style.exposure += stops;
  setStyle(style);
}

void ViewPanel::normalize() {
  refresh(); // a click has checked the button
  if (!hasRange(source_.row())) return;
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
  setStyle(source_.firstStyle());
}

void ViewPanel::nextColorMap() {
  if (!usesColorMap(source_.row(), style())) return;
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
  if (channel >= intermediate(id()).channels) return;
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
  connect(finder_, &ValueFinder::found, this,
          [this](const ValueFinder::Question& of, const Distribution& found) {
            if (of.row.id != id() || of.result->request.asDifference != isDifference()) return;
            for (int channel = 0; channel < 3; ++channel)
              if (isShown(of.style, channel) != isShown(style(), channel))
                return; // a picture of these is on its way
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
  shown = shown && hasRange(source_.row());
  if (shown == showsHistogram()) {
    header_->setHistogramShown(shown);
    return;
  } // a click has checked the button
  histogram_->setVisible(shown);
  header_->setHistogramShown(showsHistogram());
  measure();
  Q_EMIT contentChanged();
  Q_EMIT requestChanged();
}

void ViewPanel::connectComparing() {
  connect(header_, &ViewHeader::comparisonRequested, this, [this] {
    Q_EMIT activated();
    refresh(); // the click has checked the button
    Q_EMIT comparisonRequested();
  });
  connect(header_, &ViewHeader::showingChosen, this, &ViewPanel::setShowing);
  connect(header_, &ViewHeader::overlaysRequested, this, [this] {
    Q_EMIT activated();
    openOverlayMenu();
  });
  connect(viewport_, &Viewport::dividerMoved, this, &ViewPanel::contentChanged);
}

ViewRequest ViewPanel::request(const QStringList& presets) const {
  const ViewGeometry geometry = viewport_->viewGeometry();
  const bool isShown = isVisible() && !geometry.isEmpty();
  ViewRequest request;
  request.id = id();
  request.style = source_.drawnStyle();
  request.transform = viewport_->transform();
  request.width = isShown ? geometry.viewport.x : 0;
  request.height = isShown ? geometry.viewport.y : 0;
  request.withValues = wantsRange_ || alwaysAuto_ || showsHistogram() || viewport_->showsValues() ||
                       viewport_->hovered().has_value();
  request.other = source_.otherSide(presets);
  request.asDifference = request.other && isDifference();
  if (isShown) request.measured = measured_->region();
  return request;
}

void ViewPanel::setComparison(const Comparison& comparison) {
  if (comparison == this->comparison()) return;
  source_.setComparison(comparison);
  change();
}

void ViewPanel::setShowing(Showing showing) {
  if (source_.possible(showing) == this->showing()) {
    refresh();
    return;
  }
  source_.setShowing(showing);
  wantsRange_ = false;
  change();
}

void ViewPanel::cycleShowing() {
  if (!comparison()) {
    comparisonRequested();
    return;
  }
  switch (showing()) {
  case Showing::First:
    setShowing(Showing::Other);
    return;
  case Showing::Other:
    setShowing(Showing::Difference);
    return;
  default:
    setShowing(Showing::First);
    return;
  }
}

void ViewPanel::toggleWipe() {
  if (!comparison()) {
    comparisonRequested();
    return;
  }
  setShowing(showing() == Showing::Wipe ? Showing::First : Showing::Wipe);
}

void ViewPanel::setPeeking(bool peeking) {
  viewport_->setPeeking(peeking && comparison());
}

void ViewPanel::setSettingsName(const QString& name) {
  if (name == source_.settingsName()) return;
  source_.setSettingsName(name);
  refresh();
}

void ViewPanel::setSpaces(const SpaceSettings& own, const SpaceSettings& other) {
  if (own.color == source_.space().color && other.color == source_.otherSpace().color) return;
  source_.setSpaces(own, other);
  refresh();
}

void ViewPanel::setOverlay(Overlay overlay, bool on) {
  if (shows(overlay) == on) return;
  source_.setOverlay(overlay, on);
  change();
}

void ViewPanel::openOverlayMenu() {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QAction* marks =
      menu->addAction(tr("Mark NaN red, infinite green, negative blue"), this, &ViewPanel::toggleMarks);
  marks->setCheckable(true);
  marks->setChecked(style().markInvalid);
  for (int index = 0; index < kOverlayCount; ++index) {
    const auto overlay = static_cast<Overlay>(index);
    QAction* action = menu->addAction(overlayText(overlay), this,
                                      [this, overlay] { setOverlay(overlay, !shows(overlay)); });
    action->setCheckable(true);
    action->setChecked(shows(overlay));
  }
  menu->popup(header_->mapToGlobal(header_->overlaysPlace()));
}

PictureRequest ViewPanel::pictureRequest(const QStringList& presets, PictureExtent extent) const {
  const ViewRequest shown = request(presets);
  PictureRequest picture{.id = id(),
                         .style = shown.style,
                         .transform = {},
                         .width = viewport_->viewGeometry().picture.x,
                         .height = viewport_->viewGeometry().picture.y,
                         .lane = shown.lane,
                         .other = shown.other,
                         .showing = shown.other ? showing() : Showing::First};
  if (extent == PictureExtent::Viewport) {
    const QRect part = viewport_->shownPart();
    picture.transform = viewport_->transform();
    picture.width = viewport_->viewGeometry().viewport.x;
    picture.height = viewport_->viewGeometry().viewport.y;
    picture.part = {part.x(), part.y(), part.width(), part.height()};
    picture.divider = std::clamp(viewport_->dividerColumn() - part.x(), 0, part.width());
  } else {
    const double column = pictureColumn(viewport_->transform(), viewport_->dividerColumn());
    picture.divider = static_cast<int>(std::lround(std::clamp(column, 0.0, 1.0 * picture.width)));
  }
  return picture;
}

CommandView ViewPanel::commandView() const {
  const int width = std::max(1, viewport_->viewGeometry().picture.x);
  const double column = pictureColumn(viewport_->transform(), viewport_->dividerColumn());
  return {.id = id(),
          .style = source_.drawnStyle(),
          .comparison = comparison(),
          .showing = showing(),
          .otherStyle = comparison() ? source_.otherStyle() : ViewStyle{},
          .divider = std::clamp(std::round(column) / width, 0.0, 1.0)};
}

QJsonObject ViewPanel::state() const {
  QJsonObject state = source_.state();
  state[QStringLiteral("alwaysFits")] = alwaysAuto_;
  state[QStringLiteral("divider")] = viewport_->divider();
  state[QStringLiteral("histogram")] = showsHistogram();
  if (measured_->region()) state[QStringLiteral("region")] = measured_->state();
  state[QStringLiteral("camera")] = cameraJson(viewport_->camera());
  return state;
}

void ViewPanel::setState(const QJsonObject& state) {
  source_.setState(state);
  wantsRange_ = false;
  alwaysAuto_ = state.value(QLatin1String("alwaysFits")).toBool();
  measured_->setState(state.value(QLatin1String("region")).toArray());
  viewport_->setDivider(state.value(QLatin1String("divider")).toDouble(0.5));
  viewport_->setCamera(cameraFromJson(state.value(QLatin1String("camera")).toObject()));
  change();
  setHistogramShown(state.value(QLatin1String("histogram")).toBool());
}

} // namespace taa::app
