#include "app/panels/LeftArea.h"

#include <QTabBar>

namespace taa::app {

LeftArea::LeftArea(QWidget* pipeline, QWidget* scene) {
  setDocumentMode(true);
  setObjectName(QStringLiteral("left"));
  setAccessibleName(tr("Pipeline or scene"));
  tabBar()->setAccessibleName(tr("Pipeline or scene"));
  tabBar()->setDrawBase(false);
  for (QWidget* widget : {static_cast<QWidget*>(this), scene}) {
    widget->setAutoFillBackground(true);
    widget->setBackgroundRole(QPalette::AlternateBase);
  }
  addTab(pipeline, tr("Pipeline"));
  addTab(scene, tr("Scene"));
  connect(this, &QTabWidget::currentChanged, this, &LeftArea::changed);
}

void LeftArea::openPage(LeftPage page) {
  setVisible(true);
  setCurrentIndex(static_cast<int>(page));
  Q_EMIT changed();
}

bool LeftArea::shows(LeftPage page) const {
  return !isHidden() && this->page() == page;
}

void LeftArea::setShown(bool shown) {
  setVisible(shown);
  Q_EMIT changed();
}

} // namespace taa::app
