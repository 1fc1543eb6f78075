#include "app/importing/FlickerCompare.h"

#include "app/style/Theme.h"
#include "app/widgets/PictureBox.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace taa::app {

namespace {
/// Both pictures twice a second: below three flashes, which some people's health asks for.
constexpr int kSwapMs = 250;
} // namespace

FlickerCompare::FlickerCompare(QWidget* parent)
    : QWidget(parent), picture_(new PictureBox(tr("Current and warped previous frame"))),
      alternate_(new QPushButton(tr("Al&ternate"))), other_(new QPushButton(tr("S&wap"))),
      difference_(new QPushButton(tr("Di&fference"))) {
  alternate_->setObjectName(QStringLiteral("alternate"));
  other_->setObjectName(QStringLiteral("swap"));
  difference_->setObjectName(QStringLiteral("difference"));
  alternate_->setToolTip(tr("Show the frame and the one before it, brought along its motion, in turns, twice "
                            "a second (Alt+T). What is right stands still."));
  other_->setToolTip(tr("Show the other one of the two (Alt+W)"));
  difference_->setToolTip(tr("Show how far apart the two are (Alt+F)"));
  alternate_->setCheckable(true);
  difference_->setCheckable(true);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kUnit);
  for (QPushButton* button : {alternate_, other_, difference_}) {
    button->setAutoDefault(false);
    button->setAccessibleDescription(button->toolTip());
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kUnit);
  layout->addWidget(picture_, 1);
  layout->addLayout(buttons);
  alternation_.setInterval(kSwapMs);
  connect(&alternation_, &QTimer::timeout, this, [this] {
    if (hasTwo()) swap();
  });
  connect(alternate_, &QPushButton::toggled, this, &FlickerCompare::setAlternating);
  connect(other_, &QPushButton::clicked, this, [this] {
    setAlternating(false);
    swap();
  });
  connect(difference_, &QPushButton::toggled, this,
          [this](bool on) { setShown(on ? Shown::Difference : Shown::Current); });
  refresh();
}

void FlickerCompare::setPictures(const FramePictures& pictures, int number, int previousNumber) {
  pictures_ = pictures;
  number_ = number;
  previousNumber_ = previousNumber;
  if (!hasTwo() && isAlternating()) shown_ = Shown::Current;
  refresh();
}

void FlickerCompare::setShown(Shown shown) {
  shown_ = shown;
  if (shown == Shown::Difference) setAlternating(false);
  const QSignalBlocker quiet(difference_);
  difference_->setChecked(shown == Shown::Difference);
  refresh();
}

void FlickerCompare::setAlternating(bool alternates) {
  const QSignalBlocker quiet(alternate_);
  alternate_->setChecked(alternates);
  if (!alternates) {
    alternation_.stop();
    return;
  }
  if (shown_ == Shown::Difference) setShown(Shown::Current);
  alternation_.start();
}

void FlickerCompare::swap() {
  setShown(shown_ == Shown::Current ? Shown::Warped : Shown::Current);
}

bool FlickerCompare::hasTwo() const {
  return !pictures_.warped.rgba.empty();
}

void FlickerCompare::refresh() {
  for (QPushButton* button : {alternate_, other_, difference_}) button->setEnabled(hasTwo());
  const QString nothing = tr("No picture");
  if (pictures_.color.rgba.empty()) {
    picture_->setPicture({}, nothing);
    picture_->setCaption({});
    return;
  }
  const QString missing = tr("No frame before this one to compare with.");
  switch (shown_) {
  case Shown::Current:
    picture_->setPicture(pictures_.color, nothing);
    picture_->setCaption(tr("Frame %1").arg(number_));
    break;
  case Shown::Warped:
    picture_->setPicture(pictures_.warped, missing);
    picture_->setCaption(
        tr("Frame %1, brought along the motion to frame %2").arg(previousNumber_).arg(number_));
    break;
  case Shown::Difference:
    picture_->setPicture(pictures_.difference, missing);
    picture_->setCaption(
        tr("Difference of frame %1 and the warped frame %2").arg(number_).arg(previousNumber_));
    break;
  }
}

} // namespace taa::app
