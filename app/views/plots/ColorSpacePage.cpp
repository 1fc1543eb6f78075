#include "app/views/plots/ColorSpacePage.h"

#include "app/style/Theme.h"
#include "app/views/plots/ColorSpaceView.h"
#include "app/widgets/Note.h"
#include "app/widgets/parameters/SegmentedButtons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

namespace taa::app {

ColorSpacePage::ColorSpacePage(QWidget* parent) : ColorSpacePage(parent, {}) {}

ColorSpacePage::ColorSpacePage(QWidget* parent, Qt::WindowFlags flags) : QWidget(parent, flags) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kUnit);
  auto* line = new QHBoxLayout;
  line->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, 0);
  spaces_ = new SegmentedButtons({tr("RGB"), tr("YCoCg")});
  spaces_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  spaces_->setAccessibleName(tr("Axes of the color space plot"));
  note_ = newNote();
  line->addWidget(spaces_);
  line->addStretch(1);
  opens_ = new QToolButton;
  opens_->setText(tr("In a window"));
  opens_->setToolTip(tr("The plot in a window of its own, as large as you like (Ctrl+F3)"));
  opens_->setFocusPolicy(Qt::TabFocus);
  opens_->setVisible(!flags.testFlag(Qt::Window));
  connect(opens_, &QToolButton::clicked, this, &ColorSpacePage::openWindow);
  line->addWidget(opens_);
  column->addLayout(line);
  note_->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 0);
  column->addWidget(note_);
  view_ = new ColorSpaceView;
  view_->setToolTip(tr("Drag to turn, double-click to turn back"));
  column->addWidget(view_, 1);
  connect(spaces_, &SegmentedButtons::chosen, this,
          [this](int index) { setSpace(static_cast<PlotSpace>(index)); });
  setSpace(chosen_);
}

void ColorSpacePage::setSpace(PlotSpace space) {
  chosen_ = space;
  spaces_->setCurrent(static_cast<int>(space));
  show();
}

void ColorSpacePage::setResult(const std::optional<ProbeResult>& result) {
  result_ = result;
  show();
}

QString ColorSpacePage::note() const {
  return note_->text();
}

void ColorSpacePage::openWindow() {
  if (!inWindow_) {
    inWindow_ = new ColorSpacePage(window(), Qt::Window);
    inWindow_->setAttribute(Qt::WA_DeleteOnClose);
    inWindow_->setAutoFillBackground(true);
    inWindow_->setBackgroundRole(QPalette::AlternateBase);
    inWindow_->setWindowTitle(tr("Color space of the probed pixel"));
    inWindow_->setSpace(chosen_);
    inWindow_->view()->setTurn(view_->turn());
    auto* closes = new QShortcut(QKeySequence::Cancel, inWindow_);
    connect(closes, &QShortcut::activated, inWindow_, &QWidget::close);
    inWindow_->resize(scaled(720), scaled(800));
  }
  inWindow_->setResult(result_);
  inWindow_->QWidget::show();
  inWindow_->raise();
  inWindow_->activateWindow();
}

void ColorSpacePage::show() {
  if (inWindow_) inWindow_->setResult(result_);
  if (!result_ || !result_->details || result_->around.size() <= kProbedMiddle) {
    view_->setScene({});
    return;
  }
  view_->setScene(colorScene(result_->around[kProbedMiddle], *result_->details, result_->settings, chosen_,
                             result_->whatIf));
  const bool isBounded = result_->settings.space.tone != ToneSpace::Linear;
  note_->setText(isBounded ? tr("highlights bounded, as the box has them") : tr("scene-linear"));
}

} // namespace taa::app
