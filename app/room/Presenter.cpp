#include "app/room/Presenter.h"

#include "app/commands/ThemeSetting.h"
#include "app/docks/Workspace.h"
#include "app/learn/Learning.h"
#include "app/room/PointerLabel.h"
#include "app/session/Session.h"
#include "app/style/TextSize.h"
#include "app/style/Theme.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/widgets/Note.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QMouseEvent>
#include <QPointer>
#include <QStringList>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace taa::app {

Presenter::Presenter(const Holders& of)
    : QObject(&of.window), of_(of), pointer_(new PointerLabel(&of.window)), line_(new QLabel) {
  for (int view = 0; view < kViewCount; ++view) of_.chrome.push_back(of_.views.view(view)->header());
  setSecondary(*line_);
  line_->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 0);
  line_->setAccessibleName(tr("Place in what is presented"));
  line_->hide();
  connect(&of_.session, &Session::statusChanged, this, &Presenter::describe);
  connect(&of_.learning, &Learning::stepShown, this, &Presenter::describe);
  connect(&of_.learning, &Learning::changed, this, &Presenter::describe);
  qApp->installEventFilter(this);
}

void Presenter::setOn(bool on) {
  if (on == isOn()) return;
  if (on)
    enter();
  else
    leave();
  describe();
  Q_EMIT changed();
}

// A menu bar that is hidden would take the keys of its menus with it: it has no height instead.
void Presenter::enter() {
  QMenuBar* menus = of_.window.menuBar();
  Before before{of_.window.windowState(), of_.window.geometry(), textPercent(), menus->maximumHeight(), {},
                of_.workspace.state(),    of_.workspace.width()};
  for (const QWidget* part : of_.chrome) before.hidden.push_back(part->isHidden());
  before_ = std::move(before);
  menus->setMaximumHeight(0);
  for (QWidget* part : of_.chrome) part->hide();
  line_->show();
  of_.theme.showTextPercent(std::max(textPercent(), kRoomTextPercent));
  setFullScreen(true);
  of_.views.active()->viewport()->setFocus();
}

void Presenter::leave() {
  const Before before = *std::exchange(before_, std::nullopt);
  pointer_->pointAt({}, {});
  line_->hide();
  of_.theme.showTextPercent(before.textPercent);
  of_.window.menuBar()->setMaximumHeight(before.menuHeight);
  for (std::size_t part = 0; part < of_.chrome.size(); ++part)
    of_.chrome[part]->setHidden(before.hidden[part]);
  pendingLayout_ = before.layout;
  pendingWidth_ = before.workspaceWidth;
  of_.window.setWindowState(before.window);
  if (!before.window.testFlag(Qt::WindowFullScreen) && !before.window.testFlag(Qt::WindowMaximized))
    of_.window.setGeometry(before.geometry);
  if (of_.workspace.width() == pendingWidth_) restoreLayout();
}

// They share out a size of the window: another one would spread their rounding.
void Presenter::restoreLayout() {
  const QJsonObject layout = std::exchange(pendingLayout_, {});
  if (layout.isEmpty()) return; // done already
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  of_.workspace.setState(layout);
}

void Presenter::setFullScreen(bool full) {
  if (full == isFullScreen()) return;
  of_.window.setWindowState(of_.window.windowState() ^ Qt::WindowFullScreen);
  Q_EMIT changed();
}

bool Presenter::isFullScreen() const {
  return of_.window.isFullScreen();
}

void Presenter::step(int by) {
  if (of_.learning.isOpen())
    of_.learning.stepBy(by);
  else
    of_.session.post(request::Step{by});
}

// Menus, lists and dialogs that are open have the keys before.
bool Presenter::takesKey(QEvent& event) {
  if (QApplication::activePopupWidget() || QApplication::activeModalWidget()) return false;
  const auto& key = static_cast<const QKeyEvent&>(event);
  if (key.modifiers() & ~Qt::KeypadModifier) return false;
  const bool isStep = key.key() == Qt::Key_PageDown || key.key() == Qt::Key_PageUp;
  if (!isStep && key.key() != Qt::Key_Escape) return false;
  event.accept();
  if (event.type() != QEvent::KeyPress) return true;
  if (isStep)
    step(key.key() == Qt::Key_PageDown ? 1 : -1);
  else
    setOn(false);
  return true;
}

void Presenter::point(QObject* object, QPoint place) {
  for (int view = 0; view < kViewCount; ++view)
    if (const Viewport* viewport = of_.views.view(view)->viewport(); viewport == object)
      pointer_->pointAt(viewport->mapTo(&of_.window, place), of_.textAt(view));
}

bool Presenter::eventFilter(QObject* object, QEvent* event) {
  if (!pendingLayout_.isEmpty() && object == &of_.workspace && event->type() == QEvent::Resize &&
      of_.workspace.width() == pendingWidth_)
    QMetaObject::invokeMethod(this, &Presenter::restoreLayout, Qt::QueuedConnection);
  if (!isOn()) return false;
  switch (event->type()) {
  case QEvent::ShortcutOverride:
  case QEvent::KeyPress: {
    const auto* widget = qobject_cast<const QWidget*>(object);
    return widget && widget->window() == &of_.window && takesKey(*event);
  }
  case QEvent::ShowToParent: // a step of a lesson shows panels
    if (auto* part = qobject_cast<QWidget*>(object); part && std::ranges::count(of_.chrome, part) > 0)
      part->hide();
    return false;
  case QEvent::Leave:
    if (qobject_cast<const Viewport*>(object)) pointer_->pointAt({}, {});
    return false;
  case QEvent::MouseMove:
    // The viewport is to know the pixel first.
    if (qobject_cast<const Viewport*>(object))
      QMetaObject::invokeMethod(
          this,
          [this, object = QPointer<QObject>(object),
           place = static_cast<const QMouseEvent*>(event)->position().toPoint()] {
            if (object && isOn()) point(object, place);
          },
          Qt::QueuedConnection);
    return false;
  default:
    return false;
  }
}

void Presenter::describe() {
  if (!isOn()) return;
  const Status& status = of_.session.status();
  QStringList parts;
  if (of_.learning.isOpen()) parts << of_.learning.place();
  parts << tr("frame %1 of %2").arg(status.info.frame).arg(status.frameCount);
  parts << (of_.learning.isOpen() ? tr("PageDown: next step") : tr("PageDown: next frame"));
  parts << tr("Escape leaves");
  line_->setText(parts.join(QStringLiteral("  ·  ")));
}

} // namespace taa::app
