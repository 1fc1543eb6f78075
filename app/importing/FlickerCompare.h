// A frame and the frame before it, brought along its motion, in turns at one place: what jumps does not fit.
#pragma once

#include "core/picture/FramePictures.h"

#include <QString>
#include <QTimer>
#include <QWidget>

class QPushButton;

namespace taa::app {

class PictureBox;

class FlickerCompare : public QWidget {
  Q_OBJECT
 public:
  enum class Shown { Current, Warped, Difference };

  explicit FlickerCompare(QWidget* parent = nullptr);

  /// `number` and `previousNumber` are the engine's; what is shown, and whether it alternates, stays. Without
  /// color nothing was drawn.
  void setPictures(const FramePictures& pictures, int number, int previousNumber);
  Shown shown() const { return shown_; }
  void setShown(Shown shown);
  bool isAlternating() const { return alternation_.isActive(); }
  void setAlternating(bool alternates);
  PictureBox* picture() const { return picture_; }
  QPushButton* alternateButton() const { return alternate_; }
  QPushButton* otherButton() const { return other_; }
  QPushButton* differenceButton() const { return difference_; }

 private:
  bool hasTwo() const;
  void refresh();
  void swap();

  FramePictures pictures_;
  int number_ = 0, previousNumber_ = 0;
  Shown shown_ = Shown::Current;
  PictureBox* picture_;
  QPushButton *alternate_, *other_, *difference_;
  QTimer alternation_;
};

} // namespace taa::app
