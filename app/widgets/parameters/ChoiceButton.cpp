#include "app/widgets/parameters/ChoiceButton.h"

#include "app/style/Icons.h"
#include "app/style/Theme.h"

#include <QAction>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>

#include <algorithm>

namespace taa::app {

namespace {
constexpr int kChoicePadding = 6;
constexpr int kChevron = 12;
} // namespace

ChoiceButton::ChoiceButton(QWidget* parent) : QAbstractButton(parent) {
  setFont(secondaryFont());
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(this, &QAbstractButton::clicked, this, &ChoiceButton::openMenu);
}

void ChoiceButton::setChoices(const QStringList& labels, const QStringList& explanations) {
  labels_ = labels;
  explanations_ = explanations;
  updateGeometry();
}

void ChoiceButton::setCurrent(int index) {
  current_ = index;
  update();
}

void ChoiceButton::setCaption(const QString& caption) {
  caption_ = caption;
  updateGeometry();
  update();
}

void ChoiceButton::setFlat(bool flat) {
  flat_ = flat;
}

void ChoiceButton::setPlain(bool plain) {
  plain_ = plain;
  updateGeometry();
}

void ChoiceButton::setDimmed(bool dimmed) {
  dimmed_ = dimmed;
  update();
}

QString ChoiceButton::caption() const {
  if (!caption_.isEmpty()) return caption_;
  return current_ >= 0 && current_ < labels_.size() ? labels_[current_] : QString();
}

QSize ChoiceButton::sizeHint() const {
  int width = fontMetrics().horizontalAdvance(caption_);
  if (caption_.isEmpty())
    for (const QString& label : labels_) width = std::max(width, fontMetrics().horizontalAdvance(label));
  // The frame takes a pixel at either end.
  return {width + 2 * kChoicePadding + (plain_ ? 0 : kUnit + scaled(kChevron)) + 2, rowHeight()};
}

void ChoiceButton::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  const QRect box = rect().adjusted(0, 1, -1, -2);
  if (!flat_ || underMouse()) painter.fillRect(box, underMouse() ? colors.hover : colors.field);
  if (!flat_ || hasFocus()) {
    painter.setPen(hasFocus() ? colors.accent : colors.line);
    painter.drawRect(box);
  }
  painter.setPen(dimmed_ ? colors.secondary : colors.text);
  // The mark of a list goes before letters do.
  QRect inside = box.adjusted(kChoicePadding, 0, 1 - kChoicePadding, 0);
  const int mark = scaled(kChevron) + kUnit;
  const bool isPlain = plain_ || fontMetrics().horizontalAdvance(caption()) > inside.width() - mark;
  if (!isPlain) inside.setRight(inside.right() - mark);
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignLeft,
                   fontMetrics().elidedText(caption(), Qt::ElideRight, inside.width()));
  if (isPlain) return;
  painter.drawPixmap(
      box.right() - kChoicePadding - scaled(kChevron) + 2, box.center().y() - scaled(kChevron) / 2 + 1,
      iconPixmap(QStringLiteral("chevron-down"), colors.secondary, scaled(kChevron), devicePixelRatioF()));
}

QMenu* ChoiceButton::partOf(QMenu* menu, const Part& part) {
  if (part.title.isEmpty()) {
    menu->addSeparator();
    return menu;
  }
  QMenu* submenu = menu->addMenu(part.title);
  submenu->setToolTipsVisible(true);
  return submenu;
}

void ChoiceButton::setLast(const QString& title, const std::vector<bool>& last) {
  lastTitle_ = title;
  last_ = last;
}

bool ChoiceButton::isLast(int index) const {
  return static_cast<std::size_t>(index) < last_.size() && last_[static_cast<std::size_t>(index)];
}

// The line stands where other menus have their keys, in a column of its own.
void ChoiceButton::addChoice(QMenu* menu, int index) {
  const QString line = index < lines_.size() ? QLatin1Char('\t') + lines_[index] : QString();
  QAction* action = menu->addAction(labels_[index] + line, this, [this, index] { choose(index); });
  connect(action, &QAction::hovered, this, [this, index] {
    if (index != current_) Q_EMIT considered(index);
  });
  action->setCheckable(true);
  action->setChecked(index == current_);
  if (index < explanations_.size()) action->setToolTip(explanations_[index]);
}

void ChoiceButton::openMenu() {
  if (labels_.isEmpty()) {
    Q_EMIT requested();
    return;
  }
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  QMenu* at = menu;
  for (int index = 0; index < labels_.size(); ++index) {
    for (const Part& part : parts_)
      if (part.first == index) at = partOf(menu, part);
    if (!isLast(index)) addChoice(at, index);
  }
  if (!last_.empty()) at = partOf(menu, {0, lastTitle_});
  for (int index = 0; index < labels_.size(); ++index)
    if (isLast(index)) addChoice(at, index);
  menu->popup(mapToGlobal(QPoint(0, height())));
}

void ChoiceButton::choose(int index) {
  if (index < 0 || index >= labels_.size()) return;
  const bool changed = index != current_;
  setCurrent(index);
  if (changed || !caption_.isEmpty()) Q_EMIT chosen(index);
}

void ChoiceButton::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Up) {
    choose(current_ - 1);
    return;
  }
  if (event->key() == Qt::Key_Down) {
    choose(current_ + 1);
    return;
  }
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
}

} // namespace taa::app
