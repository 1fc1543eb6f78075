// What a view is compared with and what lies over it.
#include "app/views/ViewPanel.h"

#include "app/style/Text.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/views/legend/RangeMath.h"

#include <QFileInfo>
#include <QMenu>

#include <cstddef>

namespace taa::app {

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

// A difference is a signed value, whatever the row is.
Intermediate ViewPanel::shownRow() const {
  Intermediate row = intermediate(id_);
  if (isDifference()) row.visual = Visual::Signed;
  return row;
}

IntermediateId ViewPanel::otherId() const {
  return comparison_.kind == OtherKind::Row ? comparison_.id : id_;
}

// A style with the overlays of this view.
ViewStyle ViewPanel::drawn(const ViewStyle& style) const {
  ViewStyle whole = style;
  whole.markClipped = shows(Overlay::Clipped);
  whole.markRejected = shows(Overlay::Rejected);
  whole.outlineObjects = shows(Overlay::Outlines);
  whole.arrows = shows(Overlay::Arrows);
  return whole;
}

// The same row looks the same on both sides; another one as it was shown last.
ViewStyle ViewPanel::otherStyle() const {
  if (otherId() == id_) return drawn(style_);
  const auto known = remembered_.find(otherId());
  return drawn(known != remembered_.end() ? known->second : defaultStyle(intermediate(otherId())));
}

ViewRequest ViewPanel::request(const QStringList& presets) const {
  const ViewGeometry geometry = viewport_->viewGeometry();
  ViewRequest request;
  request.id = id_;
  request.style = drawn(style());
  request.transform = viewport_->transform();
  const bool isShown = isVisible() && !geometry.isEmpty();
  request.width = isShown ? geometry.viewport.x : 0;
  request.height = isShown ? geometry.viewport.y : 0;
  request.withValues = wantsRange_ || alwaysAuto_ || showsHistogram() || viewport_->showsValues() ||
                       viewport_->hovered().has_value();
  const auto preset = presets.indexOf(QString::fromStdString(comparison_.preset));
  if (!comparison_ || (comparison_.kind == OtherKind::Preset && preset < 0)) return request;
  OtherSide& other = request.other.emplace();
  other.id = otherId();
  other.style = otherStyle();
  if (comparison_.kind == OtherKind::Preset) other.lane = static_cast<int>(preset) + 1;
  if (comparison_.kind == OtherKind::Frame) other.frame = comparison_.frame;
  if (comparison_.kind == OtherKind::FramesBefore) other.framesBefore = comparison_.frame;
  request.asDifference = isDifference();
  return request;
}

// The viewport knows the frame.
QString ViewPanel::sideText(bool other) const {
  QString settings = settingsName_;
  if (other && comparison_.kind == OtherKind::Preset) {
    const QString preset = QString::fromStdString(comparison_.preset);
    settings = preset.endsWith(QStringLiteral(".json")) ? QFileInfo(preset).completeBaseName() : preset;
  }
  const QString row = tableText(intermediate(other ? otherId() : id_).label);
  return settings.isEmpty() ? row : QStringLiteral("%1 · %2").arg(row, settings);
}

bool ViewPanel::hasDifference() const {
  return comparison_ && intermediate(otherId()).channels == intermediate(id_).channels;
}

void ViewPanel::setComparison(const Comparison& comparison) {
  if (comparison == comparison_) return;
  const bool isFirst = !comparison_;
  comparison_ = comparison;
  if (!comparison_) showing_ = Showing::First;
  if (comparison_ && (isFirst || (isDifference() && !hasDifference()))) showing_ = Showing::Wipe;
  change();
}

void ViewPanel::setShowing(Showing showing) {
  if (!comparison_ || (showing == Showing::Difference && !hasDifference())) showing = Showing::First;
  if (showing == showing_) return refresh();
  showing_ = showing;
  wantsRange_ = false;
  change();
}

void ViewPanel::cycleShowing() {
  if (!comparison_) return comparisonRequested();
  switch (showing_) {
  case Showing::First:
    return setShowing(Showing::Other);
  case Showing::Other:
    return setShowing(Showing::Difference);
  default:
    return setShowing(Showing::First);
  }
}

void ViewPanel::toggleWipe() {
  if (!comparison_) return comparisonRequested();
  setShowing(showing_ == Showing::Wipe ? Showing::First : Showing::Wipe);
}

void ViewPanel::setPeeking(bool peeking) {
  viewport_->setPeeking(peeking && comparison_);
}

void ViewPanel::setSettingsName(const QString& name) {
  if (name == settingsName_) return;
  settingsName_ = name;
  refresh();
}

void ViewPanel::setSpaces(const SpaceSettings& own, const SpaceSettings& other) {
  if (own.color == space_.color && other.color == otherSpace_.color) return;
  space_ = own;
  otherSpace_ = other;
  refresh();
}

void ViewPanel::setOverlay(Overlay overlay, bool on) {
  if (shows(overlay) == on) return;
  overlays_[static_cast<std::size_t>(overlay)] = on;
  change();
}

QString ViewPanel::overlayText(Overlay overlay) {
  switch (overlay) {
  case Overlay::Clipped:
    return tr("Hatch what lies outside the range");
  case Overlay::Rejected:
    return tr("Tint by the reason of rejection");
  case Overlay::Outlines:
    return tr("Outline objects");
  case Overlay::Arrows:
    return tr("Arrows over vectors");
  case Overlay::Grid:
    return tr("Grid between large pixels");
  case Overlay::WholeLegend:
    return tr("Whole legend also where the picture is low");
  }
  return {};
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

} // namespace taa::app
