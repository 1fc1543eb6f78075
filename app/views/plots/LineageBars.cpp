#include "app/views/plots/LineageBars.h"

#include "app/models/verdict/LineageMath.h"
#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::app {

namespace {

constexpr double kTickSpace = 48.0, kBarValueSpace = 28.0; ///< px between ticks at least
constexpr double kBarShare = 0.8;                          ///< of a frame's width
constexpr int kEmptyFrames = 32;                           ///< shown where nothing is known

} // namespace

QColor ageColor(const QWidget* widget, double share) {
  const ThemeColors& colors = themeColors(widget);
  const auto mixed = [share](int young, int old) {
    return static_cast<int>(std::lround(young + std::sqrt(share) * (old - young)));
  };
  const QColor &young = colors.accent, &old = colors.secondary;
  return {mixed(young.red(), old.red()), mixed(young.green(), old.green()), mixed(young.blue(), old.blue())};
}

LineageBars::LineageBars(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setMinimumSize(200, 90);
  setAccessibleName(tr("How much each of the last frames counts in the pixel"));
  setToolTip(
      tr("How much the samples of each frame count, and, hatched upon them, what its rectification put "
         "in the place of history. A click goes to the frame."));
  fitAxes();
}

void LineageBars::setLineage(std::shared_ptr<const Lineage> lineage) {
  lineage_ = std::move(lineage);
  fitAxes();
}

void LineageBars::setHighlighted(std::optional<int> frame) {
  if (frame == highlighted_) return;
  highlighted_ = frame;
  update();
}

void LineageBars::fitAxes() {
  const int last = lineage_ ? lineage_->frame : 0;
  const int first =
      lineage_ && !lineage_->frames.empty() ? lineage_->frames.back().frame : last - kEmptyFrames;
  const double line = QFontMetricsF(secondaryFont()).height() + kUnit;
  const int rows = std::max(2, static_cast<int>((height() - 2.0 * line) / scaled(kBarValueSpace)));
  const int columns = std::max(2, static_cast<int>(width() / scaled(kTickSpace)));
  const Span frames{first - 0.5, last + 0.5};
  const Span weights = roundedSpan(lineage_ ? barSpan(*lineage_) : Span{}, rows);
  axes_.layOut({frames, std::max(1.0, roundStep(frames.length(), columns))},
               {weights, tickStep(weights, rows)}, QRectF(rect()).adjusted(kUnit, line, -2.0 * kUnit, -1.0));
  update();
}

QRectF LineageBars::boxOf(int frame, double from, double to) const {
  const double half = 0.5 * kBarShare;
  return QRectF(axes_.pointOf({frame - half, std::max(from, to)}),
                axes_.pointOf({frame + half, std::min(from, to)}));
}

QRectF LineageBars::barOf(const LineageFrame& entry) const {
  return boxOf(entry.frame, 0.0, entry.weight);
}

QRectF LineageBars::rectifiedOf(const LineageFrame& entry) const {
  return boxOf(entry.frame, entry.weight, entry.weight + entry.rectified);
}

std::optional<int> LineageBars::frameAt(double viewX) const {
  if (!lineage_) return {};
  const QRectF& plot = axes_.plot();
  const Span& frames = axes_.x().range;
  const double frame = frames.low + (viewX - plot.left()) / std::max(plot.width(), 1.0) * frames.length();
  const int nearest = static_cast<int>(std::lround(frame));
  if (frame < frames.low || frame > frames.high) return {};
  return nearest;
}

QString LineageBars::readout() const {
  const QString title = tr("Weight by frame"), key = tr("hatched: what rectification put there");
  if (!lineage_) return title;
  const QString whole = title + QStringLiteral("  ") + key;
  // Its tip has the key, too.
  const double room = width() - 2.0 * kUnit;
  if (!highlighted_) return QFontMetricsF(secondaryFont()).horizontalAdvance(whole) <= room ? whole : title;
  for (const LineageFrame& entry : lineage_->frames)
    if (entry.frame == *highlighted_)
      return tr("Frame %1: samples %2, rectification %3, %n pixel(s) read", nullptr, entry.pixels)
          .arg(entry.frame)
          .arg(shortText(entry.weight, 4), shortText(entry.rectified, 4));
  return title;
}

void LineageBars::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  axes_.paint(painter, colors);
  painter.setFont(secondaryFont());
  painter.setPen(colors.secondary);
  const QFontMetricsF letters(secondaryFont());
  const QRectF place(kUnit, 0.0, width() - 2.0 * kUnit, letters.height());
  painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                   letters.elidedText(readout(), Qt::ElideRight, place.width()));
  if (!lineage_) return;
  painter.setRenderHint(QPainter::Antialiasing);
  for (const LineageFrame& entry : lineage_->frames) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ageColor(this, ageShare(*lineage_, entry.frame)));
    painter.drawRect(barOf(entry));
    painter.setBrush(QBrush(colors.caution, Qt::BDiagPattern)); // told apart without color, too
    painter.setPen(QPen(colors.caution, 1.0));
    if (const QRectF box = rectifiedOf(entry); box.height() >= 1.0) painter.drawRect(box);
    if (highlighted_ != entry.frame) continue;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors.text, 1.0));
    painter.drawRect(barOf(entry).united(rectifiedOf(entry)));
  }
}

void LineageBars::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitAxes();
}

void LineageBars::mouseMoveEvent(QMouseEvent* event) {
  const std::optional<int> frame = frameAt(event->position().x());
  if (frame != highlighted_) Q_EMIT hovered(frame);
}

void LineageBars::mousePressEvent(QMouseEvent* event) {
  if (const auto frame = frameAt(event->position().x()); frame && event->button() == Qt::LeftButton)
    Q_EMIT chosen(*frame);
}

void LineageBars::leaveEvent(QEvent*) {
  Q_EMIT hovered({});
}

} // namespace taa::app
