#include "app/docks/PanelDock.h"

#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>

#include <algorithm>

namespace taa::app {

namespace {

/// What a panel scrolls in where there is less room than it needs.
class PanelArea : public QScrollArea {
 public:
  PanelArea(QWidget* panel, int leastPx) : leastPx_(leastPx) {
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus); // the way of the Tab key scrolls it
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(panel);
    viewport()->setAutoFillBackground(false);
    panel->setAutoFillBackground(false);
  }
  QSize sizeHint() const override { return widget()->sizeHint(); }
  QSize minimumSizeHint() const override {
    const QSize hint = widget()->minimumSizeHint(), least = widget()->minimumSize();
    const int high = std::max(hint.height(), least.height());
    return {least.width() > 0 ? least.width() : hint.width(), std::min(high, scaled(leastPx_))};
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QScrollArea::resizeEvent(event);
    fit();
  }
  bool eventFilter(QObject* object, QEvent* event) override {
    const bool isOther = object == widget() && event->type() == QEvent::LayoutRequest;
    const bool isDone = QScrollArea::eventFilter(object, event);
    if (isOther) {
      updateGeometry();
      fit();
    }
    return isDone;
  }

 private:
  /// Not by setWidgetResizable(), by which a panel with texts that wrap is as high as it would like to be.
  void fit() {
    const QSize least = widget()->minimumSizeHint().expandedTo(widget()->minimumSize());
    widget()->resize(viewport()->width(), std::max(viewport()->height(), least.height()));
  }

  int leastPx_; ///< of texts of 100 %
};

} // namespace

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
  takePanel(panel, panel);
}

void PanelDock::setScrolledPanel(QWidget* panel, int leastPx) {
  takePanel(panel, new PanelArea(panel, leastPx));
}

void PanelDock::takePanel(QWidget* panel, QWidget* shown) {
  if (panel_) panel_->removeEventFilter(this);
  panel_ = panel;
  const bool isHidden = panel && panel->isHidden() && panel->testAttribute(Qt::WA_WState_ExplicitShowHide);
  setWidget(shown);
  if (!panel) {
    hide();
    return;
  }
  panel->setVisible(!isHidden); // Qt shows it
  panel->installEventFilter(this);
  follow();
}

void PanelDock::follow() {
  const bool shows = panel_ && !panel_->isHidden();
  const bool opens = shows && isHidden();
  setVisible(shows);
  if (shows && isFloating()) raise();
  if (opens) Q_EMIT opened();
}

bool PanelDock::eventFilter(QObject* object, QEvent* event) {
  const bool changes = event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent;
  if (object == panel_ && changes) follow();
  return QDockWidget::eventFilter(object, event);
}

void PanelDock::closeEvent(QCloseEvent* event) {
  endDrag();
  giveFocusBack();
  if (panel_) panel_->hide();
  event->accept();
  Q_EMIT closed();
}

// Qt has no other way to end it.
void PanelDock::endDrag() {
  QCloseEvent event;
  QDockWidget::closeEvent(&event);
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
