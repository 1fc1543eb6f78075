// What is said beside something, small and gray, in as many lines as it takes.
#pragma once

#include <QLabel>

namespace taa::app {

/// Without words yet; whoever lays it out owns it.
QLabel* newNote();

} // namespace taa::app
