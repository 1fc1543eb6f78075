// The frames beside each other: color, motion and depth of the one that is chosen, and its color against the
// frame before it.
#pragma once

#include "core/capture/format/Manifest.h"
#include "core/picture/FramePictures.h"

#include <QWidget>

#include <vector>

class QLabel;
class QSlider;
class QSplitter;

namespace taa::app {

class FlickerCompare;
class PictureBox;

class FramePanel : public QWidget {
  Q_OBJECT
 public:
  /// `beside` the flicker-compare.
  explicit FramePanel(QWidget* beside, QWidget* parent = nullptr);

  /// The frame that is chosen stays where there is one; of the first frames it is one in the middle.
  void setFrames(const std::vector<capture::CapturedFrame>& frames);
  /// Into the frames.
  int frame() const;
  void step(int frames);
  void setPictures(const FramePictures& pictures);
  FlickerCompare* flicker() const { return flicker_; }
  QSlider* slider() const { return slider_; }

 Q_SIGNALS:
  void frameChosen();

 private:
  void showFrame();

  std::vector<int> numbers_; ///< the engine's, by frame
  PictureBox *color_, *motion_, *depth_;
  QSlider* slider_;
  QLabel* place_;
  FlickerCompare* flicker_;
};

} // namespace taa::app
