#include "app/widgets/Swatches.h"

#include "app/style/Numbers.h"
#include "app/style/PictureImage.h"
#include "app/style/Theme.h"

#include "core/picture/ColorMap.h"
#include "core/taa/twin/Color.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace taa::app {

namespace {
constexpr int kCell = 16;
constexpr int kWideCell = 44; // holds a number of three digits
} // namespace

Swatches::Swatches(const QString& caption, QWidget* parent) : QWidget(parent), caption_(caption) {
  setFont(secondaryFont());
  setAccessibleName(tr("Neighborhood: %1").arg(caption));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Swatches::setColors(const std::optional<Colors>& linear) {
  values_ = linear;
  for (std::size_t i = 0; linear && i < colors_.size(); ++i)
    colors_[i] = shownColor({(*linear)[i][0], (*linear)[i][1], (*linear)[i][2]});
  QStringList texts;
  for (int cell = 0; linear && cell < 9; ++cell) texts << cellText(cell);
  if (!linear) texts << tr("no color");
  setAccessibleDescription(texts.join(QStringLiteral("; ")));
  update();
}

void Swatches::setWide(bool wide) {
  if (wide == isWide_) return;
  isWide_ = wide;
  updateGeometry();
  update();
}

int Swatches::wideWidth() {
  return 3 * scaled(kWideCell) + 1;
}

QRect Swatches::cellRect(int cell) const {
  const int wide = isWide_ ? scaled(kWideCell) : scaled(kCell);
  return {cell % 3 * wide, cell / 3 * scaled(kCell), wide, scaled(kCell)};
}

QString Swatches::cellText(int cell) const {
  if (!values_) return tr("no color");
  const auto signedText = [](int step) { return shortText(step); };
  return QStringLiteral("(%1, %2)  %3")
      .arg(signedText(cell % 3 - 1), signedText(cell / 3 - 1),
           tupleText(values_->at(static_cast<std::size_t>(cell)), 5));
}

QSize Swatches::sizeHint() const {
  return {std::max(3 * cellRect(0).width() + 1, fontMetrics().horizontalAdvance(caption_)),
          3 * scaled(kCell) + 1 + fontMetrics().height() + 2};
}

bool Swatches::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QString text = toolTip();
  for (int cell = 0; cell < 9; ++cell)
    if (cellRect(cell).contains(help->pos())) text = caption_ + QLatin1Char(' ') + cellText(cell);
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

void Swatches::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  if (!values_)
    painter.fillRect(0, 0, 3 * cellRect(0).width(), 3 * scaled(kCell), QBrush(colors.line, Qt::BDiagPattern));
  for (int cell = 0; values_ && cell < 9; ++cell) {
    const QColor& color = colors_[static_cast<std::size_t>(cell)];
    painter.fillRect(cellRect(cell), color);
    if (!isWide_) continue;
    const auto& [red, green, blue] = (*values_)[static_cast<std::size_t>(cell)];
    painter.setFont(numberFont());
    painter.setPen(color.lightness() > 128 ? Qt::black : Qt::white);
    painter.drawText(cellRect(cell), Qt::AlignCenter,
                     shortText(static_cast<double>(twin::luma({red, green, blue})), 2));
  }
  painter.setFont(font());
  painter.setPen(colors.line);
  painter.drawRect(0, 0, 3 * cellRect(0).width(), 3 * scaled(kCell));
  painter.setPen(colors.accent);
  painter.drawRect(cellRect(4));
  painter.setPen(colors.secondary);
  painter.drawText(QRect(0, 3 * scaled(kCell) + 2, width(), fontMetrics().height()),
                   Qt::AlignLeft | Qt::AlignVCenter, caption_);
}

} // namespace taa::app
