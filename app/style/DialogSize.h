// How large a dialog opens.
#pragma once

#include "app/style/Theme.h"

#include <QSize>
#include <QWidget>

namespace taa::app {

/// `wanted` logical px, as far as they fit over the window that the dialog belongs to: the screen may be no
/// larger. Without one all of it.
inline QSize sizeOver(const QWidget* parent, const QSize& wanted) {
  return parent ? wanted.boundedTo(parent->window()->size() - QSize(4 * kUnit, 4 * kUnit)) : wanted;
}

/// For what has more to show than fits: `wanted`, or more than half of a window that is large.
inline QSize largeOver(const QWidget* parent, const QSize& wanted) {
  constexpr double kShare = 0.7; // of the window's width and height
  return sizeOver(parent, parent ? wanted.expandedTo(parent->window()->size() * kShare) : wanted);
}

} // namespace taa::app
