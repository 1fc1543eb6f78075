#include "app/doctor/ResidualBars.h"

#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "core/base/NumberText.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa::app {

namespace {

constexpr int kResidualRow = 18, kResidualBar = 8; ///< px
constexpr int kLongestBar = 48;                    ///< px, of the longest: words may have the rest

int widestOf(const std::vector<ResidualBars::Bar>& bars, const QFontMetrics& metrics,
             QString ResidualBars::Bar::*text) {
  int widest = 0;
  for (const ResidualBars::Bar& bar : bars) widest = std::max(widest, metrics.horizontalAdvance(bar.*text));
  return widest;
}

} // namespace

ResidualBars::ResidualBars(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("What each explanation leaves"));
}

void ResidualBars::setResiduals(const std::vector<doctor::Residual>& residuals) {
  bars_.clear();
  double largest = 0.0;
  for (const doctor::Residual& residual : residuals)
    if (std::isfinite(residual.value)) largest = std::max(largest, residual.value);
  QStringList said;
  for (const doctor::Residual& residual : residuals) {
    const QString mark = residual.isBest ? tr("fits") : residual.isGiven ? tr("what is stored") : QString();
    const double share = largest > 0.0 ? std::clamp(residual.value / largest, 0.0, 1.0) : 0.0;
    bars_.push_back({qtext(residual.text), mark, qtext(shortNumber(residual.value)), share, residual.isGiven,
                     residual.isBest});
    said << bars_.back().label + QLatin1Char(' ') + bars_.back().number +
                (mark.isEmpty() ? QString() : QStringLiteral(", ") + mark);
  }
  setAccessibleDescription(said.join(QStringLiteral("; ")));
  updateGeometry();
  update();
}

QSize ResidualBars::sizeHint() const {
  return {320, scaled(kResidualRow) * static_cast<int>(bars_.size())};
}

QSize ResidualBars::minimumSizeHint() const {
  return {160, sizeHint().height()};
}

int ResidualBars::heightForWidth(int width) const {
  return rowTop(static_cast<int>(bars_.size()), columns(width));
}

int ResidualBars::rowHeight(int line, const Columns& at) const {
  const Bar& bar = bars_[static_cast<std::size_t>(line)];
  const QRect room(0, 0, labelRoom(bar, at), QWIDGETSIZE_MAX);
  const int words =
      QFontMetrics(secondaryFont()).boundingRect(room, Qt::TextWordWrap | Qt::AlignLeft, bar.label).height();
  return std::max(scaled(kResidualRow), words);
}

int ResidualBars::rowTop(int line, const Columns& at) const {
  int top = 0;
  for (int before = 0; before < line; ++before) top += rowHeight(before, at);
  return top;
}

int ResidualBars::labelRoom(const Bar& bar, const Columns& at) {
  return std::max(1, (bar.mark.isEmpty() ? at.number : at.mark) - at.label - 2 * kUnit);
}

/// Of the column of labels, which go on into the next one where that is empty; 1 px for what is rounded.
int ResidualBars::wantedLabel(int mark) const {
  const QFontMetrics words(secondaryFont());
  int wanted = 0;
  for (const Bar& bar : bars_)
    wanted = std::max(wanted,
                      words.horizontalAdvance(bar.label) + 1 + 2 * kUnit - (bar.mark.isEmpty() ? mark : 0));
  return wanted;
}

ResidualBars::Columns ResidualBars::columns(int width) const {
  const QFontMetrics words(secondaryFont()), numbers(numberFont());
  const int mark = widestOf(bars_, words, &Bar::mark) + 2 * kUnit,
            number = widestOf(bars_, numbers, &Bar::number) + 2 * kUnit;
  const int room = std::max(0, width - mark - number - scaled(kLongestBar) - kUnit);
  const int label = std::min(wantedLabel(mark), room);
  return {0, label, label + mark, label + mark + number};
}

bool ResidualBars::areLabelsWhole() const {
  const Columns at = columns(width());
  const QFontMetrics words(secondaryFont());
  return height() >= heightForWidth(width()) && std::ranges::all_of(bars_, [&](const Bar& bar) {
           const QStringList parts = bar.label.split(QLatin1Char(' '));
           return std::ranges::all_of(parts, [&](const QString& word) {
             return words.horizontalAdvance(word) <= labelRoom(bar, at);
           });
         });
}

QRectF ResidualBars::barRect(int line) const {
  const Columns at = columns(width());
  const double longest = std::max(0, width() - at.bar - kUnit);
  return {static_cast<double>(at.bar), rowTop(line, at) + (scaled(kResidualRow) - scaled(kResidualBar)) / 2.0,
          std::max(1.0, bars_[static_cast<std::size_t>(line)].share * longest),
          static_cast<double>(scaled(kResidualBar))};
}

void ResidualBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  for (int line = 0; line < static_cast<int>(bars_.size()); ++line) paintLine(painter, line);
}

void ResidualBars::paintLine(QPainter& painter, int line) const {
  const ThemeColors& colors = themeColors(this);
  const Bar& bar = bars_[static_cast<std::size_t>(line)];
  const Columns at = columns(width());
  const int top = rowTop(line, at);
  const auto cell = [top](int from, int to) {
    return QRect(from, top, std::max(0, to - from - 2 * kUnit), scaled(kResidualRow));
  };
  painter.setFont(secondaryFont());
  const bool isMarked = bar.isBest || bar.isGiven;
  painter.setPen(isMarked ? colors.text : colors.secondary);
  const int height = rowHeight(line, at);
  const QRect label(at.label, top, labelRoom(bar, at), height);
  const bool isOneLine = height == scaled(kResidualRow);
  painter.drawText(label, Qt::TextWordWrap | Qt::AlignLeft | (isOneLine ? Qt::AlignVCenter : Qt::AlignTop),
                   bar.label);
  painter.drawText(cell(at.mark, at.number), Qt::AlignVCenter | Qt::AlignLeft, bar.mark);
  painter.setFont(numberFont());
  painter.drawText(cell(at.number, at.bar), Qt::AlignVCenter | Qt::AlignRight, bar.number);
  painter.fillRect(barRect(line), bar.isBest ? colors.right : bar.isGiven ? colors.wrong : colors.secondary);
}

bool ResidualBars::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto count = static_cast<int>(bars_.size());
  const Columns at = columns(width());
  int line = 0;
  while (line < count && help->pos().y() >= rowTop(line + 1, at)) ++line;
  if (line >= count) return QWidget::event(event);
  const Bar& bar = bars_[static_cast<std::size_t>(line)];
  QToolTip::showText(help->globalPos(), bar.label + QStringLiteral(": ") + bar.number, this);
  return true;
}

} // namespace taa::app
