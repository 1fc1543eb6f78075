#include "app/learn/PartFrame.h"

#include "app/style/Theme.h"

#include <QEvent>
#include <QPainter>
#include <QPen>

#include <utility>

namespace taa::app {

namespace {

constexpr int kFrameWidth = 2;

/// What of the part is seen, in its window: a panel may be scrolled in less room than it needs.
QRect seenPart(const QWidget& part) {
  const QWidget* window = part.window();
  QRect seen(part.mapTo(window, QPoint()), part.size());
  for (const QWidget* around = part.parentWidget(); around && around != window;
       around = around->parentWidget())
    seen &= QRect(around->mapTo(window, QPoint()), around->size());
  return seen;
}

} // namespace

PartFrame::PartFrame(QWidget* window) : QWidget(window) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void PartFrame::surround(QWidget* part) {
  part_ = part;
  follow();
}

/// All that it lies in: what moves one of them moves the part, which is not told.
void PartFrame::watch() {
  std::vector<QPointer<QWidget>> wanted;
  for (QWidget* at = part_; at && (at == part_ || !at->isWindow()); at = at->parentWidget())
    wanted.emplace_back(at);
  if (wanted == watched_) return;
  for (const QPointer<QWidget>& before : watched_)
    if (before) before->removeEventFilter(this);
  for (const QPointer<QWidget>& now : wanted) now->installEventFilter(this);
  watched_ = std::move(wanted);
}

void PartFrame::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QPen pen(themeColors(this).accent, kFrameWidth);
  pen.setJoinStyle(Qt::MiterJoin);
  painter.setPen(pen);
  painter.drawRect(rect().adjusted(kFrameWidth / 2, kFrameWidth / 2, -kFrameWidth / 2, -kFrameWidth / 2));
}

bool PartFrame::eventFilter(QObject* object, QEvent* event) {
  switch (event->type()) {
  case QEvent::Move:
  case QEvent::Resize:
  case QEvent::Show:
  case QEvent::Hide:
  case QEvent::ParentChange:
    follow();
    break;
  default:
    break;
  }
  return QWidget::eventFilter(object, event);
}

void PartFrame::follow() {
  watch();
  if (!part_ || !part_->isVisible()) {
    hide();
    return;
  }
  if (parentWidget() != part_->window()) setParent(part_->window()); // a panel may have been torn off
  show();
  setGeometry(seenPart(*part_));
  raise();
}

} // namespace taa::app
