// One view: header and viewport, and the keys and buttons that change what it shows.
#pragma once

#include "app/views/ViewSource.h"
#include "app/views/ViewportMath.h"
#include "app/views/legend/RangeMath.h"

#include "core/inspect/Comparison.h"
#include "core/inspect/ShownPicture.h"
#include "core/report/CommandLine.h"
#include "core/requests/Results.h"
#include "core/settings/Settings.h"

#include <QJsonObject>
#include <QStringList>
#include <QWidget>

#include <memory>
#include <optional>

class QMenu;

namespace taa::app {

class MeasuredRegion;
class RangeHistogram;
class ValueFinder;
class ViewHeader;
class Viewport;

/// Of a picture for a file: all of it, pixel for pixel, or as it lies in the viewport.
enum class PictureExtent { Whole, Viewport };

class ViewPanel : public QWidget {
  Q_OBJECT
 public:
  /// `index` 0 is view A.
  ViewPanel(int index, IntermediateId id, QWidget* parent = nullptr);

  int index() const { return index_; }
  IntermediateId id() const { return source_.id(); }
  /// Of what is shown: the row, or the difference.
  const ViewStyle& style() const { return source_.style(); }
  Viewport* viewport() const { return viewport_; }
  ViewHeader* header() const { return header_; }
  /// What the render thread shall deliver. `presets`: those of the lanes after the first.
  ViewRequest request(const QStringList& presets) const;

  /// What files are to show of any frame: both sides as they are on the screen.
  PictureRequest pictureRequest(const QStringList& presets, PictureExtent extent) const;
  CommandView commandView() const;

  void setIntermediate(IntermediateId id);
  void setStyle(const ViewStyle& style);
  void setResult(const std::shared_ptr<const ViewResult>& result);
  void setActive(bool active);

  // Comparing
  const Comparison& comparison() const { return source_.comparison(); }
  /// At first both are shown with a divider between them.
  void setComparison(const Comparison& comparison);
  Showing showing() const { return source_.showing(); }
  void setShowing(Showing showing);
  /// One side, the other, their difference; asks for something to compare with when there is nothing.
  void cycleShowing();
  void toggleWipe();
  /// Whether both sides have as many channels.
  bool hasDifference() const { return source_.hasDifference(); }
  bool isDifference() const { return source_.isDifference(); }
  /// Row and settings of a side.
  QString sideText(bool other) const { return source_.sideText(other); }
  /// Shows the other side for as long as it lasts.
  void setPeeking(bool peeking);
  /// What the settings in force are called: "balanced*".
  void setSettingsName(const QString& name);
  /// What the box is made in by the settings of both sides.
  void setSpaces(const SpaceSettings& own, const SpaceSettings& other);

  /// Counts the visible values below the range, to set it by.
  void setHistogramShown(bool shown);
  bool showsHistogram() const;
  /// Whether values at hand are still being counted.
  bool isMeasuring() const;

  /// The region whose statistics stand over the picture.
  MeasuredRegion* measured() const { return measured_; }

  // Overlays
  bool shows(Overlay overlay) const { return source_.shows(overlay); }
  void setOverlay(Overlay overlay, bool on);

  // Keys
  void changeExposure(float stops);
  void normalize(); ///< as soon as values are here
  void setAlwaysAuto(bool always);
  bool isAlwaysAuto() const { return alwaysAuto_; }
  void resetStyle();
  void nextColorMap();
  void toggleMarks();
  void toggleChannel(int channel);

  QJsonObject state() const;
  void setState(const QJsonObject& state);

 Q_SIGNALS:
  void requestChanged();
  void contentChanged(); ///< intermediate, style, comparison or overlays
  void activated();
  void intermediateRequested();
  void comparisonRequested(); ///< a list to choose from is wanted

 private:
  void connectParts();
  void makeHistogram();
  void connectComparing();
  void measure();
  void fitRange(const std::optional<ValueRange>& range);
  void refresh();
  void change();
  void openOverlayMenu();

  int index_;
  ViewSource source_;
  bool wantsRange_ = false, alwaysAuto_ = false;
  ViewHeader* header_;
  Viewport* viewport_;
  RangeHistogram* histogram_;
  ValueFinder* finder_;
  MeasuredRegion* measured_;
};

} // namespace taa::app
