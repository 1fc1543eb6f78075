#include "app/commands/OwnPresets.h"

#include "app/dialogs/PresetsDialog.h"
#include "app/panels/PipelinePanel.h"
#include "app/session/Session.h"
#include "app/session/UserPresets.h"
#include "app/widgets/ConfirmReplace.h"
#include "app/widgets/Prompt.h"

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

void OwnPresets::askForName() {
  auto* prompt = new Prompt(
      tr("Save these settings as"), {},
      [this](const QString& text) {
        if (text.trimmed().isEmpty()) return false;
        confirmReplace(window_, {userPresetPath(folder_, text).toStdString()}, [this, text] {
          session_.presets().savePreset(folder_, text);
          list();
        });
        return true;
      },
      window_);
  prompt->open();
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
