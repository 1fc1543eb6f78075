#include "app/session/PresetChoices.h"

#include "app/session/Outbox.h"
#include "app/session/UserPresets.h"
#include "app/style/Text.h"
#include "app/undo/UndoStack.h"
#include "core/base/OldNames.h"
#include "core/inspect/SceneSettings.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <utility>

namespace taa::app {

namespace {
constexpr int kStayMs = 60; // a mouse that only passes stays less
} // namespace

PresetChoices::PresetChoices(Outbox& outbox, UndoStack& undo) : outbox_(outbox), undo_(undo) {
  outbox_.guarded([&] {
    const Preset& first = builtinPresets().front();
    chosen_ = chosenInForce_ = {first.settings, first.settings, first.id};
    settings_ = Pending<Settings>(first.settings);
  });
  stays_.setSingleShot(true);
  stays_.setInterval(kStayMs);
  connect(&stays_, &QTimer::timeout, this, [this] { outbox_.post(request::Prepare{considered_}); });
}

bool PresetChoices::isPresetChanged() const {
  return !(chosen_.settings == chosen_.presetSettings);
}

void PresetChoices::arrived(const Settings& inForce, RequestId takenUp) {
  settings_.arrived(inForce, takenUp);
  if (settings_.waits()) return;
  if (chosen_.settings == settings_.value()) {
    chosenInForce_ = chosen_;
    return;
  }
  chosen_ = chosenInForce_;
  chosen_.settings = settings_.value();
  Q_EMIT settingsChanged();
}

void PresetChoices::use(const PresetChoice& choice) {
  if (choice == chosen_) return;
  stays_.stop();
  const bool isNew = !(choice.settings == chosen_.settings);
  chosen_ = choice;
  if (isNew) settings_.sent(choice.settings, outbox_.post(request::SetSettings{choice.settings}));
  Q_EMIT settingsChanged(); // also where only the preset's name is another
}

void PresetChoices::showScene(const std::string& source) {
  PresetChoice changed = chosen_;
  changed.settings = settingsForScene(chosen_.settings, std::exchange(scene_, source), source);
  use(changed);
}

void PresetChoices::change(const PresetChoice& choice, const QString& what, const std::string& key) {
  if (choice == chosen_) return;
  UndoStep step = stepBackTo<PresetChoice>(
      chosen_, [this] { return chosen_; },
      [this, scene = scene_](const PresetChoice& before) {
        PresetChoice now = before; // another scene may have been opened since
        now.settings = settingsForScene(before.settings, scene, scene_);
        use(now);
      });
  step.what = what;
  step.key = key;
  use(choice);
  undo_.push(std::move(step));
}

void PresetChoices::setParameter(const QString& path, double value) {
  outbox_.guarded([&] {
    const Parameter& row = parameter(path.toStdString());
    PresetChoice changed = chosen_;
    row.set(changed.settings, value);
    // Numbers are dragged; each choice is one of its own.
    const bool isNumber = row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer;
    change(changed, tr("change of %1").arg(qtext(row.label)),
           isNumber ? std::string(row.path) : std::string());
  });
}

void PresetChoices::assign(const std::vector<std::string>& assignments) {
  outbox_.guarded([&] {
    PresetChoice changed = chosen_;
    QStringList labels;
    for (const std::string& assignment : assignments) {
      applyAssignment(changed.settings, assignment);
      labels << qtext(parameter(assignment.substr(0, assignment.find('='))).label);
    }
    change(changed, tr("change of %1").arg(labels.join(QStringLiteral(", "))));
  });
}

void PresetChoices::setPreset(const QString& idOrPath) {
  outbox_.guarded([&] {
    const Preset preset = taa::preset(idOrPath.toStdString());
    change({preset.settings, preset.settings, preset.id}, tr("choice of preset %1").arg(qtext(preset.label)));
    sayNotes(preset.notes);
  });
}

void PresetChoices::consider(const Settings& settings) {
  considered_ = settings;
  stays_.start();
}

void PresetChoices::prepareParameter(const QString& path, double value) {
  outbox_.guarded([&] {
    Settings settings = chosen_.settings;
    parameter(path.toStdString()).set(settings, value);
    consider(settings);
  });
}

void PresetChoices::preparePreset(const QString& idOrPath) {
  outbox_.guarded([&] { consider(preset(idOrPath.toStdString()).settings); });
}

void PresetChoices::backToPreset() {
  change({chosen_.presetSettings, chosen_.presetSettings, chosen_.presetId}, tr("return to the preset"));
}

void PresetChoices::savePreset(const QString& folder, const QString& label) {
  outbox_.guarded([&] { setPreset(saveUserPreset(folder, label, chosen_.settings)); });
}

void PresetChoices::savePreset(const QString& folder, const QString& label, const Settings& settings) {
  outbox_.guarded([&] { saveUserPreset(folder, label, settings); });
}

void PresetChoices::setOtherPresets(const QStringList& idsOrPaths) {
  if (idsOrPaths == otherPresets_) return;
  otherPresets_ = idsOrPaths;
  outbox_.guarded([&] {
    std::vector<Settings> lanes;
    std::vector<std::string> notes;
    for (const QString& each : idsOrPaths) {
      const Preset other = preset(each.toStdString());
      lanes.push_back(other.settings);
      addNotes(notes, other.notes);
    }
    otherLanes_ = std::move(lanes);
    outbox_.post(request::SetOtherLanes{otherLanes_});
    sayNotes(notes);
  });
}

void PresetChoices::sayNotes(const std::vector<std::string>& notes) {
  if (!notes.empty()) Q_EMIT said(tr("The preset is of an earlier version: %1.").arg(clauses(notes)));
}

} // namespace taa::app
