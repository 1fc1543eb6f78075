// What is said beside something, small and gray, in as many lines as it takes.
#pragma once

#include <QLabel>

namespace taa::app {

/// In the font and color of what is said beside something.
void setSecondary(QWidget& widget);

/// Without words yet; whoever lays it out owns it.
QLabel* newNote();

} // namespace taa::app
