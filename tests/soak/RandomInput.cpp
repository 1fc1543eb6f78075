#include "tests/soak/RandomInput.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace taa::soak {

namespace {

constexpr std::array kKeys{Qt::Key_A,        Qt::Key_C,           Qt::Key_D,
                           Qt::Key_E,        Qt::Key_F,           Qt::Key_G,
                           Qt::Key_H,        Qt::Key_I,           Qt::Key_J,
                           Qt::Key_K,        Qt::Key_L,           Qt::Key_M,
                           Qt::Key_N,        Qt::Key_O,           Qt::Key_P,
                           Qt::Key_R,        Qt::Key_S,           Qt::Key_T,
                           Qt::Key_U,        Qt::Key_V,           Qt::Key_W,
                           Qt::Key_X,        Qt::Key_Z,           Qt::Key_0,
                           Qt::Key_1,        Qt::Key_2,           Qt::Key_3,
                           Qt::Key_4,        Qt::Key_7,           Qt::Key_8,
                           Qt::Key_9,        Qt::Key_F1,          Qt::Key_F2,
                           Qt::Key_F3,       Qt::Key_F4,          Qt::Key_F5,
                           Qt::Key_F6,       Qt::Key_F7,          Qt::Key_F8,
                           Qt::Key_F9,       Qt::Key_F10,         Qt::Key_F11,
                           Qt::Key_F12,      Qt::Key_Tab,         Qt::Key_Tab,
                           Qt::Key_Tab,      Qt::Key_Backtab,     Qt::Key_Space,
                           Qt::Key_Return,   Qt::Key_Up,          Qt::Key_Down,
                           Qt::Key_Left,     Qt::Key_Right,       Qt::Key_PageUp,
                           Qt::Key_PageDown, Qt::Key_Home,        Qt::Key_End,
                           Qt::Key_Escape,   Qt::Key_Escape,      Qt::Key_Backspace,
                           Qt::Key_Delete,   Qt::Key_Plus,        Qt::Key_Minus,
                           Qt::Key_Question, Qt::Key_Comma,       Qt::Key_Period,
                           Qt::Key_Alt,      Qt::Key_BracketLeft, Qt::Key_BracketRight,
                           Qt::Key_Backslash};

constexpr std::array kButtons{Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::RightButton,
                              Qt::MiddleButton};

std::vector<QWidget*> windows() {
  std::vector<QWidget*> found;
  for (QWidget* top : QApplication::topLevelWidgets())
    if (top->isVisible() && top->windowHandle() && top->windowType() != Qt::ToolTip) found.push_back(top);
  return found;
}

void collect(const QList<QAction*>& actions, std::vector<QAction*>& into) {
  for (QAction* action : actions)
    if (action->menu())
      collect(action->menu()->actions(), into);
    else if (action->isEnabled() && !action->isSeparator())
      into.push_back(action);
}

// As QTest::keyClick does, which goes on with a window that one of these keys has closed and ended.
void pressKey(const QPointer<QWindow>& handle, Qt::Key key, Qt::KeyboardModifiers held) {
  struct Modifier {
    Qt::KeyboardModifier held;
    Qt::Key key;
  };
  constexpr std::array kModifiers{Modifier{Qt::ShiftModifier, Qt::Key_Shift},
                                  Modifier{Qt::ControlModifier, Qt::Key_Control},
                                  Modifier{Qt::AltModifier, Qt::Key_Alt}};
  const auto send = [&](bool down, Qt::Key code, Qt::KeyboardModifiers with, const QString& text) {
    if (handle) QTest::simulateEvent(handle, down, code, with, text, false);
  };
  Qt::KeyboardModifiers down;
  for (const Modifier& each : kModifiers)
    if (held & each.held) {
      send(true, each.key, down, {});
      down |= each.held;
    }
  const char letter = QTest::keyToAscii(key);
  const QString text = letter ? QString(QLatin1Char(letter)) : QString();
  send(true, key, held, text);
  send(false, key, held, text);
  for (auto each = kModifiers.rbegin(); each != kModifiers.rend(); ++each)
    if (held & each->held) {
      send(false, each->key, down, {});
      down &= ~each->held;
    }
}

std::string textOf(const QPoint& point) {
  return std::to_string(point.x()) + "," + std::to_string(point.y());
}

std::string nameOf(const QWidget* top) {
  return std::string(top->metaObject()->className()) + " " + top->objectName().toStdString();
}

} // namespace

Qt::KeyboardModifiers RandomInput::modifiers() {
  Qt::KeyboardModifiers chosen;
  if (oneIn(4)) chosen |= Qt::ControlModifier;
  if (oneIn(5)) chosen |= Qt::ShiftModifier;
  if (oneIn(8)) chosen |= Qt::AltModifier;
  return chosen;
}

QWidget* RandomInput::target() {
  if (QWidget* popup = QApplication::activePopupWidget()) return popup;
  if (QWidget* modal = QApplication::activeModalWidget(); modal && modal->isVisible()) return modal;
  const std::vector<QWidget*> all = windows();
  if (all.empty() || (window_.isVisible() && !oneIn(3))) return &window_;
  return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
}

