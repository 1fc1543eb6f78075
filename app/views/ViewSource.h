// What a view shows and how: its row and style, what it is compared with, what lies over it, and a memory of
// how each row was last shown. No widgets.
#pragma once

#include "app/views/Overlays.h"
#include "app/views/legend/Legend.h"

#include "core/inspect/Comparison.h"
#include "core/picture/ViewRequest.h"
#include "core/settings/Settings.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <array>
#include <map>
#include <optional>

namespace taa::app {

class ViewSource {
 public:
  explicit ViewSource(IntermediateId id);

  IntermediateId id() const { return id_; }
  void setId(IntermediateId id);
  /// Of what is shown: the row, or the difference.
  const ViewStyle& style() const { return isDifference() ? difference_ : style_; }
  void setStyle(const ViewStyle& style) { (isDifference() ? difference_ : style_) = style; }
  ViewStyle firstStyle() const; ///< as style() is before anybody changes it
  /// What is shown: of a difference a signed value, whatever the row is.
  Intermediate row() const;

  const Comparison& comparison() const { return comparison_; }
  /// At first both are shown with a divider between them.
  void setComparison(const Comparison& comparison);
  Showing showing() const { return showing_; }
  /// What can not be shown is the first side.
  void setShowing(Showing showing);
  Showing possible(Showing showing) const;
  /// Whether both sides have as many channels.
  bool hasDifference() const;
  bool isDifference() const { return comparison_ && showing_ == Showing::Difference; }

  bool shows(Overlay overlay) const { return overlays_[static_cast<std::size_t>(overlay)]; }
  void setOverlay(Overlay overlay, bool on) { overlays_[static_cast<std::size_t>(overlay)] = on; }

  /// What the settings in force are called: "balanced*".
  const QString& settingsName() const { return settingsName_; }
  void setSettingsName(const QString& name) { settingsName_ = name; }
  /// What the box is made in by the settings of both sides.
  const SpaceSettings& space() const { return space_; }
  const SpaceSettings& otherSpace() const { return otherSpace_; }
  void setSpaces(const SpaceSettings& own, const SpaceSettings& other);

  // What is drawn of it
  ViewStyle drawnStyle() const { return drawn(style()); } ///< with the overlays
  /// The same row looks the same on both sides; another one as it was shown last.
  ViewStyle otherStyle() const;
  ViewContent content() const;
  std::optional<ViewContent> otherContent() const;
  /// Row and settings of a side. The viewport knows the frame.
  QString sideText(bool other) const;
  /// What the render thread shall draw beside it. `presets`: those of the lanes after the first, as far as
  /// they are there.
  std::optional<OtherSide> otherSide(const QStringList& presets) const;

  QJsonObject state() const;
  void setState(const QJsonObject& state);

 private:
  IntermediateId otherId() const { return comparison_.kind == OtherKind::Row ? comparison_.id : id_; }
  ViewStyle drawn(const ViewStyle& style) const;
  ViewStyle rememberedStyle(IntermediateId id) const;

  IntermediateId id_;
  ViewStyle style_, difference_;
  std::map<IntermediateId, ViewStyle> remembered_;
  Comparison comparison_;
  Showing showing_ = Showing::First;
  std::array<bool, kOverlayCount> overlays_{false, false, false, false, true, false};
  QString settingsName_;
  SpaceSettings space_, otherSpace_;
};

} // namespace taa::app
