#include "app/widgets/PictureBox.h"

#include "app/style/PictureImage.h"
#include "app/style/Theme.h"

#include <QPainter>

namespace taa::app {

PictureBox::PictureBox(const QString& name, QWidget* parent) : QWidget(parent), caption_(name) {
  setAccessibleName(name);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PictureBox::setPicture(const Picture& picture, const QString& missing) {
  picture_ = imageOver(picture).convertToFormat(QImage::Format_ARGB32);
  missing_ = missing;
  setAccessibleDescription(picture_.isNull() ? missing : QString());
  update();
}

void PictureBox::setCaption(const QString& caption) {
  caption_ = caption;
  update();
}

// Pixels are squares where they are enlarged, as in views.
void PictureBox::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  const QRect words(0, height() - rowHeight(), width(), rowHeight());
  const QRect place(0, 0, width(), height() - rowHeight());
  painter.fillRect(place, colors.surround);
  painter.setFont(secondaryFont());
  painter.setPen(colors.secondary);
  painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft,
                   painter.fontMetrics().elidedText(caption_, Qt::ElideRight, width()));
  if (picture_.isNull()) {
    painter.setPen(colors.text);
    painter.drawText(place.adjusted(kUnit, kUnit, -kUnit, -kUnit), Qt::AlignCenter | Qt::TextWordWrap,
                     missing_);
    return;
  }
  const QSizeF fit = QSizeF(picture_.size()).scaled(place.size(), Qt::KeepAspectRatio);
  const QRectF target(place.x() + (place.width() - fit.width()) / 2,
                      place.y() + (place.height() - fit.height()) / 2, fit.width(), fit.height());
  painter.setRenderHint(QPainter::SmoothPixmapTransform, fit.width() < picture_.width());
  painter.drawImage(target, picture_);
}

} // namespace taa::app
