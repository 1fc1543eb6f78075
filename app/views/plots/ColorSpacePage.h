// The page of the probe panel that shows the pixel in a color space.
#pragma once

#include "app/views/plots/ColorSpaceMath.h"
#include "core/requests/Results.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace taa::app {

class ColorSpaceView;
class SegmentedButtons;

class ColorSpacePage : public QWidget {
  Q_OBJECT
 public:
  explicit ColorSpacePage(QWidget* parent = nullptr);

  /// Of the pixel itself; nothing: no values.
  void setResult(const std::optional<ProbeResult>& result);
  void setSpace(PlotSpace space);
  PlotSpace space() const { return chosen_; }
  ColorSpaceView* view() const { return view_; }

 private:
  void show();

  std::optional<ProbeResult> result_;
  PlotSpace chosen_ = PlotSpace::YCoCg;
  SegmentedButtons* spaces_ = nullptr;
  QLabel* note_ = nullptr;
  ColorSpaceView* view_ = nullptr;
};

} // namespace taa::app
