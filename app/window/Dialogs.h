// The windows beside the main one by their names, so that pictures of them can be asked for.
#pragma once

#include <string>
#include <vector>

class QPixmap;
class QWidget;

namespace taa::app {

class CommandLists;
class Exports;
class ImportFrames;
class OwnPresets;
class Session;
class ViewArea;

/// What they are opened by.
struct DialogOpeners {
  QWidget* window;
  Session& session;
  ViewArea& views;
  Exports& exports;
  OwnPresets& presets;
  CommandLists& lists;
  ImportFrames& imports;
};

/// "export", "glsl", "presets", …
const std::vector<std::string>& dialogNames();
/// Opens one, as its command in a menu does; expects a name of the list and an open source.
void openDialog(const DialogOpeners& by, const std::string& name);
/// Whether all that the windows beside the main one show has arrived.
bool areDialogsComplete();
/// Adds the windows that are open beside `window` to a picture of it, where they are on the screen.
void paintDialogs(const QWidget& window, QPixmap& picture);

} // namespace taa::app
