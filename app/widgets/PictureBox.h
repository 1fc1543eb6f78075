// A picture of a frame as large as there is room, with a line below it that says what it is.
#pragma once

#include "core/picture/Visualizer.h"

#include <QImage>
#include <QString>
#include <QWidget>

namespace taa::app {

class PictureBox : public QWidget {
  Q_OBJECT
 public:
  explicit PictureBox(const QString& name, QWidget* parent = nullptr);

  /// `missing` is said where the picture has no pixels.
  void setPicture(const Picture& picture, const QString& missing);
  const QImage& picture() const { return picture_; }
  /// The line below it.
  void setCaption(const QString& caption);
  const QString& caption() const { return caption_; }
  QSize sizeHint() const override { return {200, 130}; }
  QSize minimumSizeHint() const override { return {90, 70}; }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  QImage picture_;
  QString caption_, missing_;
};

} // namespace taa::app
