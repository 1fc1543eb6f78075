#include "app/importing/FramePanel.h"

#include "app/importing/FlickerCompare.h"
#include "app/style/Theme.h"
#include "app/widgets/PictureBox.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>

namespace taa::app {

FramePanel::FramePanel(QWidget* beside, QWidget* parent)
    : QWidget(parent), color_(new PictureBox(tr("Color"))), motion_(new PictureBox(tr("Motion"))),
      depth_(new PictureBox(tr("Depth"))), slider_(new QSlider(Qt::Horizontal)), place_(new QLabel),
      flicker_(new FlickerCompare) {
  setAccessibleName(tr("Frames"));
  motion_->setToolTip(
      tr("Direction as hue, length as saturation; nothing where there is no previous position"));
  depth_->setToolTip(tr("Near is bright, on a scale of logarithms; nothing where nothing was drawn"));
  slider_->setObjectName(QStringLiteral("frame"));
  slider_->setAccessibleName(tr("Frame"));
  slider_->setToolTip(tr("The frame on show (Alt+Left, Alt+Right)"));
  place_->setFont(numberFont());
  auto* label = new QLabel(tr("Fra&me"));
  label->setBuddy(slider_);
  auto* stored = new QHBoxLayout;
  stored->setSpacing(2 * kUnit);
  for (PictureBox* box : {color_, motion_, depth_}) stored->addWidget(box, 1);
  auto* frames = new QHBoxLayout;
  frames->setSpacing(2 * kUnit);
  frames->addWidget(label);
  frames->addWidget(slider_, 1);
  frames->addWidget(place_);
  auto* below = new QSplitter;
  below->setHandleWidth(2 * kUnit);
  below->setChildrenCollapsible(false);
  below->addWidget(flicker_);
  below->addWidget(beside);
  below->setStretchFactor(0, 3);
  below->setStretchFactor(1, 2);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kUnit);
  column->addLayout(stored, 2);
  column->addLayout(frames);
  column->addWidget(below, 4);
  connect(slider_, &QSlider::valueChanged, this, [this] {
    showFrame();
    Q_EMIT frameChosen();
  });
  setFrames({});
}

void FramePanel::setFrames(const std::vector<capture::CapturedFrame>& frames) {
  const bool areFirst = numbers_.empty();
  numbers_.clear();
  for (const capture::CapturedFrame& frame : frames) numbers_.push_back(frame.number);
  const auto count = static_cast<int>(numbers_.size());
  {
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, std::max(0, count - 1));
    if (areFirst) slider_->setValue(count / 2);
  }
  slider_->setEnabled(count > 0);
  showFrame();
}

int FramePanel::frame() const {
  return slider_->value();
}

void FramePanel::step(int frames) {
  slider_->setValue(slider_->value() + frames);
}

void FramePanel::setPictures(const FramePictures& pictures) {
  // Every frame has color: without it nothing was drawn, and nothing is known of the other planes.
  const bool isDrawn = !pictures.color.rgba.empty();
  const QString nothing = tr("No picture");
  color_->setPicture(pictures.color, nothing);
  motion_->setPicture(pictures.motion, isDrawn ? tr("There is no motion.") : nothing);
  depth_->setPicture(pictures.depth, isDrawn ? tr("There is no depth.") : nothing);
  const auto numberOf = [this](int index) {
    const auto at = static_cast<std::size_t>(std::max(index, 0));
    return at < numbers_.size() ? numbers_[at] : 0;
  };
  flicker_->setPictures(pictures, numberOf(pictures.frame), numberOf(pictures.frame - 1));
}

void FramePanel::showFrame() {
  const auto index = static_cast<std::size_t>(frame());
  place_->setText(index < numbers_.size()
                      ? tr("%1 of %2, number %3").arg(index + 1).arg(numbers_.size()).arg(numbers_[index])
                      : QString());
}

} // namespace taa::app
