#include "app/views/plots/ColorSpacePage.h"

#include "app/style/Theme.h"
#include "app/views/plots/ColorSpaceView.h"
#include "app/widgets/parameters/SegmentedButtons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace taa::app {

namespace {

QLabel* makeNote() {
  auto* note = new QLabel;
  note->setFont(secondaryFont());
  note->setForegroundRole(QPalette::PlaceholderText);
  note->setWordWrap(true);
  return note;
}

} // namespace

ColorSpacePage::ColorSpacePage(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kUnit);
  auto* line = new QHBoxLayout;
  line->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, 0);
  spaces_ = new SegmentedButtons({tr("RGB"), tr("YCoCg")});
  spaces_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  spaces_->setAccessibleName(tr("Axes of the color space plot"));
  note_ = makeNote();
  line->addWidget(spaces_);
  line->addWidget(note_, 1);
  column->addLayout(line);
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

void ColorSpacePage::show() {
  if (!result_ || !result_->details || result_->around.size() <= kProbedMiddle) return view_->setScene({});
  view_->setScene(colorScene(result_->around[kProbedMiddle], *result_->details, result_->settings, chosen_,
                             result_->whatIf));
  const bool isBounded = result_->settings.space.tone != ToneSpace::Linear;
  note_->setText(isBounded ? tr("highlights bounded, as the box has them") : tr("scene-linear"));
}

} // namespace taa::app
