// The windows beside the main one by their names, so that pictures of them can be asked for.
#pragma once

#include <string>
#include <vector>

class QPixmap;

namespace taa::app {

class MainWindow;

/// "export", "glsl", "presets", …
const std::vector<std::string>& dialogNames();
/// Opens one, as its command in a menu does; expects a name of the list and an open source.
void openDialog(MainWindow& window, const std::string& name);
/// Adds the windows that are open beside it to a picture of the main one, where they are on the screen.
void paintDialogs(const MainWindow& window, QPixmap& picture);

} // namespace taa::app
