// The project's own icons (resources/icons), drawn in the text color of the moment at any size.
#pragma once

#include <QIcon>
#include <QPixmap>
#include <QString>

namespace taa::app {

/// `name` without folder and ending: "play". Colored when painted, so that a change of theme shows at once.
/// Throws Error when there is no such icon.
QIcon themedIcon(const QString& name);

/// One icon in a fixed color, `size` logical pixels wide.
QPixmap iconPixmap(const QString& name, const QColor& color, int size, double pixelRatio);

/// The icon of the program.
QIcon programIcon();

} // namespace taa::app
