// Presets, stages, shaders.
#include "app/menus/Menus.h"

#include "app/panels/PipelinePanel.h"
#include "app/session/UserPresets.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "app/window/Exports.h"
#include "app/window/MainWindow.h"
#include "core/settings/Presets.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

#include <string>

namespace taa::app {

void Menus::makePipeline() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Pipeline"));
  menu->setToolTipsVisible(true);
  Session& session = window_.session();
  QAction* taa =
      addCheck(menu, tr("&TAA, or the frames as they are drawn"), QKeySequence(QStringLiteral("Shift+T")),
               [&session](bool on) { session.setParameter(QStringLiteral("taa.enabled"), on ? 1.0 : 0.0); });
  onRefresh([&session, taa] { taa->setChecked(isTaaOn(session.settings())); });
  QMenu* presets = menu->addMenu(tr("&Preset"));
  presets->setToolTipsVisible(true);
  int number = 0;
  QMenu* listed = presets;
  for (const Preset& preset : builtinPresets()) {
    if (const PresetGroup* group = startedGroup(preset)) {
      listed = presets->addMenu(tableText(group->label));
      listed->setToolTipsVisible(true);
    }
    const QString id = QString::fromStdString(preset.id);
    const QList<QKeySequence> key =
        ++number <= 9 ? QList<QKeySequence>{QKeySequence(QStringLiteral("Ctrl+Alt+%1").arg(number))}
                      : QList<QKeySequence>();
    add(listed, tableText(preset.label), key, [&session, id] {
      session.setPreset(id);
    })->setToolTip(tableText(preset.description));
  }
  QMenu* own = menu->addMenu(tr("&My presets"));
  connect(own, &QMenu::aboutToShow, this, [this, own] {
    own->clear();
    for (const UserPreset& preset : userPresets(window_.presetFolder()))
      own->addAction(preset.label, this, [this, path = preset.path] { window_.session().setPreset(path); });
    if (own->isEmpty()) own->addAction(tr("None saved yet"))->setEnabled(false);
  });
  add(menu, tr("&Save as preset…"), keys({"Ctrl+Alt+S"}), [this] { window_.askForPresetName(); });
  add(menu, tr("&Compare, rename, delete presets…"), keys({"Ctrl+D"}), [this] { window_.comparePresets(); });
  add(menu, tr("Open a preset &file…"), keys({"Ctrl+Shift+O"}), [this] { window_.askForPresetFile(); });
  add(menu, tr("&Back to the preset"), keys({"Ctrl+R"}), [&session] { session.backToPreset(); });
  menu->addSeparator();
  add(menu, tr("&Unfold all stages"), keys({"Ctrl+Down"}),
      [this] { window_.pipeline()->setAllExpanded(true); });
  add(menu, tr("&Fold all stages"), keys({"Ctrl+Up"}), [this] { window_.pipeline()->setAllExpanded(false); });
  menu->addSeparator();
  makeReferences(menu->addMenu(tr("&Reference")));
  add(menu, tr("&Measure what each stage costs"), keys({"Shift+F11"}), [this] { window_.measureStages(); });
  add(menu, tr("Reload &shaders"), keys({"F5"}), [&session] { session.reloadShaders(); });
  add(menu, tr("Read &GLSL of the stage"), keys({"Shift+F5"}), [this] { window_.readGlsl(); });
  add(menu, tr("&Export GLSL…"), {}, [this] { window_.exports()->askForGlsl(); });
}

void Menus::makeReferences(QMenu* menu) {
  const auto addRow = [&](IntermediateId id, const QString& text, const char* key) {
    QAction* action = add(menu, text, keys({key}), [this, id] {
      const IntermediateId shown = window_.views()->active()->id();
      if (!isOfReference(shown)) beforeReference_ = shown;
      window_.showIntermediate(shown == id ? beforeReference_ : id, false);
    });
    action->setCheckable(true);
    onRefresh([this, action, id] { action->setChecked(window_.views()->active()->id() == id); });
  };
  addRow(IntermediateId::reference, tr("&Show the reference"), "U");
  addRow(IntermediateId::referenceError, tr("Show the &error against it"), "Shift+U");
  addRow(IntermediateId::referenceErrorAbs, tr("Show the &absolute error"), "Ctrl+U");
  menu->addSeparator();
  auto* group = new QActionGroup(this);
  for (const int samples : {4, 16, 64, 256, 1024}) {
    QAction* action = add(menu, tr("%1 samples in a pixel").arg(samples), {},
                          [this, samples] { window_.session().setReferenceSamples(samples); });
    action->setCheckable(true);
    group->addAction(action);
    onRefresh(
        [this, action, samples] { action->setChecked(window_.session().status().referenceGoal == samples); });
  }
}

} // namespace taa::app
