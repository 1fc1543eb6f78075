#include "app/menus/PipelineMenu.h"

#include "app/commands/Exports.h"
#include "app/commands/LadderSteps.h"
#include "app/commands/OwnPresets.h"
#include "app/commands/Tune.h"
#include "app/dialogs/GlslWindow.h"
#include "app/dialogs/SweepDialog.h"
#include "app/panels/LowerArea.h"
#include "app/panels/PipelinePanel.h"
#include "app/session/Session.h"
#include "app/session/UserPresets.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "core/settings/Presets.h"

#include <QAction>
#include <QActionGroup>

namespace taa::app {

PipelineMenu::PipelineMenu(Commands& commands, const Targets& on, QWidget* parent)
    : CommandMenu(tr("&Pipeline"), commands, parent) {
  setToolTipsVisible(true);
  Session& session = on.session;
  QAction* taa = addCheck(tr("&TAA, or the frames as they are drawn"),
                          QKeySequence(QStringLiteral("Shift+T")), [&session](bool isOn) {
                            session.presets().setParameter(QStringLiteral("taa.enabled"), isOn ? 1.0 : 0.0);
                          });
  onRefresh([&session, taa] { taa->setChecked(isTaaOn(session.presets().settings())); });
  addPresets(session);
  addRungs(on.ladder);
  addOwnPresets(session, on.presets, on.exports);
  add(tr("&Back to the preset"), keys({"Ctrl+R"}), [&session] { session.presets().backToPreset(); });
  addSeparator();
  add(tr("&Unfold all stages"), keys({"Ctrl+Down"}),
      [&pipeline = on.pipeline] { pipeline.setAllExpanded(true); });
  add(tr("&Fold all stages"), keys({"Ctrl+Up"}),
      [&pipeline = on.pipeline] { pipeline.setAllExpanded(false); });
  addSeparator();
  addReferences(session, on.views);
  addShaders(on);
}

void PipelineMenu::addPresets(Session& session) {
  QMenu* presets = addMenu(tr("&Preset"));
  presets->setToolTipsVisible(true);
  int number = 0;
  QMenu* listed = presets;
  for (const Preset& preset : builtinPresets()) {
    if (const PresetGroup* group = startedGroup(preset)) {
      listed = presets->addMenu(qtext(group->label));
      listed->setToolTipsVisible(true);
    }
    const QString id = QString::fromStdString(preset.id);
    const QList<QKeySequence> key =
        ++number <= 9 ? QList<QKeySequence>{QKeySequence(QStringLiteral("Ctrl+Alt+%1").arg(number))}
                      : QList<QKeySequence>();
    commands_.add(listed, qtext(preset.label), key, [&session, id] { session.presets().setPreset(id); })
        ->setToolTip(qtext(preset.description));
  }
}

void PipelineMenu::addRungs(LadderSteps& ladder) {
  QAction* next =
      add(tr("&Next rung of the source's ladder"), keys({"Ctrl+PgDown"}), [&ladder] { ladder.stepBy(1); });
  QAction* previous =
      add(tr("Pre&vious rung of the source's ladder"), keys({"Ctrl+PgUp"}), [&ladder] { ladder.stepBy(-1); });
  onRefresh([&ladder, next, previous] {
    allow(next, ladder.whyNot(1));
    allow(previous, ladder.whyNot(-1));
  });
}

void PipelineMenu::addOwnPresets(Session& session, OwnPresets& presets, Exports& exports) {
  QMenu* menu = addMenu(tr("&My presets"));
  connect(menu, &QMenu::aboutToShow, this, [this, menu, &session, &presets] {
    menu->clear();
    for (const UserPreset& preset : userPresets(presets.folder()))
      menu->addAction(preset.label, this,
                      [&session, path = preset.path] { session.presets().setPreset(path); });
    if (menu->isEmpty()) menu->addAction(tr("None saved yet"))->setEnabled(false);
  });
  add(tr("&Save as preset…"), keys({"Ctrl+Alt+S"}), [&presets] { presets.askForName(); });
  add(tr("&Compare, rename, delete presets…"), keys({"Ctrl+D"}), [&presets] { presets.compare(); });
  add(tr("S&weep: compare settings by numbers…"), keys({"Ctrl+Alt+W"}),
      [&session, &presets, window = parentWidget()->window()] {
        SweepDialog::openAt(session, presets.folder(), window);
      });
  add(tr("&Tune: look for better settings…"), keys({"Ctrl+Alt+U"}),
      [&session, &presets, &exports, window = parentWidget()->window()] {
        openTune(session, presets, exports, window);
      });
  add(tr("Open a preset &file…"), keys({"Ctrl+Shift+O"}), [&presets] { presets.askForFile(); });
}

void PipelineMenu::addShaders(const Targets& on) {
  Session& session = on.session;
  add(tr("&Measure what each stage costs"), keys({"Shift+F11"}), [&session, &lower = on.lower] {
    lower.setShown(LowerPage::Profiler, true);
    session.post(request::MeasureStages{});
  });
  add(tr("Reload &shaders"), keys({"F5"}), [&session] { session.post(request::ReloadShaders{}); });
  add(tr("Read &GLSL of the stage"), keys({"Shift+F5"}),
      [&session, &views = on.views, window = parentWidget()->window()] {
        GlslWindow::openAt(session, intermediate(views.active()->id()).stage, window);
      });
  add(tr("&Export GLSL…"), {}, [&exports = on.exports] { exports.askForGlsl(); });
}

void PipelineMenu::addReferences(Session& session, ViewArea& views) {
  QMenu* menu = addMenu(tr("&Reference"));
  addReferenceRow(menu, views, IntermediateId::reference, tr("&Show the reference"), "U");
  addReferenceRow(menu, views, IntermediateId::referenceError, tr("Show the &error against it"), "Shift+U");
  addReferenceRow(menu, views, IntermediateId::referenceErrorAbs, tr("Show the &absolute error"), "Ctrl+U");
  menu->addSeparator();
  auto* group = new QActionGroup(this);
  for (const int samples : {4, 16, 64, 256, 1024}) {
    QAction* action = commands_.add(menu, tr("%1 samples in a pixel").arg(samples), {}, [&session, samples] {
      session.post(request::SetReferenceSamples{samples});
    });
    action->setCheckable(true);
    group->addAction(action);
    onRefresh([&session, action, samples] { action->setChecked(session.status().referenceGoal == samples); });
  }
}

void PipelineMenu::addReferenceRow(QMenu* menu, ViewArea& views, IntermediateId id, const QString& text,
                                   const char* key) {
  QAction* action = commands_.add(menu, text, keys({key}), [this, &views, id] {
    const IntermediateId shown = views.active()->id();
    if (!isOfReference(shown)) beforeReference_ = shown;
    views.active()->setIntermediate(shown == id ? beforeReference_ : id);
  });
  action->setCheckable(true);
  onRefresh([&views, action, id] { action->setChecked(views.active()->id() == id); });
}

} // namespace taa::app
