#include "app/window/Dialogs.h"

#include "app/commands/Exports.h"
#include "app/commands/ImportFrames.h"
#include "app/commands/OwnPresets.h"
#include "app/commands/Tune.h"
#include "app/dialogs/GlslWindow.h"
#include "app/dialogs/ReferenceDialog.h"
#include "app/dialogs/SweepDialog.h"
#include "app/importing/ImportPage.h"
#include "app/menus/CommandLists.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/widgets/IconButton.h"

#include <QApplication>
#include <QDialog>
#include <QFileInfo>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <utility>

namespace taa::app {

namespace {

using Open = void (*)(const DialogOpeners& by);

void openReference(const DialogOpeners& by) {
  auto* dialog = new ReferenceDialog(by.window);
  dialog->open();
}

void openGlsl(const DialogOpeners& by) {
  GlslWindow::openAt(by.session, intermediate(by.views.active()->id()).stage, by.window);
}

/// On the frames of the capture that is open, with capture.json or without.
void openImport(const DialogOpeners& by) {
  const Status& status = by.session.status();
  const QFileInfo source(QString::fromStdString(status.source));
  if (!status.capture) {
    by.imports.open({});
    return;
  }
  by.imports.open(source.isDir() ? source.filePath() : source.path());
}

void openMore(const DialogOpeners& by) {
  by.views.active()->header()->findChild<IconButton*>(QStringLiteral("more"))->click();
}

const std::vector<std::pair<std::string, Open>>& dialogs() {
  static const std::vector<std::pair<std::string, Open>> all = {
      {"export", [](const DialogOpeners& by) { by.exports.askForRange(); }},
      {"glsl", openGlsl},
      {"presets", [](const DialogOpeners& by) { by.presets.compare(); }},
      {"sweep",
       [](const DialogOpeners& by) { SweepDialog::openAt(by.session, by.presets.folder(), by.window); }},
      {"tune", [](const DialogOpeners& by) { openTune(by.session, by.presets, by.exports, by.window); }},
      {"keys", [](const DialogOpeners& by) { by.lists.showKeys(); }},
      {"reference", openReference},
      {"commands", [](const DialogOpeners& by) { by.lists.choose(); }},
      {"import", openImport},
      {"histogram", [](const DialogOpeners& by) { by.views.active()->setHistogramShown(true); }},
      {"more", openMore}};
  return all;
}

} // namespace

const std::vector<std::string>& dialogNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const auto& [name, open] : dialogs()) found.push_back(name);
    return found;
  }();
  return names;
}

void openDialog(const DialogOpeners& by, const std::string& name) {
  const auto found = std::ranges::find(dialogs(), name, &std::pair<std::string, Open>::first);
  found->second(by);
}

bool areDialogsComplete() {
  return std::ranges::all_of(QApplication::topLevelWidgets(), [](QWidget* dialog) {
    const auto* page = qobject_cast<ImportPage*>(dialog);
    return !page || page->isComplete();
  });
}

void paintDialogs(const QWidget& window, QPixmap& picture) {
  QPainter painter(&picture);
  for (QWidget* dialog : QApplication::topLevelWidgets()) {
    const bool isBeside = dialog->isVisible() && dialog != &window &&
                          (qobject_cast<QDialog*>(dialog) || dialog->windowType() == Qt::Popup);
    if (!isBeside) continue;
    QPoint place = dialog->mapToGlobal(QPoint()) - window.mapToGlobal(QPoint());
    // What is modal lies in the middle, wherever a platform without windows has put it.
    if (qobject_cast<QDialog*>(dialog))
      place = {(window.width() - dialog->width()) / 2, (window.height() - dialog->height()) / 2};
    painter.drawPixmap(place, dialog->grab());
    painter.setPen(QColor(128, 128, 128));
    painter.drawRect(QRect(place, dialog->size()).adjusted(-1, -1, 0, 0));
  }
}

} // namespace taa::app
