// A place to scroll to that is there only once what was unfolded has been laid out.
#pragma once

class QScrollBar;

namespace taa::app {

/// Scrolls there now, and again as its range changes in the next moment, unless the user scrolls.
void scrollTo(QScrollBar* bar, int value);

} // namespace taa::app
