// The page of the probe panel that shows the pixel in a color space, there or in a window of its own.
#pragma once

#include "app/models/ColorSpaceMath.h"
#include "core/requests/Results.h"

#include <QPointer>
#include <QString>
#include <QWidget>

#include <optional>

class QLabel;
class QToolButton;

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
  /// What the axes are, in words.
  QString note() const;
  /// Another one that shows the same pixel, turned on its own, in a window beside this one; in front where
  /// there is one.
  void openWindow();
  ColorSpacePage* inWindow() const { return inWindow_; }

 private:
  ColorSpacePage(QWidget* window, Qt::WindowFlags flags);
  void show();

  std::optional<ProbeResult> result_;
  PlotSpace chosen_ = PlotSpace::YCoCg;
  SegmentedButtons* spaces_ = nullptr;
  QLabel* note_ = nullptr;
  ColorSpaceView* view_ = nullptr;
  QToolButton* opens_ = nullptr;
  QPointer<ColorSpacePage> inWindow_;
};

} // namespace taa::app
