#include "app/widgets/bars/MenuTitle.h"

#include "app/style/Theme.h"

#include <QAction>
#include <QEvent>

#include <algorithm>

namespace taa::app {

MenuTitle::MenuTitle(QMenuBar* bar) : bar_(bar) {
  bar_->setCornerWidget(this);
  bar_->installEventFilter(this);
}

void MenuTitle::setTitle(const QString& text) {
  // Its last part, the size, stands elsewhere, too.
  const qsizetype end = text.lastIndexOf(QLatin1String(" · "));
  setWhole(text, end > 0 ? QStringList{text.left(end)} : QStringList());
  place();
}

// Where the menus end shows without it: a bar hides menus that its corner leaves no room for.
void MenuTitle::place() {
  if (isPlacing_ || bar_->actions().isEmpty()) return;
  isPlacing_ = true;
  room_ = 0;
  bar_->setCornerWidget(this);
  const QRect last = bar_->actionGeometry(bar_->actions().last());
  room_ = std::max(0, bar_->width() - last.right() - 2 * kUnit);
  bar_->setCornerWidget(this);
  isPlacing_ = false;
}

QSize MenuTitle::sizeHint() const {
  const QSize whole = ElidedLabel::sizeHint();
  return {std::min(whole.width(), room_), whole.height()};
}

// A theme that is applied gives first the bar its font, then this.
void MenuTitle::changeEvent(QEvent* event) {
  ElidedLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange) place();
}

bool MenuTitle::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::FontChange) place();
  return ElidedLabel::eventFilter(watched, event);
}

} // namespace taa::app
