#include "app/docks/PanelCycle.h"

#include <QApplication>
#include <QWidget>

#include <algorithm>

namespace taa::app {

namespace {

bool canTakeFocus(const QWidget* widget) {
  return widget && widget->isVisible() && widget->isEnabled() &&
         (widget->focusPolicy() & Qt::TabFocus) != 0 && !widget->focusProxy();
}

} // namespace

PanelCycle::PanelCycle(const std::vector<QWidget*>& panels, QObject* parent)
    : QObject(parent), panels_(panels.begin(), panels.end()) {
  connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, QWidget* now) {
    const auto panel = std::ranges::find_if(
        panels_, [now](const QPointer<QWidget>& each) { return each && each->isAncestorOf(now); });
    if (panel != panels_.end()) last_[*panel] = now;
  });
}

// A disabled or hidden widget keeps its place for when it can be used again.
QWidget* PanelCycle::entryOf(QWidget* panel) const {
  if (!panel || !panel->isVisible()) return nullptr;
  if (const auto last = last_.find(panel);
      last != last_.end() && panel->isAncestorOf(last->second) && canTakeFocus(last->second))
    return last->second;
  for (QWidget* at = panel->nextInFocusChain(); at != panel; at = at->nextInFocusChain())
    if (panel->isAncestorOf(at) && canTakeFocus(at)) return at;
  return nullptr;
}

void PanelCycle::go(int direction) {
  const QWidget* focus = QApplication::focusWidget();
  const auto count = static_cast<int>(panels_.size());
  const auto now = std::ranges::find_if(
      panels_, [focus](const QPointer<QWidget>& each) { return each && focus && each->isAncestorOf(focus); });
  const int from = now != panels_.end() ? static_cast<int>(now - panels_.begin())
                   : direction > 0      ? -1
                                        : count;
  for (int step = 1; step <= count; ++step) {
    const int at = ((from + direction * step) % count + count) % count;
    QWidget* panel = panels_[static_cast<std::size_t>(at)];
    QWidget* entry = entryOf(panel);
    if (!entry) continue;
    // Qt calls tool windows active that share the keys of the one that is.
    if (QApplication::activeWindow() != entry->window()) entry->activateWindow();
    entry->setFocus(Qt::TabFocusReason);
    return;
  }
}

} // namespace taa::app