// Mostly on a control, else anywhere.
QPoint RandomInput::pointIn(const QWidget* top) {
  std::vector<const QWidget*> seen;
  for (const QWidget* widget : top->findChildren<QWidget*>())
    if (widget->isVisible() && widget->window() == top && !widget->visibleRegion().isEmpty())
      seen.push_back(widget);
  if (seen.empty() || oneIn(4)) return {below(std::max(1, top->width())), below(std::max(1, top->height()))};
  const QWidget* widget = seen[static_cast<std::size_t>(below(static_cast<int>(seen.size())))];
  const QRect part = widget->visibleRegion().boundingRect();
  return widget->mapTo(top, part.topLeft() + QPoint(below(part.width()), below(part.height())));
}

void RandomInput::press(const Tell& tell) {
  QWidget* top = target();
  const Qt::Key key = kKeys[static_cast<std::size_t>(below(static_cast<int>(kKeys.size())))];
  const Qt::KeyboardModifiers held = modifiers();
  tell("key " + QKeySequence(static_cast<int>(held) | key).toString().toStdString() + " to " + nameOf(top));
  pressKey(top->windowHandle(), key, held);
}

// No slash and no dot: a text is never the path of something that is there.
void RandomInput::type(const Tell& tell) {
  constexpr std::array kTexts{"a", "alpha", "clip", "12", "-3", "1e9", "0,5", "nan", "x y", "ü", "%1", "<b>"};
  QWidget* top = target();
  const char* text = kTexts[static_cast<std::size_t>(below(static_cast<int>(kTexts.size())))];
  tell(std::string("text ") + text + " to " + nameOf(top));
  QWidget* focus = QApplication::focusWidget();
  const QPointer<QWidget> into = focus;
  for (const QChar letter : QString::fromUtf8(text)) {
    if (!into) return;
    QKeyEvent pressed(QEvent::KeyPress, Qt::Key_unknown, Qt::NoModifier, QString(letter));
    QApplication::sendEvent(into, &pressed);
  }
}

void RandomInput::click(const Tell& tell) {
  QWidget* top = target();
  const QPoint point = pointIn(top);
  const Qt::MouseButton button = kButtons[static_cast<std::size_t>(below(static_cast<int>(kButtons.size())))];
  const Qt::KeyboardModifiers held = modifiers();
  const bool isDouble = oneIn(6);
  tell((isDouble ? "double click " : "click ") + std::to_string(button) + " at " + textOf(point) + " in " +
       nameOf(top));
  const QPointer<QWindow> handle = top->windowHandle();
  QTest::mouseMove(handle, point);
  for (int times = isDouble ? 2 : 1; times > 0 && handle; --times) {
    QTest::mousePress(handle, button, held, point);
    if (handle) QTest::mouseRelease(handle, button, held, point);
  }
}

void RandomInput::drag(const Tell& tell) {
  QWidget* top = target();
  const QPointer<QWindow> handle = top->windowHandle();
  const QPoint from = pointIn(top), to = pointIn(top);
  const Qt::MouseButton button = kButtons[static_cast<std::size_t>(below(static_cast<int>(kButtons.size())))];
  tell("drag " + std::to_string(button) + " " + textOf(from) + " to " + textOf(to) + " in " + nameOf(top));
  constexpr int kSteps = 5;
  QTest::mouseMove(handle, from);
  QTest::mousePress(handle, button, {}, from);
  for (int step = 1; step <= kSteps && handle; ++step)
    QTest::mouseMove(handle, from + (to - from) * step / kSteps);
  if (handle && oneIn(10)) pressKey(handle, Qt::Key_Escape, {});
  if (handle) QTest::mouseRelease(handle, button, {}, to);
}

void RandomInput::turnWheel(const Tell& tell) {
  QWidget* top = target();
  const QPoint point = pointIn(top);
  const int delta = 120 * (below(7) - 3);
  tell("wheel " + std::to_string(delta) + " at " + textOf(point) + " in " + nameOf(top));
  QWheelEvent event(point, top->mapToGlobal(point), {}, {0, delta}, Qt::NoButton, modifiers(),
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(top->windowHandle(), &event);
}

void RandomInput::resize(const Tell& tell) {
  const QSize size(900 + below(1200), 500 + below(800));
  tell("resize to " + std::to_string(size.width()) + "x" + std::to_string(size.height()));
  window_.resize(size);
}

// Also what no key is likely to hit; the end of the program is left to the keys.
void RandomInput::choose(const Tell& tell) {
  std::vector<QAction*> all;
  collect(window_.menuBar()->actions(), all);
  QAction* action = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
  tell("command " + action->text().toStdString());
  if (!QApplication::activeModalWidget()) action->trigger();
}

void RandomInput::step(const Tell& tell) {
  const int kind = below(20);
  if (kind < 7)
    press(tell);
  else if (kind < 13)
    click(tell);
  else if (kind < 15)
    drag(tell);
  else if (kind < 16)
    turnWheel(tell);
  else if (kind < 17)
    type(tell);
  else if (kind < 18)
    resize(tell);
  else
    choose(tell);
  QTest::qWait(oneIn(10) ? 100 : below(8));
}

void RandomInput::closeAll() {
  for (int tries = 0; tries < 20 && QApplication::activePopupWidget(); ++tries) {
    QApplication::activePopupWidget()->close();
    QTest::qWait(1);
  }
  for (QWidget* top : windows())
    if (top != &window_ && qobject_cast<QDialog*>(top)) top->close();
  QTest::qWait(20);
}

} // namespace taa::soak
