#include "app/views/ViewHeader.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/legend/RangeMath.h"
#include "app/widgets/ChannelButtons.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/IntermediateRow.h"
#include "app/widgets/bars/OverflowPopup.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "app/widgets/parameters/NumberField.h"
#include "core/taa/ChannelNames.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <string>

namespace taa::app {

namespace {

constexpr int kHeaderLetter = 18;
constexpr int kHeaderGap = 4;

QString zoomText(double zoom) {
  return zoom >= 1.0 ? QStringLiteral("%1×").arg(shortText(zoom))
                     : QStringLiteral("%1 %").arg(shortText(zoom * 100));
}

} // namespace

ViewHeader::ViewHeader(QChar letter, QWidget* parent)
    : QWidget(parent), letter_(letter), row_(intermediate(IntermediateId::resolved)) {
  setFixedHeight(barHeight());
  makeControls();
  nameControls();
  connectControls();
}

int ViewHeader::barHeight() {
  return scaled(28);
}

void ViewHeader::makeControls() {
  name_ = new ChoiceButton(this);
  name_->setObjectName(QStringLiteral("name"));
  name_->setFont(font());
  name_->setFlat(true);
  channels_ = new ChannelButtons(this);
  low_ = new NumberField({}, this);
  low_->setToolTip(tr("Value drawn as the low end of the range"));
  high_ = new NumberField({}, this);
  high_->setToolTip(tr("Value drawn as the high end of the range"));
  exposure_ = new NumberField({-20, 20, false, 0.5}, this);
  exposure_->setPrefix(tr("EV"));
  exposure_->setToolTip(tr("Exposure in stops, before the range (E, Shift+E)"));
  auto_ = new IconButton(QStringLiteral("auto-range"),
                         tr("Fit the range to the visible values (N); right click: always"), this);
  auto_->setContextMenuPolicy(Qt::CustomContextMenu);
  auto_->setCheckable(true);
  reset_ = new IconButton(QStringLiteral("reset"), tr("Show it as it opened (R)"), this);
  map_ = new ChoiceButton(this);
  map_->setToolTip(tr("Color map (M)"));
  QStringList maps;
  for (const ColorMap map : kColorMaps) maps << qtext(colorMapName(map));
  map_->setChoices(maps);
  compare_ = new IconButton(QStringLiteral("compare"),
                            tr("Compare with another intermediate, preset or frame (C)"), this);
  compare_->setCheckable(true);
  histogram_ = new IconButton(QStringLiteral("histogram"), tr("Histogram of the visible values (H)"), this);
  histogram_->setCheckable(true);
  overlays_ = new IconButton(QStringLiteral("overlays"), tr("What lies over the picture"), this);
  showing_ = new ChoiceButton(this);
  showing_->setToolTip(tr("Which of both sides is shown (O; Shift+O: divider; hold Shift: the other one)"));
  showing_->setAccessibleName(tr("Which of both sides is shown"));
  showing_->setChoices({tr("This side"), tr("Other side"), tr("Difference"), tr("Divider")});
  zoom_ = new ChoiceButton(this);
  zoom_->setFlat(true);
  zoom_->setPlain(true);
  makeOverflow();
  zoom_->setToolTip(tr("Screen pixels for each pixel; a click changes between fit (F) and one to one (1)"));
}

// What a screen reader says of controls that show only values.
void ViewHeader::nameControls() {
  name_->setAccessibleName(tr("Intermediate on show"));
  low_->setAccessibleName(tr("Low end of the range"));
  high_->setAccessibleName(tr("High end of the range"));
  exposure_->setAccessibleName(tr("Exposure in stops"));
  map_->setAccessibleName(tr("Color map"));
  zoom_->setAccessibleName(tr("Zoom"));
}

void ViewHeader::connectControls() {
  connect(name_, &ChoiceButton::requested, this, &ViewHeader::intermediateRequested);
  connect(zoom_, &ChoiceButton::requested, this, &ViewHeader::zoomClicked);
  connect(reset_, &IconButton::clicked, this, &ViewHeader::resetRequested);
  connect(auto_, &IconButton::clicked, this, &ViewHeader::autoRangeRequested);
  connect(auto_, &QWidget::customContextMenuRequested, this, &ViewHeader::alwaysAutoToggled);
  connect(compare_, &IconButton::clicked, this, &ViewHeader::comparisonRequested);
  connect(histogram_, &IconButton::clicked, this, &ViewHeader::histogramToggled);
  connect(overlays_, &IconButton::clicked, this, &ViewHeader::overlaysRequested);
  connect(showing_, &ChoiceButton::chosen, this,
          [this](int index) { Q_EMIT showingChosen(static_cast<Showing>(index)); });
  connect(map_, &ChoiceButton::chosen, this, [this](int index) {
    ViewStyle style = style_;
    style.map = kColorMaps[index];
    editStyle(style);
  });
  const auto edits = [this](NumberField* field, float ViewStyle::*member) {
    connect(field, &NumberField::valueEdited, this, [this, member](double value) {
      ViewStyle style = style_;
      style.*member = static_cast<float>(value);
      editStyle(style);
    });
  };
  edits(low_, &ViewStyle::low);
  edits(high_, &ViewStyle::high);
  edits(exposure_, &ViewStyle::exposure);
  connect(channels_, &ChannelButtons::toggled, this, [this](int channel) {
    ViewStyle style = style_;
    setShown(style, channel, !isShown(style, channel));
    editStyle(style);
  });
  connect(channels_, &ChannelButtons::soloed, this, [this](int channel) {
    ViewStyle style = style_;
    const bool isAlone = isShown(style, channel) && shownChannels(row_, style) == 1;
    for (int other = 0; other < 3; ++other) setShown(style, other, isAlone || other == channel);
    editStyle(style);
  });
}

void ViewHeader::editStyle(const ViewStyle& style) {
  setContent(row_, style, space_);
  Q_EMIT styleEdited(style);
}

void ViewHeader::setContent(const Intermediate& row, const ViewStyle& style, const SpaceSettings& space) {
  row_ = row;
  style_ = style;
  space_ = space;
  name_->setCaption(qtext(row.label));
  name_->setToolTip(intermediateToolTip(row));
  QStringList names;
  if (row.channels > 1)
    for (const std::string& name : channelNames(row, space)) names << QString::fromStdString(name);
  channels_->setNames(names);
  channels_->setShown({style.red, style.green, style.blue});
  low_->setValue(style.low);
  high_->setValue(style.high);
  exposure_->setValue(style.exposure);
  for (int index = 0; index < static_cast<int>(std::size(kColorMaps)); ++index)
    if (kColorMaps[index] == style.map) map_->setCurrent(index);
  arrange();
}

void ViewHeader::setZoom(double zoom, bool fit) {
  zoom_->setCaption(fit ? tr("fit · %1").arg(zoomText(zoom)) : zoomText(zoom));
  arrange();
}

void ViewHeader::setActive(bool active) {
  active_ = active;
  update();
}

void ViewHeader::setAlwaysAuto(bool always) {
  auto_->setChecked(always);
}

void ViewHeader::setComparing(bool compares, bool hasDifference, Showing showing) {
  compares_ = compares;
  compare_->setChecked(compares);
  showing_->setCurrent(static_cast<int>(showing));
  showing_->setToolTip(
      hasDifference ? tr("Which of both sides is shown (O; Shift+O: divider; hold Shift: the other one)")
                    : tr("Which of both sides is shown (O); they have no difference: one has more channels"));
  arrange();
}

void ViewHeader::setHistogramShown(bool shown) {
  histogram_->setChecked(shown);
}

QPoint ViewHeader::overlaysPlace() const {
  const QWidget* button = overlays_->parentWidget() == this && overlays_->isVisible()
                              ? static_cast<const QWidget*>(overlays_)
                              : more_;
  return button->geometry().bottomLeft() + QPoint(0, 1);
}

std::vector<ViewHeader::Item> ViewHeader::items() const {
  return {{name_, {}, true, 0},
          {channels_, tr("Channels"), row_.channels > 1, 2},
          {map_, tr("Color map"), usesColorMap(row_, style_), 6},
          {low_, tr("Range from"), hasRange(row_), 4},
          {high_, tr("to"), hasRange(row_), 4},
          {auto_, tr("Fit the range"), hasRange(row_), 5},
          {histogram_, tr("Histogram"), hasRange(row_), 7},
          {exposure_, tr("Exposure"), hasExposure(row_), 3},
          {reset_, tr("As it opened"), true, 8},
          {compare_, tr("Compare with…"), true, 7},
          {showing_, tr("Shown side"), compares_, 5},
          {overlays_, tr("Overlays"), true, 7},
          {zoom_, {}, true, 1}};
}

namespace {

/// Marks those that find room; whether all that are wanted do.
template <class Items>
bool fitInto(Items& items, int room, int gap) {
  bool isAll = true;
  for (auto& item : items) item.isShown = false;
  for (int rank = 0; rank <= 8; ++rank) {
    int needed = 0;
    for (auto& item : items)
      if (item.rank == rank && item.isWanted) needed += (item.width = item.widget->sizeHint().width()) + gap;
    if (rank > 0 && needed > room) {
      isAll = isAll && needed == 0;
      continue;
    }
    for (auto& item : items)
      if (item.rank == rank && item.isWanted) {
        item.width = std::min(item.width, std::max(0, room));
        item.isShown = true;
      }
    room -= needed;
  }
  return isAll;
}

} // namespace

void ViewHeader::arrange() {
  std::vector<Item> all = items();
  int left = 2 * kUnit + scaled(kHeaderLetter) + kHeaderGap;
  const int room = width() - left - kUnit, moreWidth = more_->sizeHint().width();
  const bool isAll = fitInto(all, room, kHeaderGap);
  if (!isAll) fitInto(all, room - moreWidth - kHeaderGap, kHeaderGap);
  more_->setVisible(!isAll);
  int right = width() - kUnit;
  for (const Item& item : all) {
    if (overflow_->holds(item.widget)) continue;
    item.widget->setVisible(item.isShown);
    if (!item.isShown) continue;
    const int top = (barHeight() - rowHeight()) / 2;
    if (item.widget == zoom_) {
      right -= item.width; // at the right end
      item.widget->setGeometry(right, top, item.width, rowHeight());
      right -= kHeaderGap;
      continue;
    }
    item.widget->setGeometry(left, top, item.width, rowHeight());
    left += item.width + kHeaderGap;
  }
  if (!isAll) more_->setGeometry(right - moreWidth, (barHeight() - rowHeight()) / 2, moreWidth, rowHeight());
}

void ViewHeader::makeOverflow() {
  more_ = new IconButton(QStringLiteral("more"), tr("More about this view, which has no room here"), this);
  more_->setObjectName(QStringLiteral("more"));
  overflow_ = new OverflowPopup(this);
  connect(more_, &IconButton::clicked, this, &ViewHeader::openOverflow);
  connect(overflow_, &OverflowPopup::closed, this, &ViewHeader::arrange);
  // What opens something else, or is done, closes the list first.
  for (IconButton* button : {auto_, histogram_, reset_, compare_, overlays_})
    connect(button, &IconButton::clicked, overflow_, &QWidget::hide);
}

void ViewHeader::openOverflow() {
  Q_EMIT pressed();
  OverflowPopup::Controls hidden;
  for (const Item& item : items())
    if (item.isWanted && !item.widget->isVisibleTo(this)) hidden.emplace_back(item.widget, item.name);
  overflow_->open(hidden, more_->geometry().bottomRight() + QPoint(1, 1));
}

void ViewHeader::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  paintViewLetter(
      painter,
      {2 * kUnit, (barHeight() - scaled(kHeaderLetter)) / 2, scaled(kHeaderLetter), scaled(kHeaderLetter)},
      letter_, active_, colors);
}

void ViewHeader::resizeEvent(QResizeEvent*) {
  arrange();
}

void ViewHeader::mousePressEvent(QMouseEvent*) {
  Q_EMIT pressed();
}

} // namespace taa::app
