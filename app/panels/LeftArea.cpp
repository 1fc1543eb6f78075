#include "app/panels/LeftArea.h"

#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

namespace taa::app {

LeftArea::LeftArea(QWidget* pipeline, QWidget* scene) : tabs_(new QTabBar), pages_(new QStackedWidget) {
  setObjectName(QStringLiteral("left"));
  setAccessibleName(tr("Pipeline or scene"));
  tabs_->setAccessibleName(tr("Pipeline or scene"));
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  tabs_->setFocusPolicy(Qt::TabFocus);
  for (QWidget* widget : {static_cast<QWidget*>(this), scene}) {
    widget->setAutoFillBackground(true);
    widget->setBackgroundRole(QPalette::AlternateBase);
  }
  pages_->addWidget(pipeline);
  pages_->addWidget(scene);
  tabs_->addTab(tr("Pipeline"));
  tabs_->addTab(tr("Scene"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(tabs_);
  rows->addWidget(pages_, 1);
  connect(tabs_, &QTabBar::currentChanged, this, [this](int page) {
    pages_->setCurrentIndex(page);
    Q_EMIT changed();
  });
}

void LeftArea::openPage(LeftPage page) {
  setVisible(true);
  setPage(page);
  Q_EMIT changed();
}

void LeftArea::setPage(LeftPage page) {
  tabs_->setCurrentIndex(static_cast<int>(page));
}

LeftPage LeftArea::page() const {
  return static_cast<LeftPage>(tabs_->currentIndex());
}

bool LeftArea::shows(LeftPage page) const {
  return !isHidden() && this->page() == page;
}

void LeftArea::setShown(bool shown) {
  setVisible(shown);
  Q_EMIT changed();
}

} // namespace taa::app
