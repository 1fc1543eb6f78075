// A place to scroll to that is there only once what was unfolded has been laid out.
#pragma once

class QAbstractItemView;
class QModelIndex;
class QScrollArea;
class QScrollBar;
class QWidget;

namespace taa::app {

/// Scrolls there now, and again as its range changes in the next moment, unless the user scrolls.
void scrollTo(QScrollBar* bar, int value);

/// The same, until `part` of what is scrolled stands at the upper edge.
void scrollTo(QScrollArea* area, QWidget* part);
/// Likewise of a row of a list.
void scrollTo(QAbstractItemView* list, const QModelIndex& row);

} // namespace taa::app
