// The order in which the Tab key goes through a window.
#pragma once

#include <vector>

class QWidget;

namespace taa::app {

/// Through these areas as the eye does, one after another; within one, in the order in which it was made. Of
/// areas in each other the first one counts.
void orderFocus(QWidget& window, const std::vector<QWidget*>& areas);

} // namespace taa::app
