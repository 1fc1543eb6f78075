#include "app/widgets/ScrollPlace.h"

#include <QScrollBar>
#include <QTimer>

namespace taa::app {

namespace {
constexpr int kSettled = 500; ///< ms
} // namespace

void scrollTo(QScrollBar* bar, int value) {
  const QString name = QStringLiteral("scrollGoal");
  delete bar->findChild<QObject*>(name, Qt::FindDirectChildrenOnly);
  auto* goal = new QObject(bar);
  goal->setObjectName(name);
  QObject::connect(bar, &QScrollBar::rangeChanged, goal, [bar, value] { bar->setValue(value); });
  QObject::connect(bar, &QScrollBar::actionTriggered, goal, &QObject::deleteLater);
  QTimer::singleShot(kSettled, goal, &QObject::deleteLater);
  bar->setValue(value);
}

} // namespace taa::app
