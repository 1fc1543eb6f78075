#include "app/docks/PanelDock.h"

#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>

namespace taa::app {

PanelDock::PanelDock(const QString& id, const QString& title, QWidget* parent) : QDockWidget(title, parent) {
  setObjectName(id);
  setAccessibleName(title);
  setFeatures(DockWidgetMovable | DockWidgetFloatable | DockWidgetClosable);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  connect(this, &QDockWidget::topLevelChanged, this, &PanelDock::showButton);
}

void PanelDock::setHead(QWidget* head) {
  auto* whole = new QWidget;
  row_ = new QHBoxLayout(whole);
  row_->setContentsMargins(0, 0, 2 * kUnit, 0);
  row_->setSpacing(0);
  if (!head) {
    auto* title = new QLabel(windowTitle());
    title->setContentsMargins(2 * kUnit, kUnit, 0, kUnit);
    head = title;
  }
  row_->addWidget(head, 1);
  button_ = new IconButton(QStringLiteral("tear-off"), {});
  button_->setObjectName(objectName() + QStringLiteral(".tearOff"));
  connect(button_, &IconButton::clicked, this, &PanelDock::headPressed);
  row_->addWidget(button_, 0, Qt::AlignVCenter);
  setWholeHead(whole);
  showButton();
}

void PanelDock::setWholeHead(QWidget* head) {
  head->setAutoFillBackground(true);
  head->setBackgroundRole(QPalette::AlternateBase);
  setTitleBarWidget(head);
}

void PanelDock::addCloseButton() {
  auto* close = new IconButton(QStringLiteral("close"), tr("Close: %1").arg(windowTitle()));
  connect(close, &IconButton::clicked, this, &QWidget::close);
  row_->addWidget(close, 0, Qt::AlignVCenter);
}

void PanelDock::setPanel(QWidget* panel) {
  if (widget()) widget()->removeEventFilter(this);
  const bool isHidden = panel && panel->isHidden() && panel->testAttribute(Qt::WA_WState_ExplicitShowHide);
  setWidget(panel);
  if (!panel) return hide();
  panel->setVisible(!isHidden); // Qt shows it
  panel->installEventFilter(this);
  follow();
}

void PanelDock::follow() {
  const bool shows = widget() && !widget()->isHidden();
  const bool opens = shows && isHidden();
  setVisible(shows);
  if (shows && isFloating()) raise();
  if (opens) Q_EMIT opened();
}

bool PanelDock::eventFilter(QObject* object, QEvent* event) {
  const bool changes = event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent;
  if (object == widget() && changes) follow();
  return QDockWidget::eventFilter(object, event);
}

void PanelDock::closeEvent(QCloseEvent* event) {
  giveFocusBack();
  if (widget()) widget()->hide();
  event->accept();
  Q_EMIT closed();
}

void PanelDock::giveFocusBack() {
  if (isFloating() && QApplication::activeWindow() == this) parentWidget()->window()->activateWindow();
}

void PanelDock::showButton() {
  if (!button_) return;
  const QString text = isFloating() ? tr("Put back into the window: %1") : tr("In a window of its own: %1");
  button_->setIconName(isFloating() ? QStringLiteral("put-back") : QStringLiteral("tear-off"));
  button_->setToolTip(text.arg(windowTitle()));
  button_->setAccessibleName(text.arg(windowTitle()));
}

} // namespace taa::app
