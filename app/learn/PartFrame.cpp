#include "app/learn/PartFrame.h"

#include "app/style/Theme.h"

#include <QEvent>
#include <QPainter>
#include <QPen>

namespace taa::app {

namespace {

constexpr int kFrameWidth = 2;

} // namespace

PartFrame::PartFrame(QWidget* window) : QWidget(window) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void PartFrame::surround(QWidget* part) {
  if (part_) part_->removeEventFilter(this);
  part_ = part;
  if (part_) part_->installEventFilter(this);
  follow();
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
    follow();
    break;
  default:
    break;
  }
  return QWidget::eventFilter(object, event);
}

void PartFrame::follow() {
  if (!part_ || !part_->isVisible()) return hide();
  if (parentWidget() != part_->window()) setParent(part_->window()); // a panel may have been torn off
  show();
  setGeometry({part_->mapTo(parentWidget(), QPoint()), part_->size()});
  raise();
}

} // namespace taa::app
