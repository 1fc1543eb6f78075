#include "app/widgets/ScrollPlace.h"

#include <QAbstractItemView>
#include <QPersistentModelIndex>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>

namespace taa::app {

namespace {
constexpr int kSettled = 500; ///< ms

/// `scroll` is called now, and while what is scrolled is laid out.
template <typename Scroll>
void scrollInTheNextMoment(QScrollBar* bar, Scroll scroll) {
  const QString name = QStringLiteral("scrollGoal");
  delete bar->findChild<QObject*>(name, Qt::FindDirectChildrenOnly);
  auto* goal = new QObject(bar);
  goal->setObjectName(name);
  QObject::connect(bar, &QScrollBar::rangeChanged, goal, scroll);
  QObject::connect(bar, &QScrollBar::actionTriggered, goal, &QObject::deleteLater);
  QTimer::singleShot(kSettled, goal, &QObject::deleteLater);
  scroll();
}

} // namespace

void scrollTo(QScrollBar* bar, int value) {
  scrollInTheNextMoment(bar, [bar, value] { bar->setValue(value); });
}

void scrollTo(QScrollArea* area, QWidget* part) {
  QScrollBar* bar = area->verticalScrollBar();
  scrollInTheNextMoment(bar, [bar, part, area] { bar->setValue(part->mapTo(area->widget(), QPoint()).y()); });
}

void scrollTo(QAbstractItemView* list, const QModelIndex& row) {
  scrollInTheNextMoment(list->verticalScrollBar(), [list, row = QPersistentModelIndex(row)] {
    list->scrollTo(row, QAbstractItemView::PositionAtTop);
  });
}

} // namespace taa::app
