#include "app/commands/OwnPresets.h"

#include "app/dialogs/PresetsDialog.h"
#include "app/panels/PipelinePanel.h"
#include "app/session/Session.h"
#include "app/session/UserPresets.h"
#include "app/widgets/ConfirmReplace.h"
#include "app/widgets/Prompt.h"

#include <QApplication>
#include <QFileDialog>

namespace taa::app {

OwnPresets::OwnPresets(Session& session, PipelinePanel& pipeline, const QSettings* settings, QWidget* window)
    : QObject(window), session_(session), pipeline_(pipeline), folder_(userPresetFolder(settings)),
      window_(window) {
  connect(&pipeline_, &PipelinePanel::comparisonRequested, this, &OwnPresets::compare);
  list();
}

void OwnPresets::list() {
  pipeline_.setUserPresets(userPresets(folder_));
}

void OwnPresets::ask(const QString& question, const std::function<void(const QString& label)>& save) {
  // Over the dialog that asks for it, if there is one.
  QWidget* over = QApplication::activeWindow() ? QApplication::activeWindow() : window_;
  auto* prompt = new Prompt(
      question, {},
      [this, save](const QString& text) {
        if (text.trimmed().isEmpty()) return false;
        confirmReplace(window_, {userPresetPath(folder_, text).toStdString()}, [this, save, text] {
          save(text);
          list();
        });
        return true;
      },
      over);
  prompt->open();
}

void OwnPresets::askForName() {
  ask(tr("Save these settings as"),
      [this](const QString& label) { session_.presets().savePreset(folder_, label); });
}

void OwnPresets::askForNameOf(const Settings& settings) {
  ask(tr("Save what was found as"),
      [this, settings](const QString& label) { session_.presets().savePreset(folder_, label, settings); });
}

void OwnPresets::askForFile() {
  auto* dialog = new QFileDialog(window_, tr("Open a preset"), folder_, tr("Presets (*.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, &session_.presets(), &PresetChoices::setPreset);
  dialog->open();
}

void OwnPresets::compare() {
  auto* dialog = new PresetsDialog(session_, folder_, window_);
  connect(dialog, &PresetsDialog::userPresetsChanged, this, &OwnPresets::list);
  dialog->open();
}

} // namespace taa::app
