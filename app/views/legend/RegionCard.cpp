#include "app/views/legend/RegionCard.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/areas/FittingArea.h"

#include "core/picture/RegionSpreadText.h"
#include "core/taa/ChannelNames.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

/// As the histogram of a range, without its handles.
class RegionBars : public QWidget {
 public:
  static constexpr int kBarsHeight = 44, kRegionBarWidth = 3, kBarsFoot = 16;

  RegionBars() {
    setFixedSize(scaled(kRegionBins * kRegionBarWidth), scaled(kBarsHeight + kBarsFoot));
    setAccessibleName(RegionCard::tr("Histogram of the region"));
  }

  void setSpread(const RegionSpread& spread) {
    counts_ = spread.counts;
    axis_ = spread.axis;
    setToolTip(
        axis_.isLogarithmic
            ? RegionCard::tr("How many values lie where, on a logarithmic axis; heights are logarithms")
            : RegionCard::tr("How many values lie where; heights are logarithms"));
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    if (counts_.empty()) return;
    const ThemeColors& colors = themeColors(this);
    QPainter painter(this);
    const int foot = height() - scaled(kBarsFoot);
    const double most = std::log1p(*std::ranges::max_element(counts_)), column = 1.0 * width() / kRegionBins;
    for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
      if (counts_[bin] == 0) continue;
      const double tall = std::max(1.0, std::round(std::log1p(counts_[bin]) / most * foot));
      painter.fillRect(QRectF(static_cast<double>(bin) * column, foot - tall, column, tall),
                       colors.secondary);
    }
    painter.fillRect(0, foot, width(), 1, colors.line);
    painter.setFont(numberFont());
    painter.setPen(colors.secondary);
    const QRect texts(0, foot, width(), height() - foot);
    const QString low = shortText(static_cast<double>(axis_.low));
    painter.drawText(texts, Qt::AlignLeft | Qt::AlignVCenter,
                     axis_.isLogarithmic ? QStringLiteral("≤ ") + low : low);
    painter.drawText(texts, Qt::AlignRight | Qt::AlignVCenter, shortText(axis_.valueAt(1.0)));
    if (axis_.isLogarithmic) painter.drawText(texts, Qt::AlignCenter, RegionCard::tr("log"));
  }

 private:
  std::vector<int> counts_;
  HistogramAxis axis_;
};

RegionCard::RegionCard(QWidget* parent)
    : QFrame(parent), title_(new QLabel), body_(new QLabel), bars_(new RegionBars) {
  setAttribute(Qt::WA_NoMousePropagation); // a press on it moves no picture
  setCursor(Qt::ArrowCursor);
  setAccessibleName(tr("Statistics of the region"));
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kUnit);
  body_->setFont(numberFont());
  body_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(body_);
  column->addWidget(bars_);
  auto* area = new FittingArea(12 * kUnit);
  area->setWidget(content);
  content->setAutoFillBackground(false);
  auto* copy = new IconButton(QStringLiteral("copy"), tr("Copy the statistics, exact"));
  auto* close = new IconButton(QStringLiteral("close"), tr("Remove the region"));
  for (IconButton* button : {copy, close}) button->setFocusPolicy(Qt::TabFocus);
  auto* head = new QHBoxLayout;
  head->setSpacing(kUnit);
  head->addWidget(title_, 1);
  head->addWidget(copy);
  head->addWidget(close);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, kUnit, kUnit, 2 * kUnit);
  layout->setSpacing(kUnit);
  layout->addLayout(head);
  layout->addWidget(area);
  title_->setFont(secondaryFont());
  connect(copy, &IconButton::clicked, this, &RegionCard::copyRequested);
  connect(close, &IconButton::clicked, this, &RegionCard::removeRequested);
}

void RegionCard::setWaiting(const gl::Rect& region) {
  spread_.reset();
  title_->setText(
      tr("%1×%2 px at (%3, %4)").arg(region.width).arg(region.height).arg(region.x).arg(region.y));
  body_->setText(tr("The values are on their way"));
  bars_->hide();
  place();
}

void RegionCard::setSpread(const MeasuredContent& content, const RegionSpread& spread) {
  content_ = content;
  spread_ = spread;
  const gl::Rect& region = spread.region;
  title_->setText(tr("%1, frame %2\n%3×%4 px at (%5, %6)")
                      .arg(content.label)
                      .arg(content.frame)
                      .arg(region.width)
                      .arg(region.height)
                      .arg(region.x)
                      .arg(region.y));
  body_->setText(bodyText());
  bars_->setSpread(spread);
  bars_->setVisible(!spread.counts.empty() && spread.categories.empty());
  setAccessibleDescription(title_->text() + QLatin1Char('\n') + body_->text());
  place();
}

