#include "app/widgets/SectionHeader.h"

#include "app/style/Icons.h"
#include "app/style/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <utility>

namespace taa::app {

SectionHeader::SectionHeader(const QString& title, QWidget* parent) : QAbstractButton(parent) {
  setText(title);
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SectionHeader::setSummary(const QString& summary) {
  summary_ = summary;
  update();
}

void SectionHeader::setNote(const QString& note) {
  if (note == note_) return;
  note_ = note;
  setAccessibleDescription(note);
  update();
}

void SectionHeader::setHasThumbnail(bool has) {
  if (has == hasThumbnail_) return;
  hasThumbnail_ = has;
  thumbnail_ = {};
  updateGeometry();
  update();
}

void SectionHeader::setThumbnail(const QImage& thumbnail) {
  thumbnail_ = thumbnail;
  update();
}

QRect SectionHeader::thumbnailRect() const {
  if (!hasThumbnail_) return {};
  QSize size = kThumbnailSize;
  if (!thumbnail_.isNull()) size = thumbnail_.size().scaled(kThumbnailSize, Qt::KeepAspectRatio);
  return {QPoint(width() - 2 * kUnit - size.width(), (height() + 1 - size.height()) / 2), size};
}

QSize SectionHeader::sizeHint() const {
  return {120, hasThumbnail_ ? scaled(kThumbnailSize.height()) + kUnit + 1 : rowHeight() + kUnit};
}

void SectionHeader::paintThumbnail(QPainter& painter) const {
  const QRect place = thumbnailRect();
  const ThemeColors& colors = themeColors(this);
  painter.fillRect(place, colors.surround);
  if (!thumbnail_.isNull()) painter.drawImage(place, thumbnail_);
  if (!overThumbnail_) return;
  painter.setPen(colors.accent);
  painter.drawRect(place.adjusted(0, 0, -1, -1));
}

void SectionHeader::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  if (underMouse()) painter.fillRect(rect(), colors.hover);
  painter.fillRect(0, 0, width(), 1, colors.line);
  if (hasFocus()) {
    painter.setPen(colors.accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
  const QString chevron = isChecked() ? QStringLiteral("chevron-down") : QStringLiteral("chevron-right");
  const int icon = scaled(12);
  painter.drawPixmap(kUnit, (height() - icon) / 2,
                     iconPixmap(chevron, colors.secondary, icon, devicePixelRatioF()));

  QFont bold = font();
  bold.setBold(true);
  const bool hasSummary = !isChecked() && !summary_.isEmpty(); // else the settings themselves are in sight
  QRect inside = rect().adjusted(icon + 2 * kUnit, 0, -2 * kUnit, 0);
  painter.setFont(bold);
  painter.setPen(colors.text);
  if (hasThumbnail_) {
    paintThumbnail(painter);
    inside.setRight(width() - 2 * kUnit - kThumbnailSize.width() - 2 * kUnit);
    QStringList lines;
    if (hasSummary) lines << summary_;
    if (!note_.isEmpty()) lines << note_;
    paintLines(painter, inside, lines);
    return;
  }
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignLeft, text());
  if (!hasSummary) return;
  const int used = QFontMetrics(bold).horizontalAdvance(text()) + 3 * kUnit;
  painter.setFont(secondaryFont());
  painter.setPen(colors.secondary);
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignRight,
                   QFontMetrics(secondaryFont()).elidedText(summary_, Qt::ElideRight, inside.width() - used));
}

// The name and what stands below it, together in the middle.
void SectionHeader::paintLines(QPainter& painter, QRect inside, const QStringList& lines) const {
  const QFontMetrics small(secondaryFont()), large(painter.font());
  int top =
      inside.top() + (inside.height() - large.height() - static_cast<int>(lines.size()) * small.height()) / 2;
  painter.drawText(QRect(inside.left(), top, inside.width(), large.height()), Qt::AlignLeft, text());
  top += large.height();
  painter.setFont(secondaryFont());
  painter.setPen(themeColors(this).secondary);
  for (const QString& line : lines) {
    painter.drawText(QRect(inside.left(), top, inside.width(), small.height()), Qt::AlignLeft,
                     small.elidedText(line, Qt::ElideRight, inside.width()));
    top += small.height();
  }
}

void SectionHeader::setOverThumbnail(bool over) {
  if (over == overThumbnail_) return;
  overThumbnail_ = over;
  setCursor(over ? Qt::PointingHandCursor : Qt::ArrowCursor);
  update();
}

void SectionHeader::mousePressEvent(QMouseEvent* event) {
  pressedThumbnail_ =
      event->button() == Qt::LeftButton && thumbnailRect().contains(event->position().toPoint());
  if (!pressedThumbnail_) QAbstractButton::mousePressEvent(event);
}

void SectionHeader::mouseReleaseEvent(QMouseEvent* event) {
  if (!std::exchange(pressedThumbnail_, false)) {
    QAbstractButton::mouseReleaseEvent(event);
    return;
  }
  if (thumbnailRect().contains(event->position().toPoint())) Q_EMIT thumbnailClicked();
}

void SectionHeader::mouseMoveEvent(QMouseEvent* event) {
  setOverThumbnail(thumbnailRect().contains(event->position().toPoint()));
  QAbstractButton::mouseMoveEvent(event);
}

void SectionHeader::leaveEvent(QEvent* event) {
  setOverThumbnail(false);
  QAbstractButton::leaveEvent(event);
}

void SectionHeader::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
}

} // namespace taa::app
