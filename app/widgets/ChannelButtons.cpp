#include "app/widgets/ChannelButtons.h"

#include "app/style/Theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace taa::app {

ChannelButtons::ChannelButtons(QWidget* parent) : QWidget(parent) {
  setFont(secondaryFont());
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setToolTip(tr("Channels: a click shows or hides one, a right click shows it alone."));
}

void ChannelButtons::setNames(const QStringList& names) {
  if (names == names_) return;
  names_ = names;
  updateGeometry();
  update();
}

void ChannelButtons::setShown(const std::array<bool, 3>& shown) {
  shown_ = shown;
  update();
}

QRect ChannelButtons::button(int channel) const {
  int widest = 0;
  for (const QString& name : names_) widest = std::max(widest, fontMetrics().horizontalAdvance(name));
  const int width = widest + 3 * kUnit;
  return {channel * width, 1, width, rowHeight() - 3};
}

QSize ChannelButtons::sizeHint() const {
  const int count = static_cast<int>(names_.size());
  return {count == 0 ? 0 : button(count - 1).right() + 2, rowHeight()};
}

void ChannelButtons::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  for (int channel = 0; channel < names_.size(); ++channel) {
    const bool on = shown_[static_cast<std::size_t>(channel)];
    const QRect box = button(channel);
    painter.fillRect(box, on ? colors.line : colors.field);
    painter.setPen(colors.line);
    painter.drawRect(box);
    painter.setPen(on ? colors.text : colors.secondary);
    painter.drawText(box, Qt::AlignCenter, names_[channel]);
  }
}

void ChannelButtons::mousePressEvent(QMouseEvent* event) {
  for (int channel = 0; channel < names_.size(); ++channel)
    if (button(channel).contains(event->position().toPoint())) {
      if (event->button() == Qt::RightButton)
        Q_EMIT soloed(channel);
      else
        Q_EMIT toggled(channel);
    }
}

} // namespace taa::app