QString RegionCard::text() const {
  return body_->text();
}

QString RegionCard::exactText() const {
  return spread_ ? QString::fromStdString(spreadText(*spread_, content_.row, content_.space)) : QString();
}

// A line for each figure, a column for each channel.
QString RegionCard::bodyText() const {
  if (!spread_->categories.empty())
    return qtext(categoriesText(*spread_, content_.row)).replace(QLatin1String(", "), QLatin1String("\n"));
  std::vector<std::pair<QString, QStringList>> lines;
  const auto addLine = [&](const QString& name, const auto& valueOf) {
    QStringList cells;
    for (const ChannelSpread& channel : spread_->channels) cells << valueOf(channel);
    lines.emplace_back(name, cells);
  };
  const auto number = [](const ChannelSpread& of, double value) {
    return of.count > 0 ? shortText(value, 4) : QStringLiteral("—");
  };
  if (content_.row.channels > 1) {
    QStringList names;
    for (const std::string& name : channelNames(content_.row, content_.space)) names << qtext(name);
    lines.emplace_back(QString(), names);
  }
  addLine(tr("max"), [&](const ChannelSpread& of) { return number(of, static_cast<double>(of.max)); });
  for (std::size_t index = kPercentiles.size(); index-- > 0;)
    addLine(kPercentiles[index] == 50 ? tr("median") : QStringLiteral("%1 %").arg(kPercentiles[index]),
            [&](const ChannelSpread& of) { return number(of, static_cast<double>(of.percentiles[index])); });
  addLine(tr("min"), [&](const ChannelSpread& of) { return number(of, static_cast<double>(of.min)); });
  addLine(tr("mean"), [&](const ChannelSpread& of) { return number(of, of.mean); });
  addLine(tr("deviation"), [&](const ChannelSpread& of) { return number(of, of.deviation); });
  addLine(tr("NaN"), [](const ChannelSpread& of) { return QString::number(of.nan); });
  const auto hasAny = [&](int ChannelSpread::*field) {
    return std::ranges::any_of(spread_->channels, [&](const ChannelSpread& of) { return of.*field > 0; });
  };
  if (hasAny(&ChannelSpread::infinite))
    addLine(tr("infinite"), [](const ChannelSpread& of) { return QString::number(of.infinite); });
  if (hasAny(&ChannelSpread::absent))
    addLine(tr("no value"), [](const ChannelSpread& of) { return QString::number(of.absent); });
  qsizetype nameWidth = 0, cellWidth = 0;
  for (const auto& [name, cells] : lines) {
    nameWidth = std::max(nameWidth, name.size());
    for (const QString& cell : cells) cellWidth = std::max(cellWidth, cell.size());
  }
  QStringList texts;
  for (const auto& [name, cells] : lines) {
    QString line = name.leftJustified(static_cast<int>(nameWidth));
    for (const QString& cell : cells)
      line += QStringLiteral("  ") + cell.rightJustified(static_cast<int>(cellWidth));
    texts << line;
  }
  return texts.join(QLatin1Char('\n'));
}

// As wide as its texts and as high as its lines; in a small view what has no room scrolls. The legend stays
// free.
void RegionCard::place() {
  constexpr int kMargin = 2 * kUnit, kBelowLabel = 8 * kUnit, kScrollBar = 3 * kUnit;
  const QWidget* under = parentWidget();
  const QMargins around = layout()->contentsMargins();
  const int buttons = scaled(2 * 26) + kUnit;
  const QSize texts = body_->sizeHint(), title = title_->sizeHint();
  const bool hasBars = !bars_->isHidden();
  const int wide = std::max({title.width() + buttons, texts.width(), hasBars ? bars_->width() : 0}) +
                   around.left() + around.right() + kScrollBar;
  const int high = std::max(title.height(), rowHeight()) + texts.height() + around.top() + around.bottom() +
                   2 * kUnit + (hasBars ? kUnit + bars_->height() : 0);
  const int width = std::min(wide, under->width() - 2 * kMargin);
  const int height = std::min(high, under->height() - kBelowLabel - kMargin - rowHeight());
  setGeometry(under->width() - width - kMargin, kBelowLabel, width, height);
}

void RegionCard::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  painter.setPen(colors.line);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace taa::app
